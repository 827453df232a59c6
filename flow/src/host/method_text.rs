//! The program of a core: the text of its method, with what its options ask for.
use specula_scene::needs::LocalKind;
use specula_spec::consistent;
use specula_spec::gouraud::{Highlight, Interpolation};
use specula_spec::lyon::{Halfway, Normals, WrapAxis};
use specula_spec::reflection::Bisector;
use specula_spec::slerp::{Edges, Form};
use specula_spec::{CoreSpec, MethodSpec, PowerUnit, Viewpoint};

use super::program::Program;
use crate::stream::template::Values;

/// The program of a core.
pub fn program(spec: &CoreSpec) -> Program {
    let parameters = &spec.parameters;
    let (text, mut values) = method(spec);
    values.set("LARGEST_SHININESS", parameters.largest_shininess);
    values.set("LARGEST_EXPONENT", parameters.largest_spot_exponent());
    // Where the middle of a span sees the eye, everything is turned until it is at infinity.
    let of_spans = spec.places_seen_from() == Viewpoint::Span;
    let is_turned = parameters.local_eye && of_spans;
    values.flag("turned", is_turned);
    values.flag("local_eye", parameters.local_eye);
    let follows_ways = follows_ways(spec);
    values.flag("ways", follows_ways);
    let lit_anyway = matches!(spec.method, MethodSpec::Direct(_) | MethodSpec::Slerp(_));
    values.flag("dark_without_normal", lit_anyway);
    let (of_span, of_light) = text.split_once("[light]\n").unwrap_or((text, ""));
    let mut whole = values.fill(include_str!("templates/methods/common.txt"));
    if follows_ways {
        whole.push_str(&values.fill(include_str!("templates/methods/ways.txt")));
    }
    whole.push_str(&values.fill(of_span));
    for index in 0..parameters.lights {
        values.set("I", index);
        let local = index.checked_sub(parameters.lights - parameters.local_lights.len());
        light(local.map(|local| parameters.local_lights[local]), is_turned, of_spans, &mut values);
        whole.push_str(&values.fill(include_str!("templates/methods/light.txt")));
        if follows_ways {
            whole.push_str(&values.fill(include_str!("templates/methods/light_way.txt")));
        }
        if parameters.attenuation_of(index).is_some() {
            whole.push_str(&values.fill(include_str!("templates/methods/attenuation.txt")));
        }
        whole.push_str(&values.fill(of_light));
    }
    // They are the program's own texts, and tests read all of them.
    Program::parse(&whole).expect("templates are programs")
}

/// Whether packets hold ways to places. `phong` has directions, and `gouraud` intensities.
fn follows_ways(spec: &CoreSpec) -> bool {
    spec.follows_ways() && !matches!(spec.method, MethodSpec::Phong(_))
}

/// What is filled in for a light, which may be at a place.
fn light(kind: Option<LocalKind>, is_turned: bool, of_spans: bool, values: &mut Values) {
    let is_spot = matches!(kind, Some(LocalKind::Spot { .. }));
    values.flag("distant", kind.is_none());
    values.flag("distant_still", kind.is_none() && !is_turned);
    values.flag("distant_turned", kind.is_none() && is_turned);
    values.flag("local", kind.is_some());
    values.flag("local_still", kind.is_some() && !is_turned);
    values.flag("local_turned", kind.is_some() && is_turned);
    values.flag("spot", is_spot);
    values.flag("point", kind.is_some() && !is_spot);
    values.flag("shared", kind.is_some() && of_spans);
}

/// The text of a method, and what is filled into it.
fn method(spec: &CoreSpec) -> (&'static str, Values) {
    let mut values = Values::default();
    values.set("EXPONENT_FACTOR", 1);
    values.flag("dark_opposite", false);
    values.flag("wrapped", false);
    values.flag("slerp_edges", false);
    let power = |values: &mut Values, unit: PowerUnit| {
        values.set("EXPONENT_FACTOR", 1 << unit.log2_factor);
    };
    let text = match &spec.method {
        MethodSpec::Lyon(lyon) => {
            let takes_unit = lyon.difference.takes_unit_halfway();
            let is_unit = takes_unit && lyon.halfway == Halfway::Unit;
            values.flag("dark_opposite", is_unit && !follows_ways(spec));
            values.flag("unit_halfway", is_unit);
            values.flag("plain_half", takes_unit && lyon.halfway == Halfway::Half);
            values.flag("half_g2", takes_unit && lyon.halfway == Halfway::HalfG2);
            values.flag("sum", lyon.difference.takes_halfway());
            values.flag("flat", lyon.normals == Normals::Flat);
            values.flag("linear", lyon.normals == Normals::Linear);
            values.flag("wrapped", lyon.normals == Normals::Wrapped);
            values.flag("face", lyon.axis == WrapAxis::Face);
            values.flag("bisector", lyon.axis != WrapAxis::Face);
            values.flag("follows", lyon.follows());
            values.flag("fixed", lyon.normals == Normals::Wrapped && !lyon.follows());
            values.set("ROOT_FACTOR", lyon.root_factor());
            values.set("SHARE_FACTOR", lyon.shininess_factor());
            include_str!("templates/methods/lyon.txt")
        }
        MethodSpec::Phong(phong) => {
            values.set("EXPONENT_FACTOR", phong.highlight.exponent_factor());
            include_str!("templates/methods/phong.txt")
        }
        MethodSpec::Hybrid(hybrid) => {
            power(&mut values, hybrid.power_unit());
            let parameters = &spec.parameters;
            let of_spans = spec.places_seen_from() == Viewpoint::Span;
            values.flag("places", parameters.has_places() && of_spans);
            include_str!("templates/methods/hybrid.txt")
        }
        MethodSpec::Duff(duff) => {
            power(&mut values, duff.power_unit());
            include_str!("templates/methods/duff.txt")
        }
        MethodSpec::Gouraud(gouraud) => {
            values.flag("linear", gouraud.interpolation == Interpolation::Linear);
            values.flag("uniform", gouraud.interpolation == Interpolation::Uniform);
            let highlight = match gouraud.highlight {
                Highlight::Power => "max(R.L, 0)^n".to_owned(),
                Highlight::FK => format!("f_{} of R - L", gouraud.squarings),
            };
            values.set("HIGHLIGHT", highlight);
            include_str!("templates/methods/gouraud.txt")
        }
        MethodSpec::Reflection(reflection) => {
            power(&mut values, reflection.power_unit());
            values.flag("triangle", reflection.bisector == Bisector::Triangle);
            include_str!("templates/methods/reflection.txt")
        }
        MethodSpec::Consistent(consistent) => {
            power(&mut values, consistent.power_unit());
            let is_blinn = consistent.highlight == consistent::Highlight::Blinn;
            values.flag("dark_opposite", is_blinn && !follows_ways(spec));
            values.set("HALF_A_STEP", 0.5 * consistent.formats.angle_accumulator.ulp());
            include_str!("templates/methods/consistent.txt")
        }
        MethodSpec::Slerp(slerp) => {
            power(&mut values, slerp.power_unit());
            values.flag("ends", slerp.between_ends());
            values.flag("vector", slerp.form == Form::Vector);
            values.flag("slerp_edges", slerp.edges == Edges::Slerp);
            include_str!("templates/methods/slerp.txt")
        }
        MethodSpec::Direct(direct) => {
            power(&mut values, direct.power_unit());
            include_str!("templates/methods/direct.txt")
        }
    };
    (text, values)
}
