//! The angles of arcs.
use std::f64::consts::PI;

use glam::DVec3;
use specula_spec::{CoreSpec, FULL_SCALE, Method, MethodSpec, SlerpSpec};

use super::scenes::{aimed, flat_from_end_to_end, spans};
use crate::stress::draw::{AXES, Draw, tilted, turned};
use crate::stress::row::{
    Case, CatalogueRow, Pixel, PixelPlace, Shaded, Trial, TrialExtent, scenes,
};
use crate::stress::scene::{RawSpan, SpanScene, lit, material, matt};
use crate::stress::variant::Variant;

/// Variants that compute the normal itself, in both frames.
fn vectors() -> Vec<Variant> {
    let table = |frame: &str| format!("form = \"vector\"\nframe = \"{frame}\"\n");
    ["orthonormal", "ends"]
        .map(|frame| Variant { method: Method::Slerp, table: table(frame) })
        .into()
}

/// A trial of scenes with every method, and with slerp of the normal itself.
const fn of_vectors(cases: fn(&mut Draw, TrialExtent) -> Vec<Case>) -> Trial {
    Trial::Scenes { cases, variants: vectors }
}

/// Row 13.
pub const NO_ANGLE: CatalogueRow = CatalogueRow {
    id: "13",
    input: "N0 = N1: sin f = 0",
    trial: of_vectors(|_, _| {
        let span = |length| RawSpan::between([tilted(33.0); 2], length, lit(64));
        let scene = SpanScene::new(&[tilted(50.0)], [2, 17, 1000].map(span).into());
        vec![flat_from_end_to_end(scene).requiring(SLERP_IS_EXACT, is_slerp, slerp_is_exact)]
    }),
};

/// Row 14.
pub const HALF_A_TURN: CatalogueRow = CatalogueRow {
    id: "14",
    input: "N0 = -N1: an arc in any plane",
    trial: of_vectors(|_, _| {
        let case = |first: DVec3| {
            let span = |length| RawSpan::between([first, -first], length, matt());
            Case::new(SpanScene::new(&[first], [2, 3, 65].map(span).into())).requiring(
                "an arc at a steady pace, in one of the planes through both",
                is_slerp,
                turns_steadily,
            )
        };
        AXES.iter().copied().chain([tilted(40.0), -tilted(70.0)]).map(case).collect()
    }),
};

fn turns_steadily(pixel: &Pixel) -> bool {
    let angle = PI * f64::from(pixel.i) / f64::from(pixel.span.length - 1);
    pixel.is_within(1.0, 255.0 * libm::cos(angle).max(0.0))
}

fn is_slerp(spec: &CoreSpec) -> bool {
    spec.method() == Method::Slerp
}

/// Row 15.
pub const SMALL_ANGLE: CatalogueRow = CatalogueRow {
    id: "15",
    input: "0.01 degrees and less, which an arc cosine of a rounded cosine loses; 0 to 10 degrees",
    trial: of_vectors(|draw, extent| {
        let span =
            |degrees: f64| RawSpan::between([tilted(10.0), tilted(10.0 + degrees)], 250, lit(256));
        let random = [0.0, 1e-3, 0.1, 3.0].map(|_| draw.within(0.0, 10.0)).map(span);
        let fixed = [0.0, 1e-9, 1e-5, 0.01, 9.9, 10.1].map(span);
        let all = fixed.into_iter().chain(random).collect();
        let many = spans(draw, extent, [0.0, 10.0], lit);
        let fixed = Case::new(SpanScene::new(&[tilted(21.0)], all)).requiring(
            SLERP_IS_EXACT,
            is_slerp,
            slerp_is_exact,
        );
        vec![fixed, Case::new(aimed(draw, many))]
    }),
};

const SLERP_IS_EXACT: &str = "within 1 LSB of exact shading, and what a chord leaves of a highlight where it is one (2.5 LSB at n = 256)";

fn slerp_is_exact(pixel: &Pixel) -> bool {
    match &pixel.shaded.spec.method {
        MethodSpec::Slerp(slerp) => pixel.is_within(1.0 + chord(slerp, pixel.n()), pixel.exact()),
        _ => true,
    }
}

