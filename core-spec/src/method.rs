//! The methods there are.
use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::needs::Needs;

use crate::consistent::ConsistentSpec;
use crate::core_input::CoreInput;
use crate::direct::DirectSpec;
use crate::duff::DuffSpec;
use crate::error::SpecError;
use crate::gouraud::GouraudSpec;
use crate::hybrid::HybridSpec;
use crate::inputs::MethodInputs;
use crate::lyon::LyonSpec;
use crate::merge::merged;
use crate::parameters::CoreParameters;
use crate::phong::PhongSpec;
use crate::reflection::ReflectionSpec;
use crate::shading_method::{OptionDomain, ShadingMethod};
use crate::slerp::SlerpSpec;

/// Defines the methods: a spec type each, the name users give it, one line on what it does, and its
/// source: the paper and, where it numbers them, the equations.
macro_rules! methods {
    ($($(#[$about:meta])* $method:ident($spec:ident) = $name:literal, $does:literal, [$paper:literal $(, $equations:literal)?];)*) => {
        /// How pixels are shaded.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum MethodSpec {
            $($(#[$about])* $method($spec),)*
        }

        /// The methods there are, by the names users give them.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Method {
            $(#[doc = concat!("[`MethodSpec::", stringify!($method), "`].")] $method,)*
        }

        impl Method {
            /// Every method.
            pub const ALL: [Method; [$($name),*].len()] = [$(Method::$method),*];

            /// The name that the command line and scene files use.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Method::$method => $name,)*
                }
            }

            /// One line on what it does, with its source.
            pub const fn summary(self) -> &'static str {
                match self {
                    $(Method::$method => concat!($does, " [", $paper, $(", eq. ", $equations,)? "]"),)*
                }
            }

            /// The paper it is from.
            pub const fn paper(self) -> &'static str {
                match self {
                    $(Method::$method => $paper,)*
                }
            }

            /// Numbers of the paper's equations, such as `3-8, 33`; none where the paper does not
            /// number them.
            pub const fn equations(self) -> Option<&'static str> {
                match self {
                    $(Method::$method => [$(Some($equations),)? None][0],)*
                }
            }

            /// The options it takes in a scene file besides formats.
            pub const fn option_domains(self) -> &'static [OptionDomain] {
                match self {
                    $(Method::$method => $spec::OPTION_DOMAINS,)*
                }
            }

            /// The options it takes in a scene file that change no pixel, but what leaves beside it.
            pub const fn output_domains(self) -> &'static [OptionDomain] {
                match self {
                    Method::Consistent => ConsistentSpec::OUTPUT_DOMAINS,
                    _ => &[],
                }
            }

            /// Its options and formats for a scene with these needs, with `changes` in place of the
            /// defaults.
            pub(crate) fn spec(self, needs: &Needs, changes: &toml::Table) -> Result<MethodSpec, SpecError> {
                match self {
                    $(Method::$method => merged(&$spec::for_needs(needs), changes).map(MethodSpec::$method),)*
                }
            }
        }

        impl MethodSpec {
            /// Which method this is.
            pub const fn method(&self) -> Method {
                match self {
                    $(MethodSpec::$method(_) => Method::$method,)*
                }
            }

            /// The format of the narrowing point called `name`.
            pub(crate) fn format_mut(&mut self, name: &str) -> Option<&mut Format> {
                match self {
                    $(MethodSpec::$method(spec) => spec.formats.named_mut(name),)*
                }
            }

            /// The same with the formats of another of this method.
            pub(crate) fn with_formats_of(&self, other: &MethodSpec) -> Option<MethodSpec> {
                match (self, other) {
                    $((MethodSpec::$method(own), MethodSpec::$method(other)) => {
                        let formats = other.formats.clone();
                        Some(MethodSpec::$method($spec { formats, ..own.clone() }))
                    })*
                    _ => None,
                }
            }

            /// All inputs of a core, in port order.
            pub(crate) fn core_inputs(&self, core: &CoreParameters) -> Vec<CoreInput> {
                match self {
                    $(MethodSpec::$method(spec) => spec.core_inputs(core).to_vec(),)*
                }
            }

            /// What it says of itself.
            pub(crate) fn shading(&self) -> &dyn ShadingMethod {
                match self {
                    $(MethodSpec::$method(spec) => spec,)*
                }
            }
        }
    };
}

methods! {
    /// Lyon's reformulation of Phong shading for hardware.
    Lyon(LyonSpec) = "lyon", "per-pixel normal, approximate normalisation, shape function f_k", ["Lyon, TR 43"];
    /// Phong shading with true normalisation, lights and eye at infinity or at places.
    Phong(PhongSpec) = "phong", "per-pixel normal, true normalisation, cos^n or Blinn's distributions", ["lecture", "2.1, 4.1-4.2"];
    /// Gouraud diffuse with Hast's specular recurrence.
    Hybrid(HybridSpec) = "hybrid", "Gouraud diffuse, specular base p/q by forward differences", ["Hast et al.", "17-26"];
    /// Duff's diffuse recurrence with one of Hast's highlights.
    Duff(DuffSpec) = "duff", "diffuse p/sqrt q by forward differences, highlight of the same q and root", ["Hast et al.", "3-8, 33, 34"];
    /// Intensities of the vertices or of the polygon.
    Gouraud(GouraudSpec) = "gouraud", "intensities interpolated between the vertices, or uniform over each polygon", ["lecture", "2.1, 3.2-3.6"];
    /// Hast's reflection shading.
    Reflection(ReflectionSpec) = "reflection", "a fixed normal reflected about a linear half-way vector, no root", ["Hast et al.", "27-34"];
    /// Consistent normal interpolation.
    Consistent(ConsistentSpec) = "consistent", "reflection that never enters the surface", ["Reshetov, Soupikov and Mark", "1, 3, 6, 8"];
    /// Spherical interpolation of N·L and N·V.
    Slerp(SlerpSpec) = "slerp", "N.L and N.V by incremental spherical interpolation along the scan line", ["lecture", "4.7-4.12"];
    /// N·L and N·V, linear, over the root of N·N.
    Direct(DirectSpec) = "direct", "N.L and N.V over the root of N.N = 1 - k t(1 - t), evaluated at every pixel", ["lecture", "4.3-4.6"];
}

impl Method {
    /// The method for a scene that names none.
    pub(crate) fn default_for(needs: &Needs) -> Method {
        if needs.has_places() { Method::Phong } else { Method::Lyon }
    }

    /// The method of that name.
    ///
    /// # Errors
    /// [`SpecError::UnknownMethod`] if there is none.
    pub fn from_name(name: &str) -> Result<Method, SpecError> {
        let found = Method::ALL.into_iter().find(|m| m.name() == name);
        found.ok_or_else(|| SpecError::UnknownMethod {
            name: name.to_owned(),
            known: Method::names(),
        })
    }

    /// Every method's name, for messages.
    pub(crate) fn names() -> String {
        Method::ALL.map(Method::name).join(", ")
    }
}
