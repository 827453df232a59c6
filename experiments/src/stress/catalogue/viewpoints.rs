//! Lights and eyes behind the surface, in its plane, and opposite each other.
use std::f64::consts::PI;

use glam::DVec3;
use specula_spec::lyon::{Difference, Halfway};
use specula_spec::phong::Highlight;
use specula_spec::{CoreSpec, Method, MethodSpec};

use crate::stress::draw::{tilted, turned};
use crate::stress::row::{Case, CatalogueRow, Pixel, all, scenes};
use crate::stress::scene::{RawSpan, SpanScene, lit, material, matt, mirror};

/// Row 12.
pub const OPPOSITE_LIGHT: CatalogueRow = CatalogueRow {
    id: "12",
    input: "L = -V: no half-way vector",
    trial: scenes(|_, _| {
        let span = |n| RawSpan::between([tilted(10.0), tilted(20.0)], 8, mirror(n));
        let scene = SpanScene::new(&[-DVec3::Z], [4, 16].map(span).into());
        let is_asked = |spec: &CoreSpec| {
            matches!(spec.method(), Method::Lyon | Method::Phong | Method::Hybrid | Method::Duff)
        };
        let what = "lyon's H x N gives 255 and 0 with the unit half-way vector, phong's lobes 0, 0, 255 exp(-n pi^2/2) and 255/(1 + n)^2, p/q 0";
        vec![Case::new(scene).requiring(what, is_asked, |pixel| {
            wanted_at_opposite(pixel).is_none_or(|code| pixel.code() == code)
        })]
    }),
};

/// The code that a core must give where L = -V, if docs/extremes.md states one.
fn wanted_at_opposite(pixel: &Pixel) -> Option<u8> {
    let n = f64::from(pixel.shaded.frame.material(pixel.span).shininess);
    match &pixel.shaded.spec.method {
        MethodSpec::Lyon(lyon) => match (lyon.difference, lyon.halfway) {
            (Difference::HalfwayCrossNormal, _) => Some(255),
            (
                Difference::UnitHalfwayMinusNormal | Difference::UnitHalfwayProjection,
                Halfway::Unit,
            ) => Some(0),
            _ => None,
        },
        MethodSpec::Phong(phong) => match phong.highlight {
            Highlight::Reflection | Highlight::Blinn => Some(0),
            Highlight::TorranceSparrow => Some((255.0 * (-n * PI * PI / 2.0).exp()).round() as u8),
            Highlight::TrowbridgeReitz => Some((255.0 / ((1.0 + n) * (1.0 + n))).round() as u8),
        },
        MethodSpec::Hybrid(_) | MethodSpec::Duff(_) => Some(0),
        _ => None,
    }
}

/// Row 32.
pub const LIGHT_BEHIND: CatalogueRow = CatalogueRow {
    id: "32",
    input: "the light behind the surface, N.L = -0.02",
    trial: scenes(|_, _| {
        let scene = |material| {
            SpanScene::new(&[tilted(151.0)], vec![RawSpan::between([tilted(60.0); 2], 2, material)])
        };
        let lit = |pixel: &Pixel| pixel.method() < 100.0 || pixel.code() >= 99;
        vec![
            Case::new(scene(matt())).requiring("no diffuse light", all, |pixel| pixel.code() == 0),
            Case::new(scene(mirror(4))).requiring(
                "the highlight is not gated, where the method has it",
                all,
                lit,
            ),
        ]
    }),
};

/// Row 33.
pub const EYE_BEHIND: CatalogueRow = CatalogueRow {
    id: "33",
    input: "the eye in the surface's plane and behind it, V.N from 0.09 to -1",
    trial: scenes(|draw, extent| {
        let span = |degrees: f64| {
            RawSpan::between([tilted(degrees - 5.0), tilted(degrees + 5.0)], 33, lit(16))
        };
        let fixed = [85.0, 90.0, 95.0, 120.0, 180.0].into_iter();
        let random: Vec<f64> = (0..extent.spans).map(|_| draw.within(85.0, 180.0)).collect();
        let case = |light: f64, spans: Vec<RawSpan>| {
            Case::new(SpanScene::new(&[tilted(2.0 * light)], spans))
        };
        fixed
            .map(|degrees| case(degrees, vec![span(degrees)]))
            .chain([case(100.0, random.into_iter().map(span).collect())])
            .collect()
    }),
};

/// Row 34.
pub const GRAZING: CatalogueRow = CatalogueRow {
    id: "34",
    input: "L = (1, 1, -1)/sqrt 3 at its own half-way normal, and lights within 0.1 degrees of the surface's plane",
    trial: scenes(|draw, extent| {
        let light = DVec3::new(1.0, 1.0, -1.0).normalize();
        let halfway = (light + DVec3::Z).normalize();
        let spans = [1, 16, 64, 256].map(|n| RawSpan::between([halfway; 2], 2, mirror(n)));
        let kept = |pixel: &Pixel| pixel.method() < 254.5 || pixel.code() >= 254;
        let plane = |degrees: f64| {
            let span = RawSpan::between([tilted(-1.0), tilted(1.0)], 21, matt());
            Case::new(SpanScene::new(&[tilted(degrees), tilted(-degrees)], vec![span]))
        };
        let fixed = [89.9, 89.999, 90.0, 90.001, 90.1].into_iter();
        let random: Vec<f64> = (0..extent.spans / 8).map(|_| draw.within(89.9, 90.1)).collect();
        let planes = fixed.chain(random).map(plane);
        let highlights = Case::new(SpanScene::new(&[light], spans.into()));
        let highlights = highlights.requiring(
            "the highlight is kept, where the method has it in exact arithmetic",
            all,
            kept,
        );
        [highlights].into_iter().chain(planes).collect()
    }),
};

/// Row 35.
pub const NEARLY_OPPOSITE_LIGHT: CatalogueRow = CatalogueRow {
    id: "35",
    input: "L opposite V but for 10 degrees to a thousandth",
    trial: scenes(|draw, extent| {
        let case = |degrees: f64| {
            let span = |n| {
                RawSpan::between(
                    [tilted(degrees / 2.0 - 5.0), tilted(degrees / 2.0 + 4.0)],
                    50,
                    material(0.1, 0.3, 0.6, n),
                )
            };
            Case::new(SpanScene::new(&[tilted(degrees)], [1, 64, 1024].map(span).into()))
        };
        let random = (0..extent.spans / 8).map(|_| draw.within(170.0, 180.0)).collect::<Vec<f64>>();
        let about = turned(-DVec3::Z, draw.within(0.0, 0.1), draw.unit());
        let skew = SpanScene::new(
            &[about],
            vec![RawSpan::between([tilted(80.0), tilted(95.0)], 40, lit(64))],
        );
        [170.0, 179.0, 179.9, 179.999]
            .into_iter()
            .chain(random)
            .map(case)
            .chain([Case::new(skew)])
            .collect()
    }),
};
