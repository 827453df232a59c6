//! What can be wrong with a spec.
use specula_datapath::Format;

/// Why there is no core for this scene and these wishes.
#[derive(Debug, Clone, PartialEq, thiserror::Error, miette::Diagnostic)]
pub enum SpecError {
    /// No method has that name.
    #[error("there is no method `{name}`")]
    #[diagnostic(code(specula::spec::method), help("`specula methods` lists them: {known}"))]
    UnknownMethod {
        /// The name given.
        name: String,
        /// The names there are.
        known: String,
    },
    /// No target with known delays has that name.
    #[error("there is no target `{name}` with a clock")]
    #[diagnostic(code(specula::spec::target), help("there are {known}"))]
    UnknownTarget {
        /// The name given.
        name: String,
        /// The names there are.
        known: String,
    },
    /// The power by squaring takes powers of two only.
    #[error(
        "the method `{method}` raises to n = 2^j by squaring, and a material has shininess {shininess}"
    )]
    #[diagnostic(
        code(specula::spec::shininess),
        help(
            "leave `power` out of [core.{method}], or set it to \"tables\", which take any n; else use shininess {below} or {above}"
        )
    )]
    UnevenShininess {
        /// The method's name.
        method: &'static str,
        /// The exponent.
        shininess: u32,
        /// The next smaller power of two.
        below: u32,
        /// The next larger power of two.
        above: u32,
    },
    /// A number is outside what cores can be built for.
    #[error("`{name}` is {value}, outside {low} to {high}")]
    #[diagnostic(code(specula::spec::range), help("give a value from {low} to {high}"))]
    OutOfRange {
        /// What it is.
        name: &'static str,
        /// The value given.
        value: f64,
        /// Smallest value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// A format does not fit what it is to hold.
    #[error("format `{name}` is {given}, which cannot hold what it is for")]
    #[diagnostic(
        code(specula::spec::format),
        help("write {wanted}, with {fewest_fraction_bits} to {most_fraction_bits} fraction bits")
    )]
    WrongFormat {
        /// The narrowing point.
        name: &'static str,
        /// The format given.
        given: Format,
        /// The shape needed, such as `S1.f`.
        wanted: String,
        /// The fewest fraction bits.
        fewest_fraction_bits: u32,
        /// The most fraction bits.
        most_fraction_bits: u32,
    },
    /// What an input is said to be given does not fit.
    #[error("input `{name}` of the core: {wrong}")]
    #[diagnostic(
        code(specula::spec::specialisation),
        help(
            "give raw values, smallest and largest, or the name of an earlier input of the same format"
        )
    )]
    Specialisation {
        /// The input.
        name: String,
        /// What is wrong.
        wrong: String,
    },
    /// A core that is there lacks what a scene needs.
    #[error("{has}, and the scene {needs}")]
    #[diagnostic(
        code(specula::spec::lacks),
        help(
            "let `specula run` build a core for this scene, or give a general one (`--specialise general`) of a scene with as much"
        )
    )]
    Lacks {
        /// What the core has.
        has: String,
        /// What the scene has or does.
        needs: String,
    },
    /// The `[core]` table of a scene file does not fit.
    #[error("the [core] table is wrong: {message}")]
    #[diagnostic(
        code(specula::spec::core),
        help("docs/scene-format.md lists the keys of [core] and their values")
    )]
    Core {
        /// What is wrong.
        message: String,
    },
}

impl SpecError {
    /// What would be right.
    pub(crate) fn help_text(&self) -> String {
        miette::Diagnostic::help(self).map(|help| help.to_string()).unwrap_or_default()
    }
}

/// Whether a number is one that cores can be built for.
pub(crate) fn within(name: &'static str, value: f64, low: f64, high: f64) -> Result<(), SpecError> {
    if (low..=high).contains(&value) {
        Ok(())
    } else {
        Err(SpecError::OutOfRange { name, value, low, high })
    }
}
