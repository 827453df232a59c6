//! The core for a loaded scene.
use std::borrow::Cow;

use specula_scene::{CoreTable, Frame, LoadedScene, Needs, SceneError};

use crate::core_spec::CoreSpec;
use crate::error::SpecError;
use crate::lyon::Normals;
use crate::method::{Method, MethodSpec};
use crate::options::{CoreOptions, Specialise, UnnamedFormats};
use crate::phong::{PhongSpec, Places};
#[cfg(doc)]
use crate::survey::Survey;

/// Why there is no core for a scene.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum CoreError {
    /// Something wrong at a place in the scene's file.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scene(#[from] SceneError),
    /// The core that the scene or the user asks for cannot be built.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Spec(#[from] SpecError),
}

/// What a loaded scene says of the core that shades it.
pub trait SceneCore {
    /// The core for this scene, with `method` if one is given, or else the one in the scene file's
    /// `[core]` table: the one that it names, or the only one that it has options for. Without any it
    /// is `lyon`, or `phong` where lights or the eye are at places. The core is specialised as
    /// [`SceneCore::as_wished`] does. Formats that the table does not name are the recommended ones.
    ///
    /// # Errors
    /// A [`CoreError`] that points at the `[core]` table, if there is one.
    fn core_spec(&self, method: Option<Method>) -> Result<CoreSpec, CoreError>;

    /// This core for the scene's frame, or for all frames where the scene moves, unless the scene
    /// file's `[core]` table has `specialise = "general"`.
    ///
    /// # Errors
    /// As [`SceneCore::core_spec`].
    fn as_wished(&self, general: CoreSpec) -> Result<CoreSpec, CoreError>;

    /// The general core that this scene would get with these needs; its frame is not looked at.
    ///
    /// # Errors
    /// As [`SceneCore::core_spec`].
    fn core_for(&self, needs: &Needs, method: Option<Method>) -> Result<CoreSpec, CoreError>;

    /// The core for this scene, as [`SceneCore::core_spec`] gives it, that keeps these things alone
    /// variable in place of what the scene file's `[core]` table names.
    ///
    /// # Errors
    /// As [`SceneCore::core_spec`].
    fn core_keeping(&self, keep: &[&str], method: Option<Method>) -> Result<CoreSpec, CoreError>;

    /// Whether the scene leaves the method to whoever makes the core: it has no file, or the file's
    /// `[core]` table says `method = "auto"`, or names no method and has options for none or several.
    ///
    /// # Errors
    /// A [`CoreError`] that points at the table, if it cannot be read.
    fn leaves_method_open(&self) -> Result<bool, CoreError>;

    /// The general core for this scene by the method and the options of that method in `options`;
    /// everything else is as the scene file's `[core]` table says.
    ///
    /// # Errors
    /// As [`SceneCore::core_spec`].
    fn core_with(&self, options: &CoreOptions, needs: &Needs) -> Result<CoreSpec, CoreError>;

    /// Frames that stand for all that a core is to shade, as far as it depends on them what its
    /// inputs are given: the scene's frame, or the witnesses of its sequence ([`Survey`]).
    ///
    /// # Errors
    /// [`SceneError::Picture`] if a frame of the sequence cannot be drawn.
    fn deciding_frames(&self, core: &CoreSpec) -> Result<Cow<'_, [Frame]>, SceneError>;

    /// The narrowing points of `method` whose formats the scene file's `[core]` table names.
    ///
    /// # Errors
    /// A [`CoreError`] that points at the table, if it cannot be read.
    fn named_formats(&self, method: Method) -> Result<Vec<String>, CoreError>;

    /// By how much wrapped directions to places may move colours, in LSBs, where the scene file's
    /// `[core]` table asks for them and `spec` has true ones, since they do not serve the scene.
    ///
    /// # Errors
    /// A [`CoreError`] that points at the table, if it cannot be read.
    fn refused_wraps(&self, spec: &CoreSpec) -> Result<Option<f64>, CoreError>;

    /// Where the formats come from that the scene file's `[core]` table does not name.
    ///
    /// # Errors
    /// A [`CoreError`] that points at the table, if it cannot be read.
    fn unnamed_formats(&self) -> Result<UnnamedFormats, CoreError>;
}

impl SceneCore for LoadedScene {
    fn core_spec(&self, method: Option<Method>) -> Result<CoreSpec, CoreError> {
        self.as_wished(self.core_for(&self.needs()?, method)?)
    }

    fn as_wished(&self, general: CoreSpec) -> Result<CoreSpec, CoreError> {
        match specialise(self)? {
            Specialise::General => Ok(general),
            Specialise::Scene => for_the_scene(self, general),
        }
    }

