//! A method with options, and its neighbours.
use specula_scene::Needs;
use specula_spec::{CoreSpec, Method, SpecError};

use crate::stress::variant::Variant;

/// A method and options that differ from its defaults.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Options {
    method: Method,
    /// Keys and values, in the order of the method's choices.
    changed: Vec<(&'static str, &'static str)>,
}

impl Options {
    /// A method with its defaults.
    pub fn default_of(method: Method) -> Options {
        Options { method, changed: Vec::new() }
    }

    /// All options that differ from these in the value of one key.
    pub fn neighbours(&self) -> Vec<Options> {
        let choices = self.method.option_domains().iter();
        choices
            .flat_map(|choice| choice.values.iter().map(|value| self.with(choice.key, value)))
            .collect()
    }

    fn with(&self, key: &'static str, value: &'static str) -> Options {
        let of_key = |choice: &&specula_spec::OptionDomain| {
            let old = self
                .changed
                .iter()
                .find(|(changed, _)| *changed == choice.key)
                .map(|(_, value)| *value);
            (if choice.key == key { Some(value) } else { old }).map(|value| (choice.key, value))
        };
        let changed =
            self.method.option_domains().iter().filter_map(|choice| of_key(&choice)).collect();
        Options { method: self.method, changed }
    }

    /// Text that names the method and the options that differ.
    pub fn describe(&self) -> String {
        self.variant().describe()
    }

    /// The general core for a scene, in the formats recommended for it.
    pub fn spec(&self, needs: &Needs) -> Result<CoreSpec, SpecError> {
        self.variant().core_spec(needs)
    }

    fn variant(&self) -> Variant {
        let table = self.changed.iter().map(|(key, value)| format!("{key} = {value}\n")).collect();
        Variant { method: self.method, table }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_key_changes_at_a_time() {
        let start = Options::default_of(Method::Lyon);
        let first = start.with("squarings", "3");
        let second = first.with("normalisation", "\"g1\"");
        assert_eq!(second.describe(), "lyon (normalisation = \"g1\", squarings = 3)");
        assert_eq!(
            second.with("squarings", "1").describe(),
            "lyon (normalisation = \"g1\", squarings = 1)"
        );
        assert!(second.neighbours().contains(&second));
        assert_eq!(
            start.neighbours().len(),
            Method::Lyon.option_domains().iter().map(|choice| choice.values.len()).sum::<usize>()
        );
    }
}
