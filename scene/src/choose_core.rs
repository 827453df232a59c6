//! The core for a loaded scene.
use crate::spec::lyon::Normals;
use crate::spec::{CoreOptions, Specialise};
use crate::{CoreSpec, LoadedScene, Method, MethodSpec, Needs, SceneError};

impl LoadedScene {
    /// The core for this scene, by `method` if one is given, else by what the scene file's `[core]`
    /// table says, else `lyon`. It is for this frame alone, unless the table has it
    /// `specialise = "general"`.
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

    /// The core that this scene would get if its needs were these: it is general, and its frame is
    /// not looked at.
    ///
    /// # Errors
    /// As [`LoadedScene::core_spec`].
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