/// The error that a chord of 10 degrees leaves between the ends, in LSBs: its length is 1 - 3/8 y²,
/// y = sin² 5°, which the base takes twice and the highlight n times. The normal is also wrong by
/// .0049 degrees, which is within a code.
fn chord(slerp: &SlerpSpec, n: u32) -> f64 {
    let y = libm::sin(5f64.to_radians()).powi(2);
    let [.., specular] = lit(n).specular;
    if slerp.between_ends() {
        FULL_SCALE * specular * f64::from(n) * 4.0 * 0.375 * y * y
    } else {
        0.0
    }
}

/// Row 16.
pub const FROZEN: CatalogueRow = CatalogueRow {
    id: "16",
    input: "1 degree in 16 steps with 8 fraction bits: the sine of a step rounds to 0",
    trial: Trial::Scenes {
        cases: |_, _| {
            let span = RawSpan::between([tilted(44.0), tilted(45.0)], 17, matt());
            // A frozen normal stays where it is, and is wrong by up to 1 degree.
            let frozen = 255.0 * 1f64.to_radians() + 1.0;
            let near = move |pixel: &Pixel| pixel.is_within(frozen, pixel.exact());
            let what = "no farther than a degree of exact diffuse light, 5.5 LSB";
            vec![
                Case::new(SpanScene::new(&[DVec3::Z], vec![span]))
                    .requiring(what, is_slerp, near)
                    .with_figure(is_slerp, frozen),
            ]
        },
        variants: || {
            let formats = ["turn = \"S1.8\"", "state = \"S1.8\"", "weight = \"S1.8\""]
                .map(|f| format!("formats.{f}\n"))
                .concat();
            let vector = format!("form = \"vector\"\n{formats}");
            [formats, vector].map(|table| Variant { method: Method::Slerp, table }).into()
        },
    },
};

/// Row 17.
pub const ORIENTATION: CatalogueRow = CatalogueRow {
    id: "17",
    input: "the middle of a triangle of 30, 60 and 90 degrees, scanned along its three medians",
    trial: scenes(|_, _| {
        let angles = [30.0, 60.0, 90.0];
        let scene = SpanScene::new(
            &[tilted(35.0)],
            angles.iter().flat_map(|&degrees| medians(degrees)).collect(),
        );
        let is_lerp = |spec: &CoreSpec| spec.method() == Method::Phong;
        vec![Case::new(scene).requiring_frame(
            "one code in the middle, whichever way it is scanned",
            is_lerp,
            centres_disagree,
        )]
    }),
};

/// Spans from the middle of each side of a triangle to the opposite vertex; the triangle's own
/// middle is the second of four pixels.
fn medians(degrees: f64) -> [RawSpan; 3] {
    // Three unit vectors about z that are `degrees` apart: 3/2 sin² = 1 - cos.
    let tilt = libm::asin(((1.0 - libm::cos(degrees.to_radians())) / 1.5).sqrt());
    let about = |k: usize| turned(DVec3::Z, tilt, k as f64 / 3.0);
    [0, 1, 2].map(|first| {
        let mut span = RawSpan::between([DVec3::Z; 2], 4, material(0.0, 1.0, 0.0, 1));
        span.normals = [0, 1, 2].map(|k| about((first + k) % 3));
        (span.start, span.end) = ([0.5, 0.5, 0.0], [0.0, 0.0, 1.0]);
        span
    })
}

fn centres_disagree(shaded: &Shaded) -> Option<PixelPlace> {
    let code = |number: usize| Pixel { shaded, span: &shaded.frame.spans[number], i: 1 }.code();
    let differs = |number: &usize| code(*number).abs_diff(code(number / 3 * 3)) > 1;
    (0..shaded.frame.spans.len()).find(differs).map(|span| PixelPlace { span, pixel: 1 })
}

/// Row 36.
pub const ARC_COSINE: CatalogueRow = CatalogueRow {
    id: "36",
    input: "normals whose dot product rounds to 1 and beyond",
    trial: of_vectors(|draw, extent| {
        let one = |direction: DVec3| {
            let other = (direction + 1e-16 * DVec3::new(1.0, -1.0, 0.5)).normalize();
            RawSpan::between([direction, other], 20, lit(64))
        };
        let directions = (0..8 + extent.spans).map(|_| draw.direction());
        let all = directions.map(one).collect();
        vec![Case::new(SpanScene::new(&[tilted(20.0)], all)).requiring(
            "one code from end to end, or the next to it",
            crate::stress::row::all,
            |pixel| pixel.code().abs_diff(Pixel { i: 0, ..*pixel }.code()) <= 1,
        )]
    }),
};
