//! The `[core]` table of a scene file.
use std::fmt;
use std::str::FromStr;

use serde::Deserialize;
use serde::de::{self, Deserializer, MapAccess, Visitor};

use crate::components::Components;
use crate::error::SpecError;
use crate::kept::{Kept, KeptWithin};
use crate::light_pipelines::LightPipelines;
use crate::method::Method;

/// The word for any method that will do.
pub const ANY_METHOD: &str = "auto";

/// The `[core]` table of a scene file: a method's name, and a table of options for any of the
/// methods.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CoreOptions {
    /// Name of the method.
    pub method: Option<String>,
    /// Whether the core is for the scene alone or for any, if that is said.
    pub specialise: Option<Specialise>,
    /// Whether lights share a pipeline, if that is said.
    pub light_pipelines: Option<LightPipelines>,
    /// Whether components share multipliers, if that is said.
    pub components: Option<Components>,
    /// Where formats that are not named come from, if that is said.
    pub formats: Option<UnnamedFormats>,
    /// What must stay an input.
    pub keep: Vec<String>,
    /// Within what it may change.
    pub kept: KeptWithin,
    /// Options that differ from the defaults.
    tables: Vec<(Method, toml::Table)>,
}

impl CoreOptions {
    /// The options of a method that differ from the defaults.
    pub fn method_table(&self, method: Method) -> toml::Table {
        self.tables
            .iter()
            .find(|(of, _)| *of == method)
            .map(|(_, table)| table.clone())
            .unwrap_or_default()
    }

    /// The method that is named, or the only one that is given options; `None` without one, or where
    /// any will do.
    ///
    /// # Errors
    /// [`SpecError::UnknownMethod`] if there is no method of that name.
    pub(crate) fn named_method(&self) -> Result<Option<Method>, SpecError> {
        match (self.method.as_deref(), self.tables.as_slice()) {
            (Some(ANY_METHOD), _) => Ok(None),
            (Some(name), _) => Method::from_name(name).map(Some),
            (None, [(method, _)]) => Ok(Some(*method)),
            (None, _) => Ok(None),
        }
    }

    /// What must stay an input, with its limits.
    ///
    /// # Errors
    /// [`SpecError::OutOfRange`] for a limit that cannot be.
    pub(crate) fn kept(&self) -> Result<Kept, SpecError> {
        Kept::new(&self.keep, self.kept.clone())
    }

    /// These with the method of others, and with their options of methods.
    pub(crate) fn by_method_of(self, others: &CoreOptions) -> CoreOptions {
        CoreOptions { method: others.method.clone(), tables: others.tables.clone(), ..self }
    }

    /// The narrowing points of a method whose formats are named.
    pub fn named_formats(&self, method: Method) -> Vec<String> {
        let table = self.method_table(method);
        let formats = table.get("formats").and_then(toml::Value::as_table);
        formats.into_iter().flat_map(toml::Table::keys).cloned().collect()
    }
}

impl FromStr for CoreOptions {
    type Err = SpecError;

    /// Reads the table's contents as TOML.
    fn from_str(text: &str) -> Result<CoreOptions, SpecError> {
        toml::from_str(text)
            .map_err(|error| SpecError::Core { message: error.message().to_owned() })
    }
}

/// What a core is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Specialise {
    /// The scene alone: what it does not need is left out.
    Scene,
    /// Any scene with no more lights, exponents and pixels in a span.
    General,
}

impl Specialise {
    /// Both.
    pub const ALL: [Specialise; 2] = [Specialise::Scene, Specialise::General];

    /// The name that the command line and scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            Specialise::Scene => "scene",
            Specialise::General => "general",
        }
    }
}

/// Where the formats come from that nobody names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum UnnamedFormats {
    /// A search: the cheapest ones that are found for which the core is faithful by its proven
    /// bound.
    #[default]
    Faithful,
    /// docs/numerics.md, which recommends some for angles, exponents and colours.
    Recommended,
}

impl UnnamedFormats {
    /// Both.
    pub const ALL: [UnnamedFormats; 2] = [UnnamedFormats::Faithful, UnnamedFormats::Recommended];

    /// The name that the command line and scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            UnnamedFormats::Faithful => "faithful",
            UnnamedFormats::Recommended => "recommended",
        }
    }
}

enum Key {
    Method,
    Specialise,
    LightPipelines,
    Components,
    Formats,
    Keep,
    Kept,
    Table(Method),
}

impl<'de> Deserialize<'de> for Key {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Key, D::Error> {
        let name = String::deserialize(deserializer)?;
        let unknown = |_| {
            let known = format!(
                "expected `method`, `specialise`, `light_pipelines`, `components`, `formats`, `keep`, `kept` or a method's name ({})",
                Method::names()
            );
            de::Error::custom(format!("unknown field `{name}`, {known}"))
        };
        match name.as_str() {
            "method" => Ok(Key::Method),
            "specialise" => Ok(Key::Specialise),
            "light_pipelines" => Ok(Key::LightPipelines),
            "components" => Ok(Key::Components),
            "formats" => Ok(Key::Formats),
            "keep" => Ok(Key::Keep),
            "kept" => Ok(Key::Kept),
            _ => Method::from_name(&name).map(Key::Table).map_err(unknown),
        }
    }
}

impl<'de> Deserialize<'de> for CoreOptions {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<CoreOptions, D::Error> {
        deserializer.deserialize_map(Keys)
    }
}

struct Keys;

impl<'de> Visitor<'de> for Keys {
    type Value = CoreOptions;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table with a method's name and options")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<CoreOptions, A::Error> {
        let mut options = CoreOptions::default();
        while let Some(key) = map.next_key()? {
            match key {
                Key::Method => options.method = Some(map.next_value()?),
                Key::Specialise => options.specialise = Some(map.next_value()?),
                Key::LightPipelines => options.light_pipelines = Some(map.next_value()?),
                Key::Components => options.components = Some(map.next_value()?),
                Key::Formats => options.formats = Some(map.next_value()?),
                Key::Keep => options.keep = map.next_value()?,
                Key::Kept => options.kept = map.next_value()?,
                Key::Table(method) => options.tables.push((method, map.next_value()?)),
            }
        }
        Ok(options)
    }
}
