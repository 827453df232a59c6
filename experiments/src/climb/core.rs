//! The `[core]` table of a genome.
use std::fmt::Write;

use specula_scene::Needs;
use specula_spec::{
    CoreOptions, CoreSpec, Format, LightPipelines, Method, NarrowingPoint, SpecError, Specialise,
};

/// How often formats that depend on one another are repaired before a core is given up.
const MAX_REPAIRS: usize = 60;

/// A method, the options and formats that differ from its defaults, and the other keys of a
/// `[core]` table.
#[derive(Clone, Debug)]
pub struct CoreChoice {
    /// The method.
    pub method: Method,
    /// Options that differ from their defaults: keys and values as TOML writes them.
    pub options: Vec<(&'static str, &'static str)>,
    /// Formats that differ from their defaults, by narrowing point.
    pub formats: Vec<(&'static str, Format)>,
    /// How lights share pipelines.
    pub light_pipelines: LightPipelines,
    /// The scenes for which the core is made.
    pub specialise: Specialise,
    /// The narrowing points that the core had when it was last repaired.
    pub points: Vec<NarrowingPoint>,
}

impl CoreChoice {
    /// A method with its defaults.
    pub fn default_of(method: Method) -> CoreChoice {
        CoreChoice {
            method,
            options: Vec::new(),
            formats: Vec::new(),
            light_pipelines: LightPipelines::Each,
            specialise: Specialise::Scene,
            points: Vec::new(),
        }
    }

    /// Sets an option.
    pub fn set_option(&mut self, key: &'static str, value: &'static str) {
        self.options.retain(|(other, _)| *other != key);
        self.options.push((key, value));
    }

    /// Sets a format.
    pub fn set_format(&mut self, name: &'static str, format: Format) {
        self.formats.retain(|(other, _)| *other != name);
        self.formats.push((name, format));
    }

    /// The `[core]` tables of a scene file.
    pub fn text(&self) -> String {
        format!("[core]\n{}", self.tables("core."))
    }

    /// The contents of the `[core]` table; `prefix` precedes names of tables.
    fn tables(&self, prefix: &str) -> String {
        let name = self.method.name();
        let (pipelines, specialise) = (self.light_pipelines.name(), self.specialise.name());
        let mut text = format!(
            "method = \"{name}\"\nlight_pipelines = \"{pipelines}\"\nspecialise = \"{specialise}\"\nformats = \"recommended\"\n"
        );
        // Writing to a String cannot fail.
        let _ = writeln!(text, "\n[{prefix}{name}]");
        self.options.iter().for_each(|(key, value)| _ = writeln!(text, "{key} = {value}"));
        let _ = writeln!(text, "\n[{prefix}{name}.formats]");
        self.formats.iter().for_each(|(name, format)| _ = writeln!(text, "{name} = \"{format}\""));
        text
    }

    /// Repairs options and formats so that they fit the scene's needs and one another, and records
    /// the narrowing points; `None` if there is no such core.
    pub fn repaired(mut self, needs: &Needs) -> Option<CoreChoice> {
        for _ in 0..MAX_REPAIRS {
            let options: CoreOptions = self.tables("").parse().ok()?;
            match CoreSpec::for_scene(needs, Some(&options), None) {
                Ok(spec) => {
                    self.points = spec.narrowing_points();
                    let is_used = |name: &str| self.points.iter().any(|point| point.name == name);
                    self.formats.retain(|(name, _)| is_used(name));
                    return Some(self);
                }
                Err(error) => self.repair(&error)?,
            }
        }
        None
    }

    fn repair(&mut self, error: &SpecError) -> Option<()> {
        match error {
            SpecError::WrongFormat {
                name,
                given,
                wanted,
                fewest_fraction_bits,
                most_fraction_bits,
            } => {
                // The format is followed by the reason, if there is one.
                let shape: Format = wanted.split(',').next()?.parse().ok()?;
                let most = *most_fraction_bits.max(fewest_fraction_bits);
                let fraction_bits = given.fraction_bits.clamp(*fewest_fraction_bits, most);
                self.set_format(name, Format { fraction_bits, ..shape });
                Some(())
            }
            SpecError::UnevenShininess { .. } => {
                let before = self.options.len();
                self.options.retain(|(key, _)| *key != "power");
                (self.options.len() < before).then_some(())
            }
            _ => None,
        }
    }
}
