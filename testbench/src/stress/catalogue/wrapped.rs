//! Normals reflected about a fixed one.
use glam::DVec3;
use specula_scene::spec::lyon::Normals;
use specula_scene::{Method, MethodSpec};

use super::super::draw::tilted;
use super::super::row::Pixel;
use super::super::scene::{lit, matt};
use super::{Case, RawSpan, Row, SpanScene, Trial, Variant, aimed, scenes, spans};

/// Row 7.
pub const OPPOSITE: Row = Row {
    id: "7",
    input: "the triangle's mean normal n = -N0 exactly; and ends that are opposite",
    wanted: "no division by 0; the span's own bisector instead, and N0 at the first pixel",
    trial: scenes(|_, _| {
        let mut span = RawSpan::between([DVec3::Z, tilted(150.0)], 20, matt());
        span.normals[2] = tilted(-150.0);
        let ends = RawSpan::between([DVec3::Z, -DVec3::Z], 33, lit(16));
        vec![
            Case::wanting(SpanScene::new(&[DVec3::Z], vec![span]), first_is_right),
            Case::new(SpanScene::new(&[tilted(10.0)], vec![ends])),
        ]
    }),
};

/// Row 8.
pub const BEHIND: Row = Row {
    id: "8",
    input: "the triangle's mean normal more than 90 degrees from a vertex's: it would come out 180 degrees wrong",
    wanted: "the span's own bisector instead, and the right normal at both ends",
    trial: scenes(|_, _| {
        let mut span = RawSpan::between([tilted(0.0), tilted(110.0)], 20, matt());
        span.normals[2] = tilted(-100.0);
        vec![Case::wanting(SpanScene::new(&[tilted(55.0)], vec![span]), ends_are_right)]
    }),
};

/// Row 9.
pub const NEARLY_OPPOSITE: Row = Row {
    id: "9",
    input: "ends opposite but for 1 degree to a millionth",
    wanted: "the fall-back of row 8, or ambient light alone",
    trial: scenes(|draw, extent| {
        let nearly = |degrees| RawSpan::between([DVec3::Z, tilted(degrees)], 50, matt());
        let fixed = SpanScene::new(&[tilted(90.0)], [179.0, 179.9, 179.99, 179.999_94].map(nearly).into());
        let random = spans(draw, extent, [179.0, 179.999_999], lit);
        vec![Case::new(fixed), Case::new(aimed(draw, random))]
    }),
};

/// Row 10.
pub const ITSELF: Row = Row {
    id: "10",
    input: "n = N along every axis: H.H = 4 exactly",
    wanted: "255, and no overflow",
    trial: scenes(|_, _| {
        let case = |&axis: &DVec3| {
            let scene = SpanScene::new(&[axis], vec![RawSpan::between([axis; 2], 300, matt())]);
            Case::wanting(scene, |pixel| pixel.code() == 255)
        };
        super::super::draw::AXES.iter().map(case).collect()
    }),
};

/// Row 11.
pub const CHAINED: Row = Row {
    id: "11",
    input: "90 and 150 degrees in 1, 2, 4 and 8 steps",
    wanted: "the normals at both ends are right; normals that would be wrapped around those before are wrapped around the bisector",
    trial: Trial::Scenes {
        cases: |_, _| {
            let span = |(degrees, length): (f64, u32)| RawSpan::between([tilted(0.0), tilted(degrees)], length, matt());
            let all = [90.0, 150.0].iter().flat_map(|&degrees| [2, 3, 5, 9].map(|length| span((degrees, length))));
            vec![Case::wanting(SpanScene::new(&[tilted(40.0)], all.collect()), wrapped_ends_are_right)]
        },
        variants: || vec![Variant { method: Method::Lyon, table: PREVIOUS.into() }],
    },
};

/// Wrapped around the normal of the pixel before.
const PREVIOUS: &str = "normals = \"wrapped\"\naxis = \"previous\"\n";

fn wrapped_ends_are_right(pixel: &Pixel) -> bool {
    let is_wrapped = matches!(&pixel.shaded.spec.method, MethodSpec::Lyon(lyon) if lyon.normals == Normals::Wrapped);
    !is_wrapped || !pixel.is_end() || pixel.is_within(1.0, pixel.exact())
}

/// What row 11 leaves to methods that chain: 16 steps and more.
pub const FOLLOWING: Row = Row {
    id: "11b",
    input: "normals wrapped around those before: 30, 90 and 120 degrees in 16 steps and more, and random spans",
    wanted: "30 degrees and 256 steps of 90 within a code of exact diffuse light; the others within what NUMERICS 2b has, 1.5 degrees, as codes",
    trial: Trial::Scenes {
        cases: |draw, extent| {
            let of = |degrees: f64, length: u32| RawSpan::between([tilted(0.0), tilted(degrees)], length, matt());
            let right = SpanScene::new(&[tilted(15.0)], vec![of(30.0, 17), of(30.0, 200), of(90.0, 257)]);
            let near = SpanScene::new(&[tilted(40.0)], vec![of(90.0, 17), of(90.0, 65)]);
            let within = |lsb: f64| move |pixel: &Pixel| !follows(pixel) || pixel.is_within(lsb, pixel.exact());
            let random = spans(draw, extent, [0.0, 121.0], lit);
            vec![
                Case::wanting(right, within(1.0)),
                // 1.5 degrees of the cosine's steepest slope.
                Case::wanting(near, within(255.0 * 1.5_f64.to_radians() + 1.0)),
                Case::new(aimed(draw, random)),
            ]
        },
        variants: || vec![Variant { method: Method::Lyon, table: PREVIOUS.into() }],
    },
};

fn follows(pixel: &Pixel) -> bool {
    matches!(&pixel.shaded.spec.method, MethodSpec::Lyon(lyon) if lyon.follows())
}

fn first_is_right(pixel: &Pixel) -> bool {
    pixel.shaded.spec.method() != Method::Reflection || pixel.i > 0 || pixel.is_within(1.0, pixel.exact())
}

fn ends_are_right(pixel: &Pixel) -> bool {
    pixel.shaded.spec.method() != Method::Reflection || !pixel.is_end() || pixel.is_within(1.0, pixel.exact())
}
