//! Scenes that are part of the program.

/// The name and scene file of each built-in scene.
const SCENES: [(&str, &str); 7] = [
    ("teapot", include_str!("../../scenes/teapot.toml")),
    ("spheres", include_str!("../../scenes/spheres.toml")),
    ("torus", include_str!("../../scenes/torus.toml")),
    ("icosahedron", include_str!("../../scenes/icosahedron.toml")),
    ("lamps", include_str!("../../scenes/lamps.toml")),
    ("turntable", include_str!("../../scenes/turntable.toml")),
    ("sunrise", include_str!("../../scenes/sunrise.toml")),
];

const NAMES: [&str; SCENES.len()] = {
    let mut names = [""; SCENES.len()];
    let mut k = 0;
    while k < SCENES.len() {
        names[k] = SCENES[k].0;
        k += 1;
    }
    names
};

/// The names of the built-in scenes.
pub fn builtin_names() -> &'static [&'static str] {
    &NAMES
}

/// The scene file of a built-in scene.
pub fn builtin_text(name: &str) -> Option<&'static str> {
    SCENES.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}
