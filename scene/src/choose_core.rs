//! The core for a loaded scene.
use crate::spec::lyon::Normals;
use crate::spec::{CoreOptions, Specialise};
use crate::{CoreSpec, LoadedScene, Method, MethodSpec, Needs, SceneError};

impl LoadedScene {
    /// The core for this scene, with `method` if one is given, or else the method in the scene
    /// file's `[core]` table, or else `lyon`. It is specialised for this frame, unless the table
    /// has `specialise = "general"`.
    ///
    /// # Errors
    /// A [`SceneError`] that points at the `[core]` table, if there is one.
    pub fn core_spec(&self, method: Option<Method>) -> Result<CoreSpec, SceneError> {
        let spec = self.core_for(&Needs::of(&self.frame), method)?;
        Ok(match self.specialise()? {
            Specialise::General => spec,
            Specialise::Scene => spec.specialised(&self.frame),
        })
    }

    /// The general core that this scene would get with these needs; its frame is not looked at.
    ///
    /// # Errors
    /// The errors of [`LoadedScene::core_spec`].
    pub fn core_for(&self, needs: &Needs, method: Option<Method>) -> Result<CoreSpec, SceneError> {
        let options = self.options()?;
        let spec = CoreSpec::for_scene(needs, options.as_ref(), method);
        let spec = spec.map_err(|error| match &self.core {
            Some(table) => table.error(table.span(), error.to_string(), error.help_text()),
            None => SceneError::Spec(error),
        })?;
        Ok(match self.specialise()? {
            Specialise::General => spec,
            Specialise::Scene => without_interpolation(spec, needs, options.as_ref()),
        })
    }

    fn options(&self) -> Result<Option<CoreOptions>, SceneError> {
        self.core.as_ref().map(|table| table.parse::<CoreOptions>()).transpose()
    }

    fn specialise(&self) -> Result<Specialise, SceneError> {
        Ok(self.options()?.and_then(|options| options.specialise).unwrap_or(Specialise::Scene))
    }
}

/// If every triangle has only one normal, `lyon` does not interpolate it, unless the `[core]` table
/// says how to treat normals.
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
