//! A job: a core to make, from a scene or from a file, and the scene that it shades.
use std::path::Path;

use specula_scene::LoadedScene;
use specula_spec::{CoreSpec, FittedCore, SpecFile};

use crate::arguments::{CoreArguments, NameArguments, SceneArguments};
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
