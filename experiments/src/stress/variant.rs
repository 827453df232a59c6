//! Methods with their options.
use specula_scene::Needs;
use specula_spec::{CoreOptions, CoreSpec, Method, SpecError};

/// A method with options and formats that differ from its defaults.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The method.
    pub method: Method,
    /// The lines of its table in a scene file's `[core]`.
    pub table: String,
}

impl Variant {
    /// A method with its defaults.
    pub fn default_of(method: Method) -> Variant {
        Variant { method, table: String::new() }
    }

    /// The default, and each value of each option by itself.
    pub fn all_of(method: Method) -> Vec<Variant> {
        let values = |choice: &'static specula_spec::OptionDomain| {
            choice.values.iter().map(|value| (choice.key, *value))
        };
        let one = |(key, value)| Variant { method, table: format!("{key} = {value}\n") };
        let changed = method.option_domains().iter().flat_map(values).map(one);
        [Variant::default_of(method)].into_iter().chain(changed).collect()
    }

    /// The `[core]` table for it, with which `run` makes the same core.
    pub fn core(&self) -> String {
        let name = self.method.name();
        format!(
            "[core]\nmethod = \"{name}\"\nformats = \"recommended\"\n\n[core.{name}]\n{}",
            self.table
        )
    }

    /// The options as the program reads them.
    ///
    /// # Errors
    /// [`SpecError::Core`] if the table is invalid.
    pub fn options(&self) -> Result<CoreOptions, SpecError> {
        let name = self.method.name();
        format!("method = \"{name}\"\n\n[{name}]\n{}", self.table).parse()
    }

    /// Its general core for these needs.
    ///
    /// # Errors
    /// [`SpecError`] if the table is invalid, or if the method with these options cannot satisfy
    /// the needs.
    pub fn core_spec(&self, needs: &Needs) -> Result<CoreSpec, SpecError> {
        CoreSpec::for_scene(needs, Some(&self.options()?), Some(self.method))
    }

    /// Text that names the method and the options that differ.
    pub fn describe(&self) -> String {
        let changes: Vec<&str> = self.table.lines().collect();
        match changes[..] {
            [] => self.method.name().to_owned(),
            _ => format!("{} ({})", self.method.name(), changes.join(", ")),
        }
    }
}
