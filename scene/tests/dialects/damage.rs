//! Damaged files: an error or a mesh, never a panic, and never much memory or time.
use std::path::Path;

use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};
use specula_scene::mesh::{MeshProblem, Model};

use crate::glb_files::{self, Glb};
use crate::shape::wedge;
use crate::{obj_files, ply_files, said, stl_files};

fn seeds() -> Vec<(String, Vec<u8>)> {
    [glb_seeds(), texts()].concat()
}

/// Seeds in JSON and bytes.
fn glb_seeds() -> Vec<(String, Vec<u8>)> {
    let staged = ("staged.glb".to_owned(), said::staged());
    [glb_files::dialects(&wedge()), vec![staged]].concat()
}

/// Seeds of formats that are, or may be, text.
fn texts() -> Vec<(String, Vec<u8>)> {
    [obj_files::dialects(&wedge()), ply_files::dialects(&wedge()), stl_files::dialects(&wedge())]
        .concat()
}

fn try_to_read(name: &str, bytes: &[u8]) {
    let none = |_: &Path| Err(MeshProblem::Unreadable("it is not given".into()));
    let _ = Model::from_bytes(Path::new(name), bytes, &none);
}

#[test]
fn files_cut_off_anywhere_do_not_panic() {
    for (name, bytes) in seeds() {
        (0..bytes.len()).for_each(|length| try_to_read(&name, &bytes[..length]));
    }
}

#[test]
fn single_wrong_bytes_do_not_panic() {
    for (name, bytes) in seeds() {
        for at in 0..bytes.len() {
            for wrong in [0xff, b'-', bytes[at] ^ 1] {
                let mut damaged = bytes.clone();
                damaged[at] = wrong;
                try_to_read(&name, &damaged);
            }
        }
    }
}

/// Paths of all values in some JSON.
fn paths(value: &Value, path: &str, all: &mut Vec<String>) {
    all.push(path.to_owned());
    match value {
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, value)| paths(value, &format!("{path}/{k}"), all))
        }
        Value::Object(map) => {
            map.iter().for_each(|(key, value)| paths(value, &format!("{path}/{key}"), all))
        }
        _ => {}
    }
}

/// Each value of the JSON of each dialect replaced by some that are apt to hurt, so that what is
/// behind the JSON is reached.
#[test]
fn wrong_values_in_json_do_not_panic() {
    let hostile = [
        json!(null),
        json!(-1),
        json!(0),
        json!(1),
        json!(255),
        json!(5121),
        json!(u32::MAX),
        json!(u64::MAX),
        json!(1e300),
        json!("x"),
        json!([]),
        json!([0, 0]),
        json!({}),
    ];
    for (name, bytes) in glb_seeds() {
        let length = u32::from_le_bytes([bytes[12], bytes[13], bytes[14], bytes[15]]) as usize;
        let Ok(root) = serde_json::from_slice::<Value>(&bytes[20..20 + length]) else { continue };
        let binary = bytes.get(28 + length..).unwrap_or_default().to_vec();
        let mut all = Vec::new();
        paths(&root, "", &mut all);
        for path in &all {
            for wrong in &hostile {
                let mut glb = Glb { root: root.clone(), bytes: binary.clone() };
                *glb.root.pointer_mut(path).expect("it is there") = wrong.clone();
                try_to_read(&name, &glb.file());
            }
        }
    }
}

/// Each word of each text file replaced by some that are apt to hurt.
#[test]
fn wrong_words_in_text_do_not_panic() {
    let hostile = [
        "",
        "-1",
        "0",
        "4294967295",
        "18446744073709551616",
        "nan",
        "1e999",
        "0x1p99999",
        "list",
        "double",
        "vertex_indices",
        "end_header\n",
        "\\\n",
        "endloop",
        "solid",
        "v",
        "1//0",
    ];
    for (name, bytes) in texts() {
        let is_blank = |k: &usize| bytes[*k].is_ascii_whitespace();
        let ends: Vec<usize> = (0..bytes.len()).filter(is_blank).collect();
        for word in ends.windows(2) {
            for wrong in hostile {
                try_to_read(
                    &name,
                    &[&bytes[..word[0] + 1], wrong.as_bytes(), &bytes[word[1]..]].concat(),
                );
            }
        }
    }
}

#[test]
fn damaged_files_do_not_panic() {
    let seeds = seeds();
    let strategy = (
        any::<Index>(),
        prop::collection::vec((any::<Index>(), any::<u8>()), 1..8),
        prop::option::of(any::<Index>()),
    );
    let tried =
        TestRunner::new(ProptestConfig::with_cases(2000)).run(&strategy, |(file, flips, cut)| {
            let (name, mut bytes) = seeds[file.index(seeds.len())].clone();
            for (at, byte) in flips {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            let length = cut.map_or(bytes.len(), |cut| cut.index(bytes.len()));
            try_to_read(&name, &bytes[..length]);
            Ok(())
        });
    tried.unwrap_or_else(|error| panic!("{error}"));
}
