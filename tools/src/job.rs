//! A job: a core to make, from a scene or from a file, and the scene that it shades.
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use specula_experiments::formats::{DefaultCore, NotFaithful};
use specula_scene::{LoadedScene, Sequence};
use specula_spec::{CoreSpec, FittedCore, SpecFile};

use crate::arguments::{CoreArguments, NameArguments, PictureArguments, SceneArguments};
use crate::error::{Refused, ToolError};
use crate::target_arguments::{PART, TargetArguments};
use crate::verilog::Origin;

/// A core with its name, and a scene for it.
pub struct Job {
    /// The scene.
    pub scene: LoadedScene,
    /// The core, as it is written next to its Verilog.
    pub file: SpecFile,
    /// The origin of the core.
    pub origin: Origin,
    /// The core's formats, with the reason, where it was to be faithful and could not be proven so.
    pub not_faithful: Option<NotFaithful>,
}

impl Job {
    /// The job of making a core for a scene.
    pub fn of_scene(
        scene: &SceneArguments,
        core: &CoreArguments,
        name: &NameArguments,
    ) -> Result<Job, ToolError> {
        let loaded = scene.load()?;
        let DefaultCore { spec, not_faithful } = core.core(&loaded)?;
        let wished = core.wished_method(&loaded)?;
        let origin = Origin::of_scene(scene, core, wished, &spec).with_name(name);
        let mut file = SpecFile { name: loaded.name.clone(), spec };
        name.rename(&mut file)?;
        Ok(Job { file, scene: loaded, origin, not_faithful })
    }

    /// The job of shading a scene with a core that was made before.
    pub fn with_core(
        scene: &SceneArguments,
        core: &Path,
        name: &NameArguments,
    ) -> Result<Job, ToolError> {
        Job::shading(made_before(core, name)?, scene, core)
    }

    /// The job of shading a scene with a core, which is called `core` where it does not fit.
    fn shading(
        (file, origin): (SpecFile, Origin),
        scene: &SceneArguments,
        core: &Path,
    ) -> Result<Job, ToolError> {
        let loaded = scene.load()?;
        let refused = |scene: String| {
            let core = core.to_owned();
            move |error| ToolError::Refused(Refused { core, scene, error })
        };
        let fitted = file.spec.fit_to(&loaded.frame).map_err(refused(loaded.name.clone()));
        let FittedCore { frame, spec } = fitted?;
        let spec = match &loaded.sequence {
            None => spec,
            Some(sequence) => {
                let fitted = sequence.map(|number, frame| {
                    let name = format!("{}, frame {number}", loaded.name);
                    let fitted = file.spec.fit_to(&frame).map_err(refused(name))?;
                    Ok::<_, ToolError>(fitted.spec)
                })?;
                fitted.iter().fold(spec, CoreSpec::with_bounds_of)
            }
        };
        let (scene, file) = (LoadedScene { frame, ..loaded }, SpecFile { spec, ..file });
        Ok(Job { scene, file, origin, not_faithful: None })
    }

    /// The core.
    pub fn spec(&self) -> &CoreSpec {
        &self.file.spec
    }

    /// The number of frames, 0 of a scene that does not move.
    pub fn frames(&self) -> u32 {
        self.scene.sequence.as_ref().map_or(0, Sequence::frames)
    }

    /// The same job for one frame of the scene's sequence; for the scene as it is if it does not
    /// move.
    pub fn in_frame(self, number: u32) -> Result<Job, ToolError> {
        Ok(Job { scene: self.scene.in_frame(number)?, ..self })
    }

    /// The name of its Verilog module.
    pub fn module(&self) -> String {
        specula_hdl::module_name(&self.file.name, self.spec())
    }
}

/// A core that was made before, from its file.
fn made_before(path: &Path, name: &NameArguments) -> Result<(SpecFile, Origin), ToolError> {
    let mut file = SpecFile::read(path)?;
    let origin = Origin::of_file(path, &file).with_name(name);
    name.rename(&mut file)?;
    Ok((file, origin))
}

/// The arguments that name a core for a scene, or one that was made before.
#[derive(Clone, Debug, Args)]
#[command(mut_arg("clock", |clock| clock.requires(PART)))]
pub struct SceneOrSpec {
    /// A built-in scene (see `specula scenes`), a scene file (.toml), or a mesh (.obj, .ply, .stl,
    /// .glb)
    #[arg(required_unless_present = "spec")]
    pub scene: Option<String>,
    /// Use the core in this spec.toml instead of one for a scene
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scene", "size", "method", "specialise", "formats", "bound", "max_error", "max_quantisation"])]
    pub spec: Option<PathBuf>,
    #[command(flatten)]
    picture: PictureArguments,
    #[command(flatten)]
    wanted: CoreArguments,
}

impl SceneOrSpec {
    /// The core and its origin.
    pub fn file(&self, name: &NameArguments) -> Result<(SpecFile, Origin), ToolError> {
        match &self.spec {
            Some(path) => {
                let (file, origin) = made_before(path, name)?;
                let made_for = &self.wanted.made_for;
                let spec = made_for.made_for(file.spec)?;
                let origin = match made_for.target()? {
                    Some(_) => origin.with_target(&spec),
                    None => origin,
                };
                Ok((SpecFile { spec, ..file }, origin))
            }
            None => {
                let scene = self.scene();
                let job = Job::of_scene(&scene, &self.wanted, name)?;
                if let Some(formats) = &job.not_faithful {
                    // A closed standard error is no reason to stop.
                    let _ = writeln!(io::stderr(), "formats: {formats}");
                }
                Ok((job.file, job.origin))
            }
        }
    }

    /// The core, which [`SceneOrSpec::file`] has made, with a scene for it to shade: the one that is
    /// named, or else its own.
    ///
    /// # Errors
    /// [`ToolError::NoScene`] if the core is a file and no scene is named, and
    /// [`ToolError::Refused`] if the core cannot shade the scene.
    pub fn job(
        &self,
        (file, origin): (SpecFile, Origin),
        named: Option<&str>,
    ) -> Result<Job, ToolError> {
        let core = self.spec.as_deref();
        let Some(named) = named else {
            return match core {
                Some(_) => Err(ToolError::NoScene),
                None => {
                    let scene = self.scene().load()?;
                    Ok(Job { scene, file, origin, not_faithful: None })
                }
            };
        };
        let scene =
            SceneArguments { scene: named.to_owned(), picture: PictureArguments::default() };
        let core = core.unwrap_or(Path::new(self.scene.as_deref().unwrap_or_default()));
        Job::shading((file, origin), &scene, core)
    }

    /// The target and the device that the core is made for.
    pub fn made_for(&self) -> &TargetArguments {
        &self.wanted.made_for
    }

    /// The scene that the core is made for.
    fn scene(&self) -> SceneArguments {
        // clap requires a scene where there is no spec.
        let scene = self.scene.clone().unwrap_or_default();
        SceneArguments { scene, picture: self.picture.clone() }
    }
}
