//! What breaks first [numerics N4]: the papers' own formats, where they are too short. The core is
//! as inexact as they imply, and its bound says so.
use specula_spec::{CoreSpec, Method};

use super::lyon;
use crate::stress::draw::tilted;
use crate::stress::row::{Case, CatalogueRow, PixelPlace, Shaded, Trial};
use crate::stress::scene::{RawSpan, SpanScene, matt, mirror};
use crate::stress::variant::Variant;

/// A highlight on a span of `degrees` and `length` pixels.
fn highlight(degrees: f64, length: u32, n: u32) -> SpanScene {
    SpanScene::new(
        &[tilted(7.0)],
        vec![RawSpan::between([tilted(-degrees / 2.0), tilted(degrees / 2.0)], length, mirror(n))],
    )
}

/// The case that some pixel of a core with short formats has an error above `lsb`, while the
/// default formats are better.
fn breaks(scene: SpanScene, what: &'static str, is_short: fn(&CoreSpec) -> bool, lsb: f64) -> Case {
    let holds_out = move |shaded: &Shaded| {
        let off = shaded.outcome.comparison.errors.total.max_lsb;
        (off < lsb).then_some(PixelPlace { span: 0, pixel: 0 })
    };
    Case::new(scene).requiring_frame(what, is_short, holds_out)
}

fn short(method: Method, names: &[&str], fraction_bits: u32) -> Vec<Variant> {
    let table = names.iter().map(|name| format!("formats.{name}.{fraction_bits}\"\n")).collect();
    vec![Variant { method, table }]
}

fn bits(spec: &CoreSpec, name: &str) -> Option<u32> {
    spec.narrowing_points()
        .iter()
        .find(|point| point.name == name)
        .map(|point| point.format.fraction_bits)
}

/// The hybrid's base by second differences.
pub const SECOND_DIFFERENCES: CatalogueRow = CatalogueRow {
    id: "breaks 1",
    input: "hybrid with accumulators of 27 bits, 256 pixels, n = 256 and more",
    trial: Trial::Scenes {
        cases: |_, _| {
            let is_short = |spec: &CoreSpec| {
                spec.method() == Method::Hybrid && bits(spec, "accumulator") == Some(27)
            };
            let case = breaks(
                highlight(30.0, 257, 4096),
                "more than 1 LSB off, with 27 bits",
                is_short,
                1.0,
            );
            // The error of the base is 2^-28 (1 + S + S(S-1)/2), which n multiplies on the lobe's
            // flank (numerics N3b): 31 LSB. Half of that was measured.
            vec![case.with_figure(is_short, 16.0)]
        },
        variants: || short(Method::Hybrid, &["accumulator = \"S3"], 27),
    },
};

/// g2 in the R - L form.
pub const REFLECTION_FORM: CatalogueRow = CatalogueRow {
    id: "breaks 2",
    input: "lyon's R - L with g2 alone, fine formats, 30 degrees with n = 1024 and 90 degrees with n = 256",
    trial: Trial::Scenes {
        cases: |_, _| {
            let case = |(degrees, n)| {
                breaks(
                    highlight(degrees, 257, n),
                    "more than 1 LSB off, by g2 alone",
                    is_reflection_form,
                    1.0,
                )
            };
            [(30.0, 1024), (90.0, 256)].map(case).into()
        },
        variants: || lyon::printed_form(18),
    },
};

/// Lyon's 10-bit D.
pub const SHORT_DIFFERENCE: CatalogueRow = CatalogueRow {
    id: "breaks 3",
    input: "lyon as figure 7 prints it, with 10 fraction bits, n = 16 and 256",
    trial: Trial::Scenes {
        cases: |_, _| {
            let what = "more than 1 LSB off, with 10 fraction bits";
            [16, 256].map(|n| breaks(highlight(30.0, 257, n), what, is_reflection_form, 1.0)).into()
        },
        variants: || lyon::printed_form(10),
    },
};

fn is_reflection_form(spec: &CoreSpec) -> bool {
    use specula_spec::lyon::Difference;
    matches!(&spec.method, specula_spec::MethodSpec::Lyon(lyon)
        if lyon.difference == Difference::ReflectionMinusLight && lyon.newton_steps == 0)
}

/// Duff's and reflection shading's accumulators.
pub const SHORT_ACCUMULATOR: CatalogueRow = CatalogueRow {
    id: "breaks 4",
    input: "duff and reflection with accumulators of 18 bits, 257 pixels of 30 degrees",
    trial: Trial::Scenes {
        cases: |_, _| {
            let is_short = |spec: &CoreSpec| bits(spec, "accumulator") == Some(18);
            let span = RawSpan::between([tilted(-13.0), tilted(17.0)], 257, matt());
            let scene = SpanScene::new(&[tilted(7.0)], vec![span]);
            vec![breaks(scene, "more than 1 LSB off, with 18 bits", is_short, 1.0)]
        },
        variants: || {
            [Method::Duff, Method::Reflection]
                .iter()
                .flat_map(|&method| short(method, &["accumulator = \"S3"], 18))
                .collect()
        },
    },
};

/// Reflection shading's highlight.
pub const WRAPPED_HIGHLIGHT: CatalogueRow = CatalogueRow {
    id: "breaks 6",
    input: "reflection shading's highlight, n = 256, 60 degrees",
    trial: Trial::Scenes {
        cases: |_, _| {
            let is_wrapped = |spec: &CoreSpec| {
                use specula_spec::reflection::Highlight;
                matches!(&spec.method, specula_spec::MethodSpec::Reflection(spec) if spec.specular != Highlight::Hybrid)
            };
            let spans = SpanScene::new(
                &[tilted(-30.0)],
                vec![RawSpan::between([tilted(-30.0), tilted(30.0)], 257, mirror(256))],
            );
            vec![breaks(
                spans,
                "more than 20 LSB off, by the wrapped normal's highlight",
                is_wrapped,
                20.0,
            )]
        },
        variants: Vec::new,
    },
};
