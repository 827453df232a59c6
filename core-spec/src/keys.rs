//! The keys of a core in TOML: parameters, method and specialisation side by side.
//!
//! serde's `flatten` would read the same keys; but it forgets where in the file a wrong value
//! stands, and which keys there are.
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use specula_datapath::Format;
use specula_scene::needs::LocalKind;

use crate::attenuation::AttenuationSpec;
use crate::components::Components;
use crate::core_spec::CoreSpec;
use crate::light_pipelines::LightPipelines;
use crate::method::MethodSpec;
use crate::parameters::CoreParameters;
use crate::specialisation::Specialisation;
use crate::target_clock::TargetClock;

/// See [`CoreParameters`] and [`CoreSpec`] for what they mean.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "CoreSpec")]
struct Keys {
    lights: usize,
    local_lights: Vec<LocalKind>,
    local_eye: bool,
    several_materials: bool,
    light_pipelines: LightPipelines,
    #[serde(default, skip_serializing_if = "Components::is_parallel")]
    components: Components,
    longest_span: u32,
    largest_shininess: u32,
    coefficient: Format,
    shortest_normal: f64,
    shortest_way: f64,
    shortest_unit_way: f64,
    /// Cores that were made before there was this key say nothing of it.
    #[serde(default)]
    shortest_halfway: f64,
    least_cone_cosine: f64,
    least_view_cosine: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    attenuation: Option<AttenuationSpec>,
    method: MethodSpec,
    #[serde(default, skip_serializing_if = "Specialisation::is_general")]
    specialisation: Specialisation,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    target: Option<TargetClock>,
}

impl<'de> Deserialize<'de> for CoreSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<CoreSpec, D::Error> {
        Keys::deserialize(deserializer).map(CoreSpec::from)
    }
}

impl Serialize for CoreSpec {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Keys::from(self.clone()).serialize(serializer)
    }
}

/// Both ways between keys and a core, whose parameters have these keys.
macro_rules! parameters_have_keys {
    ($($key:ident),*) => {
        impl From<Keys> for CoreSpec {
            fn from(Keys { $($key,)* method, specialisation, target }: Keys) -> CoreSpec {
                let parameters = CoreParameters { $($key),* };
                CoreSpec { parameters, method, specialisation, target }
            }
        }

        impl From<CoreSpec> for Keys {
            fn from(CoreSpec { parameters, method, specialisation, target }: CoreSpec) -> Keys {
                let CoreParameters { $($key),* } = parameters;
                Keys { $($key,)* method, specialisation, target }
            }
        }
    };
}

parameters_have_keys!(
    lights,
    local_lights,
    local_eye,
    several_materials,
    light_pipelines,
    components,
    longest_span,
    largest_shininess,
    coefficient,
    shortest_normal,
    shortest_way,
    shortest_unit_way,
    shortest_halfway,
    least_cone_cosine,
    least_view_cosine,
    attenuation
);
