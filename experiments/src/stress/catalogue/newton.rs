//! Newton iterations towards a length.
use specula_spec::lyon::Normals;
use specula_spec::{CoreSpec, Method, MethodSpec};

use super::scenes::{aimed, spans};
use crate::stress::draw::tilted;
use crate::stress::row::{Case, CatalogueRow, Pixel, PixelPlace, Shaded, Trial, all};
use crate::stress::scene::{RawSpan, SpanScene, lit, matt};
use crate::stress::variant::Variant;

fn steps() -> Vec<Variant> {
    let lyon =
        (0..=3).map(|n| Variant { method: Method::Lyon, table: format!("newton_steps = {n}\n") });
    lyon.chain(roots()).collect()
}

/// Variants with Newton's root, warm-started.
fn roots() -> impl Iterator<Item = Variant> {
    (1..=2).map(|n| Variant {
        method: Method::Direct,
        table: format!("root = \"newton\"\nnewton_steps = {n}\n"),
    })
}

/// Row 18.
pub const FIRST_PIXEL: CatalogueRow = CatalogueRow {
    id: "18",
    input: "90 degrees in 1, 2 and 3 steps; the first pixel of a span",
    trial: Trial::Scenes {
        cases: |_, _| {
            let span = |length| RawSpan::between([tilted(-45.0), tilted(45.0)], length, matt());
            let scene = SpanScene::new(&[tilted(30.0)], [2, 3, 4, 5].map(span).into());
            let what = "with two steps or more within 2 LSB of exact diffuse light everywhere";
            let first = |pixel: &Pixel| pixel.i > 0 || pixel.is_within(2.0, pixel.method());
            vec![
                Case::new(scene)
                    .requiring("the first pixel is the method's", all, first)
                    .requiring(what, has_two_steps, |pixel| pixel.is_within(2.0, pixel.exact())),
            ]
        },
        variants: steps,
    },
};

fn has_two_steps(spec: &CoreSpec) -> bool {
    match &spec.method {
        MethodSpec::Lyon(lyon) => lyon.normals == Normals::Linear && lyon.newton_steps >= 2,
        MethodSpec::Direct(direct) => direct.newton_steps >= 2,
        _ => false,
    }
}

/// Row 19.
pub const ALMOST_OPPOSITE: CatalogueRow = CatalogueRow {
    id: "19",
    input: "170 to 179.9 degrees: lengths near 0",
    trial: Trial::Scenes {
        cases: |draw, extent| {
            let span = |degrees: f64| {
                RawSpan::between([tilted(-degrees / 2.0), tilted(degrees / 2.0)], 65, lit(16))
            };
            let random = spans(draw, extent, [170.0, 179.9], lit);
            let fixed =
                SpanScene::new(&[tilted(20.0)], [170.0, 175.0, 179.0, 179.9].map(span).into());
            vec![Case::new(fixed), Case::new(aimed(draw, random))]
        },
        variants: steps,
    },
};

/// Row 20.
pub const NEW_SPAN: CatalogueRow = CatalogueRow {
    id: "20",
    input: "a span, then one of quite another length of normals, then the first again",
    trial: Trial::Scenes {
        cases: |draw, extent| {
            let mut all = spans(draw, extent, [0.0, 179.0], lit);
            all.truncate(12);
            let scene = aimed(draw, all.iter().chain(&all).cloned().collect());
            vec![Case::new(scene).requiring_frame(
                "the second time as the first: a span leaves nothing behind",
                crate::stress::row::all,
                first_that_differs,
            )]
        },
        variants: || roots().collect(),
    },
};

/// The first pixel of the second half of the spans that differs from its counterpart in the first
/// half.
fn first_that_differs(shaded: &Shaded) -> Option<PixelPlace> {
    let spans = &shaded.frame.spans;
    let half = spans.len() / 2;
    (half..spans.len()).find_map(|number| {
        let code = |number: usize, i| Pixel { shaded, span: &spans[number], i }.code();
        let differs = |&i: &u32| code(number, i) != code(number - half, i);
        (0..spans[number].length).find(differs).map(|pixel| PixelPlace { span: number, pixel })
    })
}
