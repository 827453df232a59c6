//! Lyon's shape function and its arguments.
use glam::DVec3;
use specula_spec::lyon::{Difference, LyonSpec, Normalisation, Normals};
use specula_spec::{CoreSpec, Method, MethodSpec};

use super::scenes::{aimed, spans};
use crate::stress::draw::tilted;
use crate::stress::row::{Case, CatalogueRow, Pixel, Trial, all};
use crate::stress::scene::{RawSpan, SpanScene, lit, mirror};
use crate::stress::variant::Variant;

/// Variants with D = R - L and every number of squarings, as f_k and with m = √n.
fn reflection_forms() -> Vec<Variant> {
    let form = |(k, shape)| {
        let table = format!(
            "difference = \"reflection-minus-light\"\nsquarings = {k}\nshape = \"{shape}\"\n"
        );
        Variant { method: Method::Lyon, table }
    };
    (0..=3).flat_map(|k| ["f-k", "root"].map(|shape| (k, shape))).map(form).collect()
}

/// Variants with Newton steps after either approximation, for both forms whose defaults have them.
fn approximations() -> Vec<Variant> {
    let one = |(steps, difference)| {
        let table = format!("difference = \"{difference}\"\nnewton_steps = {steps}\n");
        Variant { method: Method::Lyon, table }
    };
    (0..=3)
        .flat_map(|steps| {
            ["halfway-cross-normal", "reflection-minus-light"].map(|form| (steps, form))
        })
        .map(one)
        .collect()
}

fn lyon<'a>(pixel: &Pixel<'a>) -> Option<&'a LyonSpec> {
    match &pixel.shaded.spec.method {
        MethodSpec::Lyon(lyon) => Some(lyon),
        _ => None,
    }
}

fn is_reflection_form(spec: &CoreSpec) -> bool {
    matches!(&spec.method, MethodSpec::Lyon(lyon) if lyon.difference == Difference::ReflectionMinusLight)
}

/// The case that R - L has no highlight.
fn dark(scene: SpanScene) -> Case {
    Case::new(scene).requiring("R - L: no highlight", is_reflection_form, |pixel| pixel.code() == 0)
}

fn flat(n: u32) -> RawSpan {
    RawSpan::between([DVec3::Z; 2], 2, mirror(n))
}

/// Row 21.
pub const END_OF_THE_SHAPE: CatalogueRow = CatalogueRow {
    id: "21",
    input: "x = 2^k exactly, and a little to either side",
    trial: Trial::Scenes {
        cases: |_, _| {
            let end = |light| {
                let scene = SpanScene::new(&[light], (0..=3).map(|k| flat(1 << k)).collect());
                // |R - L|² = 2, so x = n/2 · 2 is at least 2^k if n is.
                Case::new(scene).requiring(
                    "R - L: 0 at x = 2^k and behind it",
                    is_reflection_form,
                    |pixel| {
                        let n = pixel.shaded.frame.material(pixel.span).shininess;
                        let behind = lyon(pixel).is_some_and(|lyon| n >= 1 << lyon.squarings);
                        !behind || pixel.code() == 0
                    },
                )
            };
            let near = |tenths: u32| {
                SpanScene::new(
                    &[tilted(f64::from(tenths) / 10.0)],
                    (0..=3).map(|k| flat(1 << k)).collect(),
                )
            };
            let sides = [890, 899, 901, 910].map(|tenths| Case::new(near(tenths)));
            [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y].map(end).into_iter().chain(sides).collect()
        },
        variants: reflection_forms,
    },
};

/// Row 22.
pub const CENTRE: CatalogueRow = CatalogueRow {
    id: "22",
    input: "x = 0",
    trial: Trial::Scenes {
        cases: |_, _| {
            let scene = SpanScene::new(&[DVec3::Z], [1, 256, 8191].map(flat).into());
            vec![
                Case::new(scene)
                    .requiring("255: f = 1.0 exactly", all, |pixel| pixel.code() == 255),
            ]
        },
        variants: reflection_forms,
    },
};

/// Row 23.
pub const TAILS: CatalogueRow = CatalogueRow {
    id: "23",
    input: "n = 1 at 180 and 90 degrees",
    trial: Trial::Scenes {
        cases: |_, _| {
            let case = |what, light, codes: [u8; 4]| {
                Case::new(SpanScene::new(&[light], vec![flat(1)])).requiring(
                    what,
                    is_reflection_form,
                    move |pixel| {
                        lyon(pixel)
                            .is_some_and(|lyon| pixel.code() == codes[lyon.squarings as usize])
                    },
                )
            };
            vec![
                case(
                    "R - L at 180 degrees: f_k is 0, 0, 0.0625, 0.1001 for k = 0 to 3",
                    -DVec3::Z,
                    [0, 0, 16, 26],
                ),
                case(
                    "R - L at 90 degrees: f_k is 0, 0.25, 0.3164, 0.3436 for k = 0 to 3",
                    DVec3::X,
                    [0, 64, 81, 88],
                ),
            ]
        },
        variants: reflection_forms,
    },
};

