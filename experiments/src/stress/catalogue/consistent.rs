//! Consistent normal interpolation.
use glam::DVec3;
use specula_spec::consistent::{Diffuse, Highlight};
use specula_spec::{CoreSpec, Method, MethodSpec};

use super::scenes::{aimed, spans};
use crate::stress::draw::{Draw, tilted};
use crate::stress::row::{Case, CatalogueRow, Pixel, Trial, TrialExtent};
use crate::stress::scene::{RawSpan, SpanScene, lit, material, matt, mirror};
use crate::stress::variant::Variant;

/// Variants with both curves, each with both kinds of diffuse light, and with Blinn's highlight.
fn forms() -> Vec<Variant> {
    let form = |(curve, diffuse)| {
        let table = format!("curve = \"{curve}\"\ndiffuse = \"{diffuse}\"\n");
        Variant { method: Method::Consistent, table }
    };
    ["rational", "trigonometric"]
        .iter()
        .flat_map(|curve| ["lambert", "consistent"].map(|diffuse| (*curve, diffuse)))
        .map(form)
        .chain([Variant {
            method: Method::Consistent,
            table: "highlight = \"blinn\"\ndiffuse = \"consistent\"\n".to_owned(),
        }])
        .collect()
}

const fn trial(cases: fn(&mut Draw, TrialExtent) -> Vec<Case>) -> Trial {
    Trial::Scenes { cases, variants: forms }
}

/// A span with one normal among faces at an angle with the given `cosine`.
fn flat(normal: DVec3, cosine: f64, material: specula_scene::Material) -> RawSpan {
    RawSpan { cone_cosines: [cosine; 3], ..RawSpan::between([normal; 2], 2, material) }
}

fn is_consistent_diffuse(spec: &CoreSpec) -> bool {
    matches!(&spec.method, MethodSpec::Consistent(spec) if spec.diffuse == Diffuse::Consistent)
}

fn has_highlight(spec: &CoreSpec, highlight: Highlight) -> bool {
    matches!(&spec.method, MethodSpec::Consistent(spec) if spec.highlight == highlight)
}

fn has_reflection(spec: &CoreSpec) -> bool {
    has_highlight(spec, Highlight::Reflection)
}

fn is_consistent(spec: &CoreSpec) -> bool {
    spec.method() == Method::Consistent
}

/// Row 41.
pub const HORIZON: CatalogueRow = CatalogueRow {
    id: "41",
    input: "r = -I: a light on the horizon and behind it, where N_c is 0/0",
    trial: trial(|_, _| {
        let case = |(degrees, cosine)| {
            let scene = SpanScene::new(&[tilted(degrees)], vec![flat(DVec3::Z, cosine, matt())]);
            Case::new(scene).requiring(
                "consistent diffuse light is 0",
                is_consistent_diffuse,
                |pixel| pixel.code() == 0,
            )
        };
        [(90.0, 1.0), (120.0, 0.9), (180.0, 0.5), (180.0, 0.0)].map(case).into()
    }),
};

/// Row 42.
pub const QUARTER_TURN: CatalogueRow = CatalogueRow {
    id: "42",
    input: "al = pi/2 and b = -1: rho is 0/0",
    trial: trial(|_, _| {
        let scene = SpanScene::new(&[-DVec3::Z], vec![flat(-DVec3::Z, 0.0, mirror(1))]);
        let is_blinns = |spec: &CoreSpec| has_highlight(spec, Highlight::Blinn);
        let case = Case::new(scene)
            .requiring("255: r = N, with the light there", has_reflection, |pixel| {
                pixel.code() == 255
            })
            .requiring(
                "0 by Blinn's highlight: L = -V has no half-way vector",
                is_blinns,
                |pixel| pixel.code() == 0,
            );
        vec![case]
    }),
};

/// Row 43.
pub const ABOVE: CatalogueRow = CatalogueRow {
    id: "43",
    input: "b = 1, the eye straight above, cones of 0 to 90 degrees",
    trial: trial(|_, _| {
        let all = [1.0, 0.9, 0.5, 0.1, 0.0]
            .iter()
            .flat_map(|&cosine| [mirror(1), matt()].map(|m| flat(DVec3::Z, cosine, m)));
        let scene = SpanScene::new(&[DVec3::Z], all.collect());
        vec![Case::new(scene).requiring(
            "255: r = N and N_c.I = 1 exactly",
            is_consistent,
            |pixel| pixel.code() == 255,
        )]
    }),
};