    fn core_for(&self, needs: &Needs, method: Option<Method>) -> Result<CoreSpec, CoreError> {
        core_by(self, core_options(self)?.as_ref(), needs, method)
    }

    fn core_keeping(&self, keep: &[&str], method: Option<Method>) -> Result<CoreSpec, CoreError> {
        let mut options = core_options(self)?.unwrap_or_default();
        options.keep = keep.iter().map(|&name| name.to_owned()).collect();
        for_the_scene(self, core_by(self, Some(&options), &self.needs()?, method)?)
    }

    fn leaves_method_open(&self) -> Result<bool, CoreError> {
        let Some(options) = core_options(self)? else { return Ok(true) };
        let named = options.named_method().map_err(|error| in_table(self, error))?;
        Ok(named.is_none())
    }

    fn core_with(&self, options: &CoreOptions, needs: &Needs) -> Result<CoreSpec, CoreError> {
        let own = core_options(self)?.unwrap_or_default();
        core_by(self, Some(&own.by_method_of(options)), needs, None)
    }

    fn deciding_frames(&self, core: &CoreSpec) -> Result<Cow<'_, [Frame]>, SceneError> {
        Ok(match &self.sequence {
            None => Cow::Borrowed(std::slice::from_ref(&self.frame)),
            Some(sequence) => Cow::Owned(core.survey(sequence)?.witnesses),
        })
    }

    fn named_formats(&self, method: Method) -> Result<Vec<String>, CoreError> {
        Ok(core_options(self)?.map(|options| options.named_formats(method)).unwrap_or_default())
    }

    fn refused_wraps(&self, spec: &CoreSpec) -> Result<Option<f64>, CoreError> {
        let MethodSpec::Phong(PhongSpec { places: Places::Exact, .. }) = &spec.method else {
            return Ok(None);
        };
        let asked = core_options(self)?
            .and_then(|options| options.method_table(Method::Phong).remove("places"))
            .is_some_and(|places| places.as_str() == Some("wrapped"));
        Ok(asked.then(|| self.needs().map(|needs| needs.most_off_by_wraps)).transpose()?)
    }

    fn unnamed_formats(&self) -> Result<UnnamedFormats, CoreError> {
        Ok(core_options(self)?.and_then(|options| options.formats).unwrap_or_default())
    }
}

/// The core with these options for needs.
fn core_by(
    scene: &LoadedScene,
    options: Option<&CoreOptions>,
    needs: &Needs,
    method: Option<Method>,
) -> Result<CoreSpec, CoreError> {
    let spec = CoreSpec::for_scene(needs, options, method);
    let spec = spec.map_err(|error| in_table(scene, error))?;
    Ok(match specialise(scene)? {
        Specialise::General => spec,
        Specialise::Scene => {
            let needs = spec.specialisation.kept().relaxed(needs);
            without_interpolation(spec, &needs, options)
        }
    })
}

/// A core for the scene's frame, or for all frames where the scene moves.
fn for_the_scene(scene: &LoadedScene, general: CoreSpec) -> Result<CoreSpec, CoreError> {
    Ok(match &scene.sequence {
        None => general.specialised(&scene.frame),
        Some(sequence) => general.survey(sequence)?.core,
    })
}

/// An error that points at the scene file's `[core]` table, if there is one.
fn in_table(scene: &LoadedScene, error: SpecError) -> CoreError {
    match &scene.core {
        Some(table) => table.error(table.span(), error.to_string(), error.help_text()).into(),
        None => error.into(),
    }
}

/// What the scene file's `[core]` table says.
fn core_options(scene: &LoadedScene) -> Result<Option<CoreOptions>, SceneError> {
    scene.core.as_ref().map(CoreTable::parse::<CoreOptions>).transpose()
}

fn specialise(scene: &LoadedScene) -> Result<Specialise, SceneError> {
    Ok(core_options(scene)?.and_then(|options| options.specialise).unwrap_or(Specialise::Scene))
}

/// If every triangle has only one normal, `lyon` does not interpolate it, unless the `[core]` table
/// says how to treat normals.
fn without_interpolation(
    mut spec: CoreSpec,
    needs: &Needs,
    options: Option<&CoreOptions>,
) -> CoreSpec {
    let told =
        options.is_some_and(|options| options.method_table(Method::Lyon).contains_key("normals"));
    if let (MethodSpec::Lyon(lyon), true, false) = (&mut spec.method, needs.flat, told) {
        lyon.normals = Normals::Flat;
    }
    spec
}
