//! Stereolithography files.
use crate::shape::wedge;
use crate::{check_dialects, read, stl_files};

#[test]
fn every_dialect_gives_the_mesh_and_the_picture_of_the_plain_file() {
    check_dialects(&stl_files::dialects(&wedge()));
}

/// What is passed over is told once, with its line, and nothing else is.
#[test]
fn what_is_left_out_is_told_once() {
    let all = stl_files::dialects(&wedge());
    let said =
        all.iter().map(|(name, bytes)| read(name, bytes).1).filter(|warnings| !warnings.is_empty());
    let said: Vec<String> = said.map(|warnings| warnings.join("\n")).collect();
    insta::assert_snapshot!(said.join("\n"));
}
