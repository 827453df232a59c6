//! A method with formats, from which one core of a sweep is built.
use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

use specula_scene::LoadedScene;
use specula_spec::{CoreError, CoreSpec, Method, SceneCore, UnnamedFormats};

use crate::cost::GENERIC_BLOCK;
use crate::formats::{Products, default_core};

/// The number of fraction bits by which all formats of a core are finer than those of its method's
/// default core for the scene; fewer for a format that may not have so many.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Formats(i32);

/// Names for formats on the command line.
const NAMED: [(&str, Formats); 3] =
    [("narrow", Formats(-4)), ("default", Formats::DEFAULT), ("wide", Formats(2))];

impl Formats {
    /// The formats of the default core.
    pub const DEFAULT: Formats = Formats(0);
    /// Largest number of bits by which formats may differ from those recommended.
    pub const MOST: i32 = 12;

    /// Number of fraction bits more than those of the default core.
    pub const fn added(self) -> i32 {
        self.0
    }
}

impl Display for Formats {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Formats::DEFAULT => f.write_str("default"),
            Formats(added) => write!(f, "{added:+}"),
        }
    }
}

impl FromStr for Formats {
    type Err = String;

    fn from_str(text: &str) -> Result<Formats, String> {
        if let Some((_, formats)) = NAMED.iter().find(|(name, _)| *name == text) {
            return Ok(*formats);
        }
        let added = text
            .parse::<i32>()
            .ok()
            .filter(|added| (-Formats::MOST..=Formats::MOST).contains(added));
        added.map(Formats).ok_or_else(|| {
            let most = Formats::MOST;
            format!("write narrow, default, wide, or a number of fraction bits more than the default from -{most} to {most}")
        })
    }
}

/// A core of a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Configuration {
    /// Its method.
    pub method: Method,
    /// Its formats.
    pub formats: Formats,
}

impl Display for Configuration {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.method.name(), self.formats)
    }
}

/// The default core of a method for a scene: with the options that the scene file gives the method,
/// specialised as the scene asks for, in the formats in which `run` makes it for any device.
///
/// # Errors
/// The reason why there is none.
pub fn default_spec(method: Method, scene: &LoadedScene) -> Result<CoreSpec, String> {
    let words = |error: CoreError| error.to_string();
    let recommended = scene.core_spec(Some(method)).map_err(words)?;
    if scene.unnamed_formats().map_err(words)? == UnnamedFormats::Recommended {
        return Ok(recommended);
    }
    let named = scene.named_formats(method).map_err(words)?;
    let products = Products::Blocks(GENERIC_BLOCK);
    let default = default_core(recommended, &scene.frame, &named, products);
    default.map(|default| default.spec).map_err(|error| error.to_string())
}

impl Configuration {
    /// Its core for a scene, whose default core by the method is `default`.
    ///
    /// # Errors
    /// The reason why there is none: no format can be so much wider or narrower.
    pub fn spec(&self, default: &CoreSpec, scene: &LoadedScene) -> Result<CoreSpec, String> {
        if self.formats == Formats::DEFAULT {
            return Ok(default.clone());
        }
        let finer = default.general().finer(self.formats.added(), &[]);
        let spec = finer.ok_or("no format of it can differ so much from the default")?;
        let is_general = default.specialisation.is_general();
        Ok(if is_general { spec } else { spec.specialised(&scene.frame) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_read_or_refused() {
        for text in ["default", "+1", "-12", "+12"] {
            assert_eq!(text.parse::<Formats>().unwrap().to_string(), text);
        }
        for (text, added) in [("narrow", -4), ("wide", 2), ("0", 0), ("3", 3)] {
            assert_eq!(text.parse::<Formats>().map(Formats::added), Ok(added));
        }
        for text in ["", "wider", "13", "-13", "1.5", "99999999999"] {
            assert!(text.parse::<Formats>().is_err(), "{text}");
        }
    }

    #[test]
    fn narrower_formats_make_smaller_cores() {
        let scene = specula_scene::load("icosahedron", Some((24, 18))).unwrap();
        let default = default_spec(Method::Lyon, &scene).unwrap();
        let bits = |text: &str| {
            let configuration =
                Configuration { method: Method::Lyon, formats: text.parse().unwrap() };
            let spec = configuration.spec(&default, &scene).unwrap();
            specula_hdl::elaborate(&spec, "core").unwrap().size().multiplier_bits
        };
        assert!(bits("narrow") < bits("default") && bits("default") < bits("+1"));
    }
}
