//! Wrong inputs and what is said about them: each file in `tests/errors/` is loaded as a scene, and
//! the diagnostic compared with the `.snap` beside it. Adding a test is adding a file.
use std::fs;
use std::path::{Path, PathBuf};

use miette::NarratableReportHandler;
use specula_scene::{SceneError, load};

/// The diagnostic as plain text.
fn rendered(error: &SceneError) -> String {
    let mut text = String::new();
    NarratableReportHandler::new()
        .render_report(&mut text, error)
        .expect("writing to a string does not fail");
    text
}

/// Loads a scene that has to be wrong.
fn diagnostic(scene: &str, size: Option<(u32, u32)>) -> String {
    match load(scene, size) {
        Ok(_) => panic!("{scene} was loaded"),
        Err(error) => rendered(&error),
    }
}

fn wrong_files() -> Vec<PathBuf> {
    let entries = fs::read_dir("tests/errors").expect("tests run in the crate's folder");
    let paths = entries.map(|entry| entry.expect("the folder can be listed").path());
    let mut files: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|e| e != "snap")).collect();
    files.sort();
    files
}

fn name(path: &Path) -> &str {
    path.file_name().and_then(|name| name.to_str()).expect("test files have plain names")
}

#[test]
fn wrong_files_are_refused_with_a_clear_word() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("errors");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for path in wrong_files() {
            let shown = path.to_str().expect("test files have plain names").replace('\\', "/");
            insta::assert_snapshot!(name(&path), diagnostic(&shown, None));
        }
    });
}

#[test]
fn scenes_that_are_not_there_are_refused() {
    let scenes = [
        "teacup",
        "",
        "bunny.off",
        "tests/errors/none.toml",
        "tests/errors/none.ply",
        "tests/errors",
        "a\u{0}b.obj",
    ];
    let all: Vec<String> = scenes.iter().map(|scene| diagnostic(scene, None)).collect();
    insta::assert_snapshot!(all.join("\n"));
}

#[test]
fn sizes_that_cannot_be_are_refused() {
    let sizes = [(0, 0), (0, 480), (100_000, 100_000), (8193, 1), (u32::MAX, u32::MAX)];
    let all: Vec<String> = sizes.iter().map(|&size| diagnostic("teapot", Some(size))).collect();
    insta::assert_snapshot!(all.join("\n"));
}
