//! The core for a loaded scene.
use crate::spec::{CoreOptions, SpecError};
use crate::{CoreSpec, LoadedScene, Method, Needs, SceneError};

impl LoadedScene {
    /// The core for this scene, by `method` if one is given, else by what the scene file's `[core]` table says, else `lyon`.
    ///
    /// # Errors
    /// A [`SceneError`] that points at the `[core]` table where that is at fault, else says why the method cannot shade the scene.
    pub fn core_spec(&self, method: Option<Method>) -> Result<CoreSpec, SceneError> {
        let options = self.core.as_ref().map(|table| table.parse::<CoreOptions>()).transpose()?;
        let spec = CoreSpec::for_scene(&Needs::of(&self.frame), options.as_ref(), method);
        spec.map_err(|error| match &self.core {
            Some(table) if error.is_about_options() => table.error(table.span(), error.to_string(), help_of(&error)),
            _ => SceneError::Spec(error),
        })
    }
}

fn help_of(error: &SpecError) -> String {
    miette::Diagnostic::help(error).map(|help| help.to_string()).unwrap_or_default()
}