/// Row 24.
pub const LARGEST_EXPONENT: CatalogueRow = CatalogueRow {
    id: "24",
    input: "n = 8191, D as long as it can be, with g2's overshoot",
    trial: Trial::Scenes {
        cases: |draw, extent| {
            let half = libm::acos(0.8f64.sqrt()).to_degrees();
            let span = |n| RawSpan::between([tilted(-half), tilted(half)], 3, mirror(n));
            let scene = SpanScene::new(&[-DVec3::Z], [16, 8191].map(span).into());
            let mut random = spans(draw, extent, [0.0, 90.0], lit);
            random
                .iter_mut()
                .for_each(|span| span.material.shininess = draw.between(4096, 8191) as u32);
            vec![dark(scene), Case::new(aimed(draw, random))]
        },
        variants: || reflection_forms().into_iter().chain(approximations()).collect(),
    },
};

/// Row 25.
pub const OPPOSITE_REFLECTION: CatalogueRow = CatalogueRow {
    id: "25",
    input: "L = -R along an axis: a component of D is +2",
    trial: Trial::Scenes {
        cases: |_, _| vec![dark(SpanScene::new(&[-DVec3::Z], vec![flat(8191)]))],
        variants: reflection_forms,
    },
};

/// Row 27.
pub const LARGEST_GAIN: CatalogueRow = CatalogueRow {
    id: "27",
    input: "z = 0: g2 = 2, and 6.75 after three Newton steps; n = 8191",
    trial: Trial::Scenes {
        cases: |_, _| {
            let scene = SpanScene::new(
                &[DVec3::Z],
                vec![RawSpan::between([DVec3::X, -DVec3::X], 3, lit(8191))],
            );
            let vanishes = |spec: &CoreSpec| matches!(&spec.method, MethodSpec::Lyon(lyon) if lyon.normals == Normals::Linear);
            let ambient = |pixel: &Pixel| pixel.i != 1 || pixel.code() == pixel.ambient();
            vec![Case::new(scene).requiring("ambient light alone in the middle", vanishes, ambient)]
        },
        variants: approximations,
    },
};

/// Row 28.
pub const OVERSHOOT: CatalogueRow = CatalogueRow {
    id: "28",
    input: "z = 0.8, where g2 makes normals 0.176 % too long and 2 N.V = 2.0036",
    trial: Trial::Scenes {
        cases: |_, _| {
            let half = libm::acos(0.8f64.sqrt()).to_degrees();
            let spans = || {
                [1, 16, 8191].map(|n| RawSpan::between([tilted(-half), tilted(half)], 3, lit(n)))
            };
            [DVec3::Z, -DVec3::Z, tilted(60.0)]
                .map(|light| Case::new(SpanScene::new(&[light], spans().into())))
                .into()
        },
        variants: approximations,
    },
};

/// Row 30.
pub const ROOT_OF_N: CatalogueRow = CatalogueRow {
    id: "30",
    input: "m = 90 times D of length 2",
    trial: Trial::Scenes {
        cases: |_, _| {
            let case = |light| dark(SpanScene::new(&[light], [64, 1024, 8191].map(flat).into()));
            [-DVec3::Z, DVec3::X, -DVec3::Y].map(case).into()
        },
        variants: reflection_forms,
    },
};

/// Row 31.
pub const ONE_AXIS: CatalogueRow = CatalogueRow {
    id: "31",
    input: "D along one axis, with an integer part and no fraction",
    trial: Trial::Scenes {
        cases: |_, _| {
            let case = |light| {
                let scene = SpanScene::new(&[light], [256, 8191].map(flat).into());
                let is_normalised = |spec: &CoreSpec| matches!(&spec.method, MethodSpec::Lyon(lyon) if lyon.normalisation != Normalisation::None);
                let dark = |pixel: &Pixel| pixel.method() > 0.0 || pixel.code() == 0;
                Case::new(scene).requiring(
                    "no highlight where the form has none in exact arithmetic",
                    is_normalised,
                    dark,
                )
            };
            [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y].map(case).into()
        },
        variants: reflection_forms,
    },
};

/// Variants of lyon's R - L form and of its default, for places that docs/numerics.md describes.
pub fn printed_form(fraction_bits: u32) -> Vec<Variant> {
    let bits =
        |name: &str, integer: &str| format!("formats.{name} = \"{integer}.{fraction_bits}\"\n");
    let formats = [
        bits("vector", "S1"),
        bits("length_squared", "U1"),
        bits("gain", "U2"),
        bits("difference", "S2"),
    ]
    .concat();
    let table = format!("difference = \"reflection-minus-light\"\nnewton_steps = 0\n{formats}");
    vec![Variant { method: Method::Lyon, table }]
}
