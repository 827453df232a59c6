//! Normals reflected about a fixed one.
use glam::DVec3;
use specula_spec::lyon::Normals;
use specula_spec::{CoreSpec, Method, MethodSpec};

use super::scenes::{aimed, spans};
use crate::stress::draw::{AXES, tilted};
use crate::stress::row::{Case, CatalogueRow, Pixel, Trial, all, scenes};
use crate::stress::scene::{RawSpan, SpanScene, lit, matt};
use crate::stress::variant::Variant;

/// Row 7.
pub const OPPOSITE: CatalogueRow = CatalogueRow {
    id: "7",
    input: "the triangle's mean normal n = -N0 exactly; and ends that are opposite",
    trial: scenes(|_, _| {
        let mut span = RawSpan::between([DVec3::Z, tilted(150.0)], 20, matt());
        span.normals[2] = tilted(-150.0);
        let ends = RawSpan::between([DVec3::Z, -DVec3::Z], 33, lit(16));
        vec![
            Case::new(SpanScene::new(&[DVec3::Z], vec![span])).requiring(
                "N0 at the first pixel, within 1 LSB",
                is_reflection,
                first_is_right,
            ),
            Case::new(SpanScene::new(&[tilted(10.0)], vec![ends])),
        ]
    }),
};

/// Row 8.
pub const BEHIND: CatalogueRow = CatalogueRow {
    id: "8",
    input: "the triangle's mean normal more than 90 degrees from a vertex's: it would come out 180 degrees wrong",
    trial: scenes(|_, _| {
        let mut span = RawSpan::between([tilted(0.0), tilted(110.0)], 20, matt());
        span.normals[2] = tilted(-100.0);
        let scene = SpanScene::new(&[tilted(55.0)], vec![span]);
        vec![Case::new(scene).requiring(
            "the right normal at both ends, within 1 LSB",
            is_reflection,
            ends_are_right,
        )]
    }),
};

/// Row 9.
pub const NEARLY_OPPOSITE: CatalogueRow = CatalogueRow {
    id: "9",
    input: "ends opposite but for 1 degree to a millionth",
    trial: scenes(|draw, extent| {
        let nearly = |degrees| RawSpan::between([DVec3::Z, tilted(degrees)], 50, matt());
        let fixed =
            SpanScene::new(&[tilted(90.0)], [179.0, 179.9, 179.99, 179.999_94].map(nearly).into());
        let random = spans(draw, extent, [179.0, 179.999_999], lit);
        vec![Case::new(fixed), Case::new(aimed(draw, random))]
    }),
};

/// Row 10.
pub const ITSELF: CatalogueRow = CatalogueRow {
    id: "10",
    input: "n = N along every axis: H.H = 4 exactly",
    trial: scenes(|_, _| {
        let case = |&axis: &DVec3| {
            let scene = SpanScene::new(&[axis], vec![RawSpan::between([axis; 2], 300, matt())]);
            Case::new(scene).requiring("255", all, |pixel| pixel.code() == 255)
        };
        AXES.iter().map(case).collect()
    }),
};

/// Row 11.
pub const CHAINED: CatalogueRow = CatalogueRow {
    id: "11",
    input: "90 and 150 degrees in 1, 2, 4 and 8 steps",
    trial: Trial::Scenes {
        cases: |_, _| {
            let span = |(degrees, length): (f64, u32)| {
                RawSpan::between([tilted(0.0), tilted(degrees)], length, matt())
            };
            let all = [90.0, 150.0]
                .iter()
                .flat_map(|&degrees| [2, 3, 5, 9].map(|length| span((degrees, length))));
            let scene = SpanScene::new(&[tilted(40.0)], all.collect());
            vec![Case::new(scene).requiring(
                "the right normals at both ends, within 1 LSB",
                is_wrapped,
                ends_are_right,
            )]
        },
        variants: || vec![Variant { method: Method::Lyon, table: PREVIOUS.into() }],
    },
};

/// Options for normals wrapped around the normal of the previous pixel.
const PREVIOUS: &str = "normals = \"wrapped\"\naxis = \"previous\"\n";

fn is_wrapped(spec: &CoreSpec) -> bool {
    matches!(&spec.method, MethodSpec::Lyon(lyon) if lyon.normals == Normals::Wrapped)
}

/// The part of row 11 for methods that chain: 16 steps and more.
pub const FOLLOWING: CatalogueRow = CatalogueRow {
    id: "11b",
    input: "normals wrapped around those before: 30, 90 and 120 degrees in 16 steps and more, and random spans",
    trial: Trial::Scenes {
        cases: |draw, extent| {
            let of = |degrees: f64, length: u32| {
                RawSpan::between([tilted(0.0), tilted(degrees)], length, matt())
            };
            let right =
                SpanScene::new(&[tilted(15.0)], vec![of(30.0, 17), of(30.0, 200), of(90.0, 257)]);
            let near = SpanScene::new(&[tilted(40.0)], vec![of(90.0, 17), of(90.0, 65)]);
            let within = |lsb: f64| move |pixel: &Pixel| pixel.is_within(lsb, pixel.exact());
            // The error is 1.5 degrees times the cosine's steepest slope.
            let wide = 255.0 * 1.5_f64.to_radians() + 1.0;
            let random = spans(draw, extent, [0.0, 121.0], lit);
            vec![
                Case::new(right).requiring(
                    "30 degrees, and 256 steps of 90: within 1 LSB of exact diffuse light",
                    follows,
                    within(1.0),
                ),
                Case::new(near).requiring(
                    "16 and 64 steps of 90 degrees: within 1.5 degrees, 7.7 LSB (numerics N2b)",
                    follows,
                    within(wide),
                ),
                Case::new(aimed(draw, random)),
            ]
        },
        variants: || vec![Variant { method: Method::Lyon, table: PREVIOUS.into() }],
    },
};

fn follows(spec: &CoreSpec) -> bool {
    matches!(&spec.method, MethodSpec::Lyon(lyon) if lyon.follows())
}

fn is_reflection(spec: &CoreSpec) -> bool {
    spec.method() == Method::Reflection
}

fn first_is_right(pixel: &Pixel) -> bool {
    pixel.i > 0 || pixel.is_within(1.0, pixel.exact())
}

fn ends_are_right(pixel: &Pixel) -> bool {
    !pixel.is_end() || pixel.is_within(1.0, pixel.exact())
}
