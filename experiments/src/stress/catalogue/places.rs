//! Lights and eyes at places.
use glam::DVec3;
use specula_golden::exact::formula::normalisation::gain;
use specula_spec::lyon::Difference;
use specula_spec::phong::{Highlight, Places};
use specula_spec::{CoreSpec, LyonSpec, MethodSpec};

use crate::stress::draw::{Draw, tilted};
use crate::stress::row::{Case, CatalogueRow, Pixel, scenes};
use crate::stress::scene::{Light, RawSpan, SpanScene, lit, material};

/// A wall of five pixels from x = -2 to 2, seen from the front.
fn wall(lights: Vec<Light>, eye: Option<DVec3>) -> SpanScene {
    let mut span = RawSpan::between([DVec3::Z; 2], 5, material(0.0, 0.5, 0.5, 20));
    span.positions =
        [DVec3::new(-2.0, 0.0, 0.0), DVec3::new(2.0, 0.0, 0.0), DVec3::new(-2.0, 1.0, 0.0)];
    SpanScene { lights, eye, spans: vec![span], ..SpanScene::default() }
}

/// Whether the core has Phong's own highlight with true directions, as exact shading has.
fn is_phongs(spec: &CoreSpec) -> bool {
    match &spec.method {
        MethodSpec::Phong(phong) => {
            phong.highlight == Highlight::Reflection && phong.places == Places::Exact
        }
        _ => false,
    }
}

/// Whether the core has that highlight with wrapped directions, which are true only at the ends of
/// a span.
fn is_wrapped(spec: &CoreSpec) -> bool {
    match &spec.method {
        MethodSpec::Phong(phong) => {
            phong.highlight == Highlight::Reflection && phong.places == Places::Wrapped
        }
        _ => false,
    }
}

/// Whether the core sees places from every pixel, along directions of about unit length, and is to
/// have Phong's own highlight. `hybrid` sees so for its highlights alone.
fn follows_ways(spec: &CoreSpec) -> bool {
    let is_asked = match &spec.method {
        MethodSpec::Phong(_) | MethodSpec::Hybrid(_) => false,
        MethodSpec::Lyon(lyon) => {
            has_unit_ways(lyon, spec.parameters.shortest_way) && is_near_the_power(lyon)
        }
        _ => true,
    };
    spec.follows_ways() && is_asked
}

/// Whether what g1, g2 and Newton's steps make of the shortest direction is too long or too short by
/// 1 % at most.
fn has_unit_ways(lyon: &LyonSpec, shortest: f64) -> bool {
    (gain(lyon, shortest * shortest) * shortest - 1.0).abs() <= 0.01
}

/// Whether the shape is f_2 of H x N: others may differ from the power by more than is asked.
fn is_near_the_power(lyon: &LyonSpec) -> bool {
    lyon.difference == Difference::HalfwayCrossNormal && lyon.terms() == 4
}

/// Row 39.
pub const IN_THE_SURFACE: CatalogueRow = CatalogueRow {
    id: "39",
    input: "a light at the very pixel, F = P; an eye there",
    trial: scenes(|_, _| {
        // The light grazes the wall from within its plane.
        let dark = |pixel: &Pixel| pixel.code() == 0;
        let light = Case::new(wall(vec![Light::At(DVec3::ZERO)], None)).requiring(
            "nothing from a light at the pixel",
            is_phongs,
            dark,
        );
        let eye = Case::new(wall(vec![Light::At(DVec3::Z)], Some(DVec3::ZERO)));
        let diffuse_alone = |pixel: &Pixel| pixel.i != 2 || pixel.code() == 128;
        vec![light, eye.requiring("no highlight for an eye at the pixel", is_phongs, diffuse_alone)]
    }),
};

/// Row 40.
pub const FAR: CatalogueRow = CatalogueRow {
    id: "40",
    input: "a light 60 degrees aside, a quarter to ten thousand units away; spots and eyes anywhere",
    trial: scenes(|draw, extent| {
        let at = |distance: f64| {
            let near = |pixel: &Pixel| pixel.is_within(1.0, pixel.exact());
            let ends = |pixel: &Pixel| !pixel.is_end() || pixel.is_within(1.0, pixel.exact());
            Case::new(wall(vec![Light::At(distance * tilted(60.0))], None))
                .requiring("true directions: within 1 LSB of exact shading", is_phongs, near)
                .requiring("ways: within 3 LSB of exact shading", follows_ways, |pixel| {
                    pixel.is_within(3.0, pixel.exact())
                })
                .requiring(
                    "wrapped directions: within 1 LSB of exact shading at both ends",
                    is_wrapped,
                    ends,
                )
        };
        let fixed = [0.25, 1.0, 10.0, 1e4].map(at).into_iter();
        let random: Vec<Case> =
            (0..1 + extent.spans / 8).map(|_| Case::new(anywhere(draw, extent.longest))).collect();
        fixed.chain(random).collect()
    }),
};

/// What distance leaves.
pub const WEAKER: CatalogueRow = CatalogueRow {
    id: "weaker",
    input: "a light a quarter to ten units away that becomes weaker by the square of distance",
    trial: scenes(|_, _| {
        let at = |distance: f64| {
            let quadratic = 1.0 / (distance * distance);
            let light = Light::Weaker { position: distance * tilted(60.0), quadratic };
            let ends = |pixel: &Pixel| !pixel.is_end() || pixel.is_within(1.0, pixel.exact());
            Case::new(wall(vec![light], None)).requiring(
                "true directions: within 1 LSB of exact shading at both ends",
                is_phongs,
                ends,
            )
        };
        [0.25, 1.0, 10.0].map(at).into()
    }),
};

fn anywhere(draw: &mut Draw, longest: u32) -> SpanScene {
    let place = |draw: &mut Draw| draw.within(0.0, 5.0) * draw.direction();
    let span = |draw: &mut Draw| {
        let mut span = RawSpan::between(
            draw.ends(40.0, 60.0),
            draw.length(longest.min(300)),
            lit(draw.between(1, 300) as u32),
        );
        span.positions = [0, 1, 2].map(|_| place(draw));
        span
    };
    let spot = Light::Spot {
        position: place(draw),
        target: DVec3::ZERO,
        exponent: draw.between(1, 8191) as u32,
    };
    SpanScene {
        lights: vec![Light::Towards(draw.direction()), Light::At(place(draw)), spot],
        eye: draw.one_of(&[true, false]).then(|| place(draw)),
        spans: (0..8).map(|_| span(draw)).collect(),
        ..SpanScene::default()
    }
}
