//! What inputs tell of a scene, by their names, of which every method makes the same use.

/// What an input tells of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Where lights are, and what is worked out from that alone.
    Light,
    /// Exponents of highlights.
    Exponent,
    /// Ambient light sent back.
    Ambient,
    /// Diffuse coefficients.
    Diffuse,
    /// Specular coefficients.
    Specular,
    /// The surface, from span to span.
    Surface,
}

impl Subject {
    /// Every subject.
    pub const ALL: [Subject; 6] = [
        Subject::Light,
        Subject::Exponent,
        Subject::Ambient,
        Subject::Diffuse,
        Subject::Specular,
        Subject::Surface,
    ];

    /// What the input `name` tells of.
    pub fn of(name: &str) -> Subject {
        let (stem, last) = name.rsplit_once('_').unwrap_or(("", name));
        let is_channel = matches!(last, "r" | "g" | "b");
        let constant_vector =
            ["_direction", "_halfway", "_axis"].iter().any(|end| stem.ends_with(end))
                && !is_channel;
        let of_lights = constant_vector && matches!(last, "x" | "y" | "z");
        let scalar = ["dot_view", "halfway_gain"].iter().any(|end| name.ends_with(end));
        match name {
            _ if is_channel && stem == "ambient" => Subject::Ambient,
            _ if is_channel && stem.ends_with("_diffuse") => Subject::Diffuse,
            _ if is_channel && stem.ends_with("_specular") => Subject::Specular,
            "shininess" | "root_shininess" | "exponent" | "log2_exponent" => Subject::Exponent,
            _ if name.starts_with("light")
                && (of_lights || scalar || name.ends_with("_exponent")) =>
            {
                Subject::Light
            }
            _ => Subject::Surface,
        }
    }

    /// Its name for people.
    pub const fn in_words(self) -> &'static str {
        match self {
            Subject::Light => "directions of lights",
            Subject::Exponent => "exponents of materials",
            Subject::Ambient => "ambient light",
            Subject::Diffuse => "diffuse colours",
            Subject::Specular => "specular colours",
            Subject::Surface => "what changes along spans",
        }
    }
}
