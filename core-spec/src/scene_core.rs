//! The core for a loaded scene.
use specula_scene::{LoadedScene, Needs, SceneError};

use crate::lyon::Normals;
use crate::{CoreOptions, CoreSpec, Method, MethodSpec, SpecError, Specialise};

/// Why there is no core for a scene.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum CoreError {
    /// Something wrong at a place in the scene's file.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scene(#[from] SceneError),
    /// No core can be built for the scene as it is asked for.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Spec(#[from] SpecError),
}

/// What a loaded scene says of the core that shades it.
pub trait SceneCore {
    /// The core for this scene, by `method` if one is given, else by what the scene file's `[core]`
    /// table says, else `lyon`. It is for this frame alone, unless the table has it
    /// `specialise = "general"`.
    ///
    /// # Errors
    /// A [`CoreError`] that points at the `[core]` table, if there is one.
    fn core_spec(&self, method: Option<Method>) -> Result<CoreSpec, CoreError>;

    /// The core that this scene would get if its needs were these: it is general, and its frame is
    /// not looked at.
    ///
    /// # Errors
    /// As [`SceneCore::core_spec`].
    fn core_for(&self, needs: &Needs, method: Option<Method>) -> Result<CoreSpec, CoreError>;
}

impl SceneCore for LoadedScene {
    fn core_spec(&self, method: Option<Method>) -> Result<CoreSpec, CoreError> {
        let spec = self.core_for(&Needs::of(&self.frame), method)?;
        Ok(match specialise(self)? {
            Specialise::General => spec,
            Specialise::Scene => spec.specialised(&self.frame),
        })
    }

    fn core_for(&self, needs: &Needs, method: Option<Method>) -> Result<CoreSpec, CoreError> {
        let options = core_options(self)?;
        let spec = CoreSpec::for_scene(needs, options.as_ref(), method);
        let spec = spec.map_err(|error| -> CoreError {
            match &self.core {
                Some(table) => {
                    table.error(table.span(), error.to_string(), error.help_text()).into()
                }
                None => error.into(),
            }
        })?;
        Ok(match specialise(self)? {
            Specialise::General => spec,
            Specialise::Scene => without_interpolation(spec, needs, options.as_ref()),
        })
    }
}

/// What the scene file's `[core]` table says.
fn core_options(scene: &LoadedScene) -> Result<Option<CoreOptions>, SceneError> {
    scene.core.as_ref().map(|table| table.parse::<CoreOptions>()).transpose()
}

fn specialise(scene: &LoadedScene) -> Result<Specialise, SceneError> {
    Ok(core_options(scene)?.and_then(|options| options.specialise).unwrap_or(Specialise::Scene))
}

/// Where every triangle has one normal, `lyon` takes it as it is, unless it is told what to do with
/// normals.
fn without_interpolation(
    mut spec: CoreSpec,
    needs: &Needs,
    options: Option<&CoreOptions>,
) -> CoreSpec {
    let told = options.is_some_and(|options| options.of(Method::Lyon).contains_key("normals"));
    if let (MethodSpec::Lyon(lyon), true, false) = (&mut spec.method, needs.flat, told) {
        lyon.normals = Normals::Flat;
    }
    spec
}
