//! A core to be made, from a scene or from a file, and the scene it is to shade.
use std::path::{Path, PathBuf};

use clap::Args;
use specula_scene::LoadedScene;
use specula_spec::{CoreSpec, Served, SpecFile};

use crate::arguments::{CoreArguments, NameArguments, PictureArguments, SceneArguments};
use crate::error::{Refused, ToolError};
use crate::header::Origin;

/// A core with its name, and a scene for it.
pub struct Job {
    /// The scene.
    pub scene: LoadedScene,
    /// The core, as it is written beside its Verilog.
    pub file: SpecFile,
    /// Where it comes from.
    pub origin: Origin,
}

impl Job {
    /// The core for a scene.
    pub fn of_scene(
        scene: &SceneArguments,
        core: &CoreArguments,
        name: &NameArguments,
    ) -> Result<Job, ToolError> {
        let loaded = scene.load()?;
        let spec = core.core(&loaded)?;
        let origin = Origin::of_scene(scene, core, &spec).called(name);
        let mut file = SpecFile { name: loaded.name.clone(), spec };
        name.rename(&mut file)?;
        Ok(Job { file, scene: loaded, origin })
    }

    /// A scene and a core that was made before.
    pub fn with_core(
        scene: &SceneArguments,
        core: &Path,
        name: &NameArguments,
    ) -> Result<Job, ToolError> {
        let mut file = SpecFile::read(core)?;
        let loaded = scene.load()?;
        let served = file.spec.serving(&loaded.frame).map_err(|error| {
            let (core, scene) = (core.to_owned(), loaded.name.clone());
            ToolError::Refused(Refused { core, scene, error })
        });
        let Served { frame, spec } = served?;
        let origin = Origin::of_file(core, &file).called(name);
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

/// A core for a scene, or one that was made before: for commands that need no picture.
#[derive(Clone, Debug, Args)]
pub struct SceneOrSpec {
    /// A built-in scene (see `specula scenes`), a scene file (.toml), or a mesh (.obj, .ply, .stl,
    /// .glb)
    #[arg(required_unless_present = "spec")]
    pub scene: Option<String>,
    /// The core in this spec.toml, in place of one for a scene
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scene", "size", "method", "specialise", "max_error"])]
    pub spec: Option<PathBuf>,
    #[command(flatten)]
    picture: PictureArguments,
    #[command(flatten)]
    wanted: CoreArguments,
}

impl SceneOrSpec {
    /// The core, and where it comes from.
    pub fn file(&self, name: &NameArguments) -> Result<(SpecFile, Origin), ToolError> {
        match (&self.spec, &self.scene) {
            (Some(path), _) => {
                let mut file = SpecFile::read(path)?;
                let origin = Origin::of_file(path, &file).called(name);
                name.rename(&mut file)?;
                Ok((file, origin))
            }
            // The command line asks for one of both.
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
