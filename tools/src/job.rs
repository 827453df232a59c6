//! A job: a core to make, from a scene or from a file, and the scene that it shades.
use std::path::{Path, PathBuf};

use clap::Args;
use specula_scene::LoadedScene;
use specula_spec::{CoreSpec, FittedCore, SpecFile};

use crate::arguments::{CoreArguments, NameArguments, PictureArguments, SceneArguments};
use crate::error::{Refused, ToolError};
use crate::verilog::Origin;

/// A core with its name, and a scene for it.
pub struct Job {
    /// The scene.
    pub scene: LoadedScene,
    /// The core, as it is written next to its Verilog.
    pub file: SpecFile,
    /// The origin of the core.
    pub origin: Origin,
}

impl Job {
    /// The job of making a core for a scene.
    pub fn of_scene(
        scene: &SceneArguments,
        core: &CoreArguments,
        name: &NameArguments,
    ) -> Result<Job, ToolError> {
        let loaded = scene.load()?;
        let spec = core.core(&loaded)?;
        let origin = Origin::of_scene(scene, core, &spec).with_name(name);
        let mut file = SpecFile { name: loaded.name.clone(), spec };
        name.rename(&mut file)?;
        Ok(Job { file, scene: loaded, origin })
    }

    /// The job of shading a scene with a core that was made before.
    pub fn with_core(
        scene: &SceneArguments,
        core: &Path,
        name: &NameArguments,
    ) -> Result<Job, ToolError> {
        let mut file = SpecFile::read(core)?;
        let loaded = scene.load()?;
        let fitted = file.spec.fit_to(&loaded.frame).map_err(|error| {
            let (core, scene) = (core.to_owned(), loaded.name.clone());
            ToolError::Refused(Refused { core, scene, error })
        });
        let FittedCore { frame, spec } = fitted?;
        let origin = Origin::of_file(core, &file).with_name(name);
        name.rename(&mut file)?;
        Ok(Job { scene: LoadedScene { frame, ..loaded }, file: SpecFile { spec, ..file }, origin })
    }

    /// The core.
    pub fn spec(&self) -> &CoreSpec {
        &self.file.spec
    }

    /// The name of its Verilog module.
    pub fn module(&self) -> String {
        specula_hdl::module_name(&self.file.name, self.spec())
    }
}

/// The arguments that name a core for a scene, or one that was made before.
#[derive(Clone, Debug, Args)]
pub struct SceneOrSpec {
    /// A built-in scene (see `specula scenes`), a scene file (.toml), or a mesh (.obj, .ply, .stl,
    /// .glb)
    #[arg(required_unless_present = "spec")]
    pub scene: Option<String>,
    /// Use the core in this spec.toml instead of one for a scene
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scene", "size", "method", "specialise", "max_error", "target"])]
    pub spec: Option<PathBuf>,
    #[command(flatten)]
    picture: PictureArguments,
    #[command(flatten)]
    wanted: CoreArguments,
}

impl SceneOrSpec {
    /// The core and its origin.
    pub fn file(&self, name: &NameArguments) -> Result<(SpecFile, Origin), ToolError> {
        match (&self.spec, &self.scene) {
            (Some(path), _) => {
                let mut file = SpecFile::read(path)?;
                let origin = Origin::of_file(path, &file).with_name(name);
                name.rename(&mut file)?;
                Ok((file, origin))
            }
            // clap requires a scene where there is no spec.
            (None, scene) => {
                let scene = SceneArguments {
                    scene: scene.clone().unwrap_or_default(),
                    picture: self.picture.clone(),
                };
                let Job { file, origin, .. } = Job::of_scene(&scene, &self.wanted, name)?;
                Ok((file, origin))
            }
        }
    }
}
