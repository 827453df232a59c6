//! Which of the papers' loops does in software what a core does.
use specula_scene::CoreSpec;
use specula_scene::spec::gouraud::Interpolation;
use specula_scene::spec::lyon::{Difference, Normals};
use specula_scene::spec::{MethodSpec, duff, phong, reflection};

/// The loop that does what a core does, if there is one.
pub fn counterpart(spec: &CoreSpec) -> Option<&'static str> {
    match &spec.method {
        MethodSpec::Lyon(lyon) if lyon.normals != Normals::Linear => None,
        MethodSpec::Lyon(lyon) => match lyon.difference {
            Difference::ReflectionMinusLight => Some("lyon-reflection"),
            Difference::HalfwayCrossNormal => Some("lyon"),
            _ => None,
        },
        MethodSpec::Phong(phong) => (phong.highlight == phong::Highlight::Reflection).then_some("phong"),
        MethodSpec::Hybrid(_) => Some("hybrid"),
        MethodSpec::Duff(duff) => Some(match duff.specular {
            duff::Highlight::Blinn => "duff-blinn",
            duff::Highlight::Quotient => "duff-hybrid",
            duff::Highlight::Eq33 => "duff-quotient",
            duff::Highlight::Eq34 => "duff",
        }),
        MethodSpec::Gouraud(gouraud) => Some(match gouraud.interpolation {
            Interpolation::Linear => "gouraud",
            Interpolation::Uniform => "uniform",
        }),
        MethodSpec::Reflection(reflection) => Some(match reflection.specular {
            reflection::Highlight::Blinn => "reflection-blinn",
            reflection::Highlight::Hybrid => "reflection-hybrid",
            reflection::Highlight::Eq34 => "reflection",
        }),
        MethodSpec::Consistent(_) => Some("consistent"),
        MethodSpec::Slerp(_) => Some("slerp"),
        MethodSpec::Direct(_) => Some("direct"),
    }
}
