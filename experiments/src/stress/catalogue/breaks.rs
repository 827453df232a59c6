//! What breaks first [numerics N4]: the paper's own formats, where they are too short. The core is
//! as bad as they say, and its bound says so.
use specula_spec::{CoreSpec, Method};

use super::super::draw::tilted;
use super::super::row::{Place, Shaded};
use super::super::variant::Variant;
use super::{Case, RawSpan, Row, SpanScene, Trial, lyon, mirror};

/// A highlight on a span of so many degrees and pixels.
fn highlight(degrees: f64, length: u32, n: u32) -> SpanScene {
    SpanScene::new(
        &[tilted(7.0)],
        vec![RawSpan::between([tilted(-degrees / 2.0), tilted(degrees / 2.0)], length, mirror(n))],
    )
}

/// That some pixel of a core with short formats is off by more than `lsb`; the defaults are to do
/// better.
fn breaks(scene: SpanScene, what: &'static str, is_short: fn(&CoreSpec) -> bool, lsb: f64) -> Case {
    let holds_out = move |shaded: &Shaded| {
        let off = shaded.outcome.comparison.errors.total.max_lsb;
        (off < lsb).then_some(Place { span: 0, pixel: 0 })
    };
    Case::new(scene).asking_frame(what, is_short, holds_out)
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

/// Hybrid's base by second differences.
pub const SECOND_DIFFERENCES: Row = Row {
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
            // The base is off by 2^-28 (1 + S + S(S-1)/2), which n multiplies on the lobe's flank
            // (numerics N3b), 31 LSB; half of that was seen.
            vec![case.with_figure(is_short, 16.0)]
        },
        variants: || short(Method::Hybrid, &["accumulator = \"S3"], 27),
    },
};

/// g2 in the R - L form.
pub const REFLECTION_FORM: Row = Row {
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
pub const SHORT_DIFFERENCE: Row = Row {
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
pub const SHORT_ACCUMULATOR: Row = Row {
    id: "breaks 4",
    input: "duff and reflection with accumulators of 18 bits, 257 pixels of 30 degrees",
    trial: Trial::Scenes {
        cases: |_, _| {
            let is_short = |spec: &CoreSpec| bits(spec, "accumulator") == Some(18);
            let span = RawSpan::between([tilted(-13.0), tilted(17.0)], 257, super::matt());
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
pub const WRAPPED_HIGHLIGHT: Row = Row {
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
