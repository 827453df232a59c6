//! A core as a file, `spec.toml`: it contains everything that defines the core, so that the same
//! hardware can be built again, or shade another scene.
use std::path::Path;

use serde::{Deserialize, Serialize};
use specula_scene::{LONGEST_NAME, SceneError, SourceFile, module_name};
use toml::Spanned;

use crate::core_spec::CoreSpec;

/// A named core.
#[derive(Clone, Debug, PartialEq)]
pub struct SpecFile {
    /// The name of the scene that it was made for, from which its module and its files are named.
    pub name: String,
    /// The core.
    pub spec: CoreSpec,
}

/// The version of the format. Another version may have other keys.
const VERSION: u32 = 1;

const HELP: &str =
    "docs/spec-file.md lists every key; `specula generate` and `specula run` write whole files";

/// The contents of the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Contents<Name, Spec> {
    version: u32,
    name: Name,
    spec: Spec,
}

/// A file, as far as its version is concerned.
#[derive(Deserialize)]
struct OnlyVersion {
    version: Spanned<u32>,
}

impl SpecFile {
    /// The name of the file in a run's folder.
    pub const NAME: &str = "spec.toml";

    /// Largest length of a core's name, in characters.
    pub const LONGEST_NAME: usize = LONGEST_NAME;

    /// The beginning of every spec file that Specula writes.
    pub const ABOUT: &str = "\
# A core of Specula's. `specula generate --spec FILE` writes its Verilog, and
# `specula run SCENE --core FILE` shades a scene with it, if it has what the scene needs.
";

    /// The file's text; [`SpecFile::parse`] makes the same core from it.
    pub fn text(&self) -> String {
        let contents = Contents { version: VERSION, name: &self.name, spec: &self.spec };
        let toml = toml::to_string(&contents)
            .expect("a spec is numbers, words and tables of them, all of which TOML has");
        format!("{}{toml}", SpecFile::ABOUT)
    }

    /// Reads a file, or [`SpecFile::NAME`] in a folder.
    ///
    /// # Errors
    /// A [`SceneError`] that says what is wrong with it, and where.
    pub fn read(path: &Path) -> Result<SpecFile, SceneError> {
        let path = if path.is_dir() { &path.join(SpecFile::NAME) } else { path };
        SpecFile::from_source(&SourceFile::read("spec file", path)?)
    }

    /// Reads a file's text; `file` is its name in errors.
    ///
    /// # Errors
    /// A [`SceneError`] that points at what is wrong.
    pub fn parse(file: &str, text: String) -> Result<SpecFile, SceneError> {
        SpecFile::from_source(&SourceFile::new(file, text))
    }

    fn from_source(source: &SourceFile) -> Result<SpecFile, SceneError> {
        let OnlyVersion { version } = source.parse(HELP)?;
        if *version.as_ref() != VERSION {
            let problem =
                format!("this is version {}, and version {VERSION} is read here", version.as_ref());
            return Err(source.error(
                version.span(),
                problem,
                "make the file again with this Specula",
            ));
        }
        let Contents { name, spec, .. } =
            source.parse::<Contents<Spanned<String>, Spanned<CoreSpec>>>(HELP)?;
        if *name.as_ref() != module_name(Path::new(name.as_ref())) {
            let problem = format!("`{}` cannot be the name of a module", name.as_ref());
            return Err(source.error(
                name.span(),
                problem,
                "write small letters, digits and _, 48 at most, and no digit first",
            ));
        }
        let checked = spec.as_ref().check();
        checked.map_err(|error| source.error(spec.span(), error.to_string(), error.help_text()))?;
        Ok(SpecFile { name: name.into_inner(), spec: spec.into_inner() })
    }
}