/// Row 44.
pub const FLAT: CatalogueRow = CatalogueRow {
    id: "44",
    input: "al = 0: flat surroundings",
    trial: trial(|draw, extent| {
        let tilts = [0.0, 20.0, 60.0, 80.0]
            .into_iter()
            .chain((0..extent.spans).map(|_| draw.within(0.0, 80.0)));
        let all = tilts.map(|degrees| flat(tilted(degrees), 1.0, mirror(16))).collect();
        let scene = SpanScene::new(&[tilted(50.0)], all);
        let plain = |pixel: &Pixel| pixel.is_within(1.0, pixel.exact());
        vec![Case::new(scene).requiring(
            "the plain reflection: within 1 LSB of exact shading",
            has_reflection,
            plain,
        )]
    }),
};

/// Row 45.
pub const BEYOND_A_QUARTER: CatalogueRow = CatalogueRow {
    id: "45",
    input: "vertices whose angles exceed 90 degrees once enlarged",
    trial: trial(|draw, extent| {
        let one = |cosine: f64| RawSpan {
            cone_cosines: [cosine, 1.0, 0.0],
            ..RawSpan::between([tilted(-20.0), tilted(30.0)], 40, lit(16))
        };
        let cosines = [0.0, 0.05, 0.0775]
            .into_iter()
            .chain((0..extent.spans).map(|_| draw.within(0.0, 0.09)));
        vec![Case::new(SpanScene::new(&[tilted(40.0), tilted(-60.0)], cosines.map(one).collect()))]
    }),
};

/// Row 46.
pub const FROM_BEHIND: CatalogueRow = CatalogueRow {
    id: "46",
    input: "I from behind the surface, b = -0.99 and al = 0.3: rho is 7",
    trial: trial(|draw, extent| {
        let degrees = libm::acos(-0.99).to_degrees();
        let random =
            (0..extent.spans).map(|_| (draw.within(91.0, 180.0), draw.unit())).collect::<Vec<_>>();
        let one = |(degrees, cosine)| flat(tilted(degrees), cosine, lit(4));
        let all = [(degrees, libm::cos(0.3))].into_iter().chain(random).map(one).collect();
        vec![Case::new(SpanScene::new(&[DVec3::Z, tilted(170.0)], all))]
    }),
};

/// Row 47.
pub const TRIGONOMETRIC: CatalogueRow = CatalogueRow {
    id: "47",
    input: "the trigonometric curve at 62 degrees and u = 0.75, seen grazing: n.r = -0.0085 with the printed constant",
    trial: trial(|draw, extent| {
        let span = |degrees: f64| {
            let cosine = libm::cos(degrees.to_radians());
            RawSpan {
                cone_cosines: [1.0, cosine, 1.0],
                ..RawSpan::between([tilted(90.0), tilted(90.0 - degrees)], 5, lit(16))
            }
        };
        let all = [62.0]
            .into_iter()
            .chain((0..extent.spans).map(|_| draw.within(40.0, 80.0)))
            .map(span)
            .collect();
        vec![Case::new(SpanScene::new(&[tilted(85.0)], all))]
    }),
};

/// Row 48.
pub const WIDE_CONES: CatalogueRow = CatalogueRow {
    id: "48",
    input: "vertex normals 90 degrees and more from a face around them",
    trial: trial(|draw, extent| {
        let mut random = spans(draw, extent, [0.0, 120.0], lit);
        random
            .iter_mut()
            .for_each(|span| span.cone_cosines = [0, 1, 2].map(|_| draw.within(-1.0, 0.1)));
        vec![Case::new(aimed(draw, random))]
    }),
};

/// Row 49.
pub const VANISHING: CatalogueRow = CatalogueRow {
    id: "49",
    input: "vertex normals in the face's plane, opposite",
    trial: trial(|_, _| {
        let span = RawSpan {
            cone_cosines: [0.0; 3],
            ..RawSpan::between([DVec3::X, -DVec3::X], 3, material(0.2, 0.4, 0.4, 4))
        };
        let ambient = |pixel: &Pixel| pixel.i != 1 || pixel.code() == pixel.ambient();
        let scene = SpanScene::new(&[tilted(30.0), -DVec3::Z], vec![span]);
        vec![Case::new(scene).requiring(
            "ambient light alone in the middle",
            is_consistent,
            ambient,
        )]
    }),
};
