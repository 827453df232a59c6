//! Cores as scene files ask for them.
use specula_scene::{SceneError, parse};
use specula_spec::{CoreError, Method, SceneCore};

/// A span under a light and an eye at places.
const SPAN: &str = r#"
[camera]
viewer = "local"
eye = [1, 2, 3]
target = [0, 0, 0]
[[light]]
kind = "point"
position = [0.5, 0, 2]
[[span]]
length = 5
normals = [[0, 0, 1], [0.6, 0, 0.8]]
"#;

#[test]
fn a_core_can_be_asked_for() {
    let text = format!("{SPAN}\n[core]\nmethod = \"phong\"\n");
    let spec = parse("spans.toml", text).expect("the scene is right").core_spec(None);
    assert_eq!(spec.expect("phong shades it").method(), Method::Phong);
}

#[test]
fn what_no_core_has_is_pointed_at() {
    for (table, wrong, place) in [
        ("method = \"flong\"", "there is no method `flong`", "[core]"),
        ("[core.lyon]\nsquarings = 9", "`squarings` is 9", "[core]"),
        ("specialise = \"everything\"", "unknown variant `everything`", "\"everything\""),
    ] {
        let text = format!("{SPAN}\n[core]\nmethod = \"lyon\"\n{table}\n")
            .replace("method = \"lyon\"\nmethod", "method");
        let scene = parse("spans.toml", text.clone()).expect("the scene is right");
        match scene.core_spec(None) {
            Err(CoreError::Scene(SceneError::File { problem, at, .. })) => {
                assert!(problem.contains(wrong), "{problem}");
                assert!(text[at.offset()..].starts_with(place), "{}", &text[at.offset()..]);
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn without_a_table_no_place_is_pointed_at() {
    let text = SPAN.replace("[[span]]", "[[span]]\nmaterial = { shininess = 3 }");
    let table = "\n[core.hybrid]\npower = \"squaring\"\n";
    let scene = |text: String| parse("spans.toml", text).expect("the scene is right");
    let asked = scene(text.clone() + table).core_spec(Some(Method::Hybrid));
    assert!(matches!(asked, Err(CoreError::Scene(SceneError::File { .. }))), "{asked:?}");
    let mut without = scene(text);
    without.frame.lights.clear();
    without.frame.local_lights.clear();
    let none = without.core_spec(Some(Method::Hybrid));
    assert!(matches!(none, Err(CoreError::Spec(_))), "{none:?}");
}
