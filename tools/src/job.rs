//! A core to be made, from a scene or from a file, and the scene it is to shade.
use std::path::Path;

use specula_scene::LoadedScene;
use specula_spec::{CoreSpec, Served, SpecFile};

use crate::arguments::{CoreArguments, NameArguments, SceneArguments};
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
