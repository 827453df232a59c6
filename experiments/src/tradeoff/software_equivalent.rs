//! The software software_equivalent of a core: the paper's loop that computes the same.
use specula_spec::gouraud::{Highlight, Interpolation};
use specula_spec::lyon::{Difference, Halfway, LyonSpec, Normals};
use specula_spec::slerp::Edges;
use specula_spec::{
    ConsistentSpec, CoreSpec, DirectSpec, MethodSpec, consistent, direct, duff, phong, reflection,
};

/// The name of the loop that computes the same as a core, if there is one.
pub fn software_equivalent(spec: &CoreSpec) -> Option<&'static str> {
    let is_phong = matches!(spec.method, MethodSpec::Phong(_));
    if spec.follows_ways() && !is_phong {
        // Loops see places from the middle of a span, such cores from every pixel.
        return None;
    }
    match &spec.method {
        MethodSpec::Lyon(lyon) => of_lyon(lyon),
        MethodSpec::Phong(phong)
            if spec.parameters.local_lights.is_empty() && !spec.parameters.local_eye =>
        {
            Some(match phong.highlight {
                phong::Highlight::Reflection => "phong",
                phong::Highlight::Blinn => "phong-blinn",
                phong::Highlight::TorranceSparrow => "phong-torrance-sparrow",
                phong::Highlight::TrowbridgeReitz => "phong-trowbridge-reitz",
            })
        }
        MethodSpec::Phong(phong) => match (phong.highlight, phong.places) {
            (phong::Highlight::Reflection, phong::Places::Exact) => Some("phong-places"),
            (phong::Highlight::Reflection, phong::Places::Wrapped) => Some("phong-wrapped-places"),
            _ => None,
        },
        MethodSpec::Hybrid(_) => Some("hybrid"),
        MethodSpec::Duff(duff) => Some(match duff.specular {
            duff::Highlight::Blinn => "duff-blinn",
            duff::Highlight::Quotient => "duff-hybrid",
            duff::Highlight::Eq33 => "duff-quotient",
            duff::Highlight::Eq34 => "duff",
        }),
        // Loops have powers at vertices.
        MethodSpec::Gouraud(gouraud) if gouraud.highlight == Highlight::FK => None,
        MethodSpec::Gouraud(gouraud) => Some(match gouraud.interpolation {
            Interpolation::Linear => "gouraud",
            Interpolation::Uniform => "uniform",
        }),
        MethodSpec::Reflection(reflection) => Some(match reflection.specular {
            reflection::Highlight::Blinn => "reflection-blinn",
            reflection::Highlight::Hybrid => "reflection-hybrid",
            reflection::Highlight::Eq34 => "reflection",
        }),
        MethodSpec::Consistent(consistent) => of_consistent(consistent),
        MethodSpec::Slerp(slerp) => Some(match slerp.edges {
            Edges::Linear => "slerp",
            Edges::Slerp => "slerp-edges",
        }),
        MethodSpec::Direct(direct) => Some(of_direct(direct)),
    }
}

fn of_lyon(lyon: &LyonSpec) -> Option<&'static str> {
    if lyon.normals != Normals::Linear {
        return None;
    }
    match (lyon.difference, lyon.halfway, lyon.squarings) {
        (Difference::ReflectionMinusLight, _, 2) => Some("lyon-reflection"),
        (Difference::ReflectionMinusLight, _, 1) => Some("lyon-reflection-1"),
        (Difference::ReflectionMinusLight, _, 0) => Some("lyon-reflection-0"),
        (Difference::LightReflection, _, 2) => Some("lyon-light-reflection"),
        (Difference::HalfwayProjection, _, 2) => Some("lyon-projection"),
        (Difference::HalfwayCrossNormal, _, 2) => Some("lyon"),
        (Difference::UnitHalfwayMinusNormal, Halfway::Unit, 2) => Some("lyon-unit-normal"),
        (Difference::UnitHalfwayMinusNormal, Halfway::HalfG2, 2) => Some("lyon-half-g2-normal"),
        (Difference::UnitHalfwayProjection, Halfway::Unit, 2) => Some("lyon-unit-projection"),
        (Difference::UnitHalfwayProjection, Halfway::Half, 2) => Some("lyon-half-projection"),
        (Difference::UnitHalfwayProjection, Halfway::HalfG2, 2) => Some("lyon-half-g2-projection"),
        (Difference::UnitHalfwayProjection, Halfway::HalfG2, 1) => {
            Some("lyon-half-g2-projection-1")
        }
        _ => None,
    }
}

fn of_consistent(spec: &ConsistentSpec) -> Option<&'static str> {
    use consistent::{Curve, Diffuse, Highlight};
    match (spec.curve, spec.diffuse, spec.highlight) {
        (Curve::Rational, Diffuse::Lambert, Highlight::Reflection) => Some("consistent"),
        (Curve::Trigonometric, Diffuse::Lambert, Highlight::Reflection) => {
            Some("consistent-trigonometric")
        }
        (Curve::Rational, Diffuse::Consistent, Highlight::Blinn) => Some("consistent-normal"),
        _ => None,
    }
}

fn of_direct(spec: &DirectSpec) -> &'static str {
    match (spec.root, spec.newton_steps) {
        (direct::Root::Exact, _) => "direct",
        (direct::Root::Newton, 1) => "fast-phong",
        (direct::Root::Newton, _) => "fast-phong-2",
    }
}

#[cfg(test)]
mod tests {
    use specula_golden::loops::software::by_name;
    use specula_scene::{Needs, load};
    use specula_spec::{CoreSpec, Method};

    use super::software_equivalent;
    use crate::stress::variant::Variant;

    #[test]
    fn every_counterpart_is_a_loop() {
        let needs = Needs::of(&load("teapot", Some((32, 24))).unwrap().frame);
        for variant in Method::ALL.into_iter().flat_map(Variant::all_of) {
            let spec = variant.core_spec(&needs).unwrap();
            let name = software_equivalent(&spec);
            assert!(
                name.is_none_or(|name| by_name(name).is_some()),
                "{}: {name:?}",
                variant.describe()
            );
            assert!(
                !variant.table.is_empty() || name.is_some(),
                "{} has no loop",
                variant.describe()
            );
        }
    }

    #[test]
    fn lights_at_places_have_counterparts_that_are_measured() {
        let frame = load("lamps", Some((32, 24))).unwrap().frame;
        let needs = Needs::of(&frame);
        for (places, wanted) in [("exact", "phong-places"), ("wrapped", "phong-wrapped-places")] {
            let table = format!("[phong]\nplaces = \"{places}\"").parse().unwrap();
            let spec = CoreSpec::for_scene(&needs, Some(&table), Some(Method::Phong)).unwrap();
            let name = software_equivalent(&spec).unwrap();
            assert_eq!(name, wanted);
            assert!(by_name(name).unwrap().serves(&frame));
        }
    }
}
