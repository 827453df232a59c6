//! What a newcomer begins with: a scene file, a shell's completions, pages for `man`.
use crate::program::Place;

#[test]
fn a_new_scene_is_a_scene_with_a_core() {
    let place = Place::new();
    let said = place.succeeds(&["new", "donut"]);
    assert_eq!(
        said,
        "donut.toml: a torus under one light; `specula run donut.toml` makes its core\n"
    );
    let made = place.specula(&["generate", "donut.toml", "-o", "core"]);
    assert!(made.status == Some(0) && made.stderr.starts_with("method: "), "{}", made.stderr);
    assert!(place.path("core").join("spec.toml").is_file());
    let again = place.specula(&["new", "donut.toml"]);
    assert_eq!(again.status, Some(2));
    assert!(again.stderr.contains("donut.toml is there already"), "{}", again.stderr);
    for wrong in ["donut.obj", ".."] {
        assert_eq!(place.specula(&["new", wrong]).status, Some(2), "{wrong}");
    }
}

/// Options for one method say which it is; a method that is open is chosen, and the command says so.
#[test]
fn a_scene_without_a_method_is_given_one() {
    let place = Place::new();
    let torus = "[[object]]\nprimitive = \"torus\"\nlevel = 6\n";
    place.write("one.toml", format!("{torus}[core.slerp]\npower = \"squaring\"\n"));
    place.succeeds(&["run", "one.toml", "--size", "48x36"]);
    assert_eq!(place.report("out/one")["method"], "slerp");
    place.write("none.toml", torus);
    let ended = place.specula(&["run", "none.toml", "--size", "48x36"]);
    assert!(ended.status == Some(0) && ended.stderr.starts_with("method: "), "{}", ended.stderr);
    let command = place.report("out/none")["command"].clone();
    assert_eq!(command, "specula generate none.toml --size 48x36 --method auto");
}

/// Every key that the new file has in a comment is one that a scene may have.
#[test]
fn what_a_new_scene_has_in_comments_is_allowed_too() {
    let place = Place::new();
    place.succeeds(&["new", "donut"]);
    let text = std::fs::read_to_string(place.path("donut.toml")).expect("it has been written");
    let commented = |line: &&str| line.starts_with("# [") || line.split(' ').nth(2) == Some("=");
    let keys: Vec<&str> =
        text.lines().filter(commented).filter_map(|line| line.strip_prefix("# ")).collect();
    assert!(keys.contains(&"height = 3.0") && keys.len() > 6, "{keys:?}");
    let all = keys.iter().fold(text.clone(), |text, key| text.replace(&format!("# {key}"), key));
    // A point light has no direction.
    place.write("all.toml", all.replace("direction = [-0.5", "# direction = [-0.5"));
    let made = place.specula(&["generate", "all.toml", "-o", "core"]);
    assert!(made.status == Some(0) && made.stderr.starts_with("method: "), "{}", made.stderr);
}

#[test]
fn the_file_of_a_built_in_scene_makes_the_same_core() {
    let place = Place::new();
    place.write("lamps.toml", place.succeeds(&["scenes", "--show", "lamps"]));
    place.succeeds(&["generate", "lamps.toml", "-o", "file"]);
    place.succeeds(&["generate", "lamps", "-o", "name"]);
    let spec = |folder: &str| std::fs::read(place.path(folder).join("spec.toml")).ok();
    assert!(spec("file").is_some());
    assert_eq!(spec("file"), spec("name"));
    assert_eq!(place.specula(&["scenes", "--show", "kettle"]).status, Some(2));
}

#[test]
fn shells_and_man_know_every_command() {
    let place = Place::new();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = place.succeeds(&["completions", shell]);
        assert!(script.contains("schedule") && script.contains("max-error"), "{script}");
    }
    assert!(place.succeeds(&["manual"]).contains("specula\\-run(1)"));
    let page = place.succeeds(&["manual", "run"]);
    assert!(page.contains("specula\\-run") && page.contains("\\-\\-max\\-error"), "{page}");
    let wrong = place.specula(&["manual", "walk"]);
    assert_eq!(wrong.status, Some(2));
    assert!(wrong.stderr.contains("no subcommand `walk`"), "{}", wrong.stderr);
}
