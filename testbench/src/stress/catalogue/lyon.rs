//! Lyon's shape function and what goes into it.
use glam::DVec3;
use specula_scene::spec::lyon::{Difference, LyonSpec, Normalisation, Normals};
use specula_scene::{Method, MethodSpec};

use super::super::draw::tilted;
use super::super::row::Pixel;
use super::{Case, RawSpan, Row, SpanScene, Trial, Variant, aimed, lit, mirror, spans};

/// D = R - L with every number of squarings, as f_k and by m = √n.
fn reflection_forms() -> Vec<Variant> {
    let form = |(k, shape)| {
        let table = format!("difference = \"reflection-minus-light\"\nsquarings = {k}\nshape = \"{shape}\"\n");
        Variant { method: Method::Lyon, table }
    };
    (0..=3).flat_map(|k| ["f-k", "root"].map(|shape| (k, shape))).map(form).collect()
}

/// Newton steps after either approximation, for both forms that the defaults know.
fn approximations() -> Vec<Variant> {
    let one = |(steps, difference)| {
        let table = format!("difference = \"{difference}\"\nnewton_steps = {steps}\n");
        Variant { method: Method::Lyon, table }
    };
    (0..=3).flat_map(|steps| ["halfway-cross-normal", "reflection-minus-light"].map(|form| (steps, form))).map(one).collect()
}

fn lyon<'a>(pixel: &Pixel<'a>) -> Option<&'a LyonSpec> {
    match &pixel.shaded.spec.method {
        MethodSpec::Lyon(lyon) => Some(lyon),
        _ => None,
    }
}

/// The code of R - L with so many squarings, if this is such a core.
fn of_reflection_form(pixel: &Pixel, wanted: impl Fn(u32) -> u8) -> bool {
    let form = lyon(pixel).filter(|lyon| lyon.difference == Difference::ReflectionMinusLight);
    form.is_none_or(|lyon| pixel.code() == wanted(lyon.squarings))
}

fn flat(n: u32) -> RawSpan {
    RawSpan::between([DVec3::Z; 2], 2, mirror(n))
}

/// Row 21.
pub const END_OF_THE_SHAPE: Row = Row {
    id: "21",
    input: "x = 2^k exactly, and a little to either side",
    wanted: "0 at 2^k and behind it, never a negative number to an even power",
    trial: Trial::Scenes {
        cases: |_, _| {
            let end = |light| {
                let scene = SpanScene::new(&[light], (0..=3).map(|k| flat(1 << k)).collect());
                // |R - L|² = 2, so that x = n/2 · 2 is 2^k or more where n is.
                Case::wanting(scene, |pixel| {
                    let n = pixel.shaded.frame.material(pixel.span).shininess;
                    let behind = lyon(pixel).is_some_and(|lyon| n >= 1 << lyon.squarings);
                    !behind || of_reflection_form(pixel, |_| 0)
                })
            };
            let near = |tenths: u32| SpanScene::new(&[tilted(f64::from(tenths) / 10.0)], (0..=3).map(|k| flat(1 << k)).collect());
            let sides = [890, 899, 901, 910].map(|tenths| Case::new(near(tenths)));
            [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y].map(end).into_iter().chain(sides).collect()
        },
        variants: reflection_forms,
    },
};

/// Row 22.
pub const CENTRE: Row = Row {
    id: "22",
    input: "x = 0",
    wanted: "f = 1.0 exactly: 255",
    trial: Trial::Scenes {
        cases: |_, _| {
            let scene = SpanScene::new(&[DVec3::Z], [1, 256, 8191].map(flat).into());
            vec![Case::wanting(scene, |pixel| pixel.code() == 255)]
        },
        variants: reflection_forms,
    },
};

/// Row 23.
pub const TAILS: Row = Row {
    id: "23",
    input: "n = 1 at 180 and 90 degrees",
    wanted: "R - L: f_k is 0, 0, 0.0625, 0.1001 and 0, 0.25, 0.3164, 0.3436 for k = 0 to 3",
    trial: Trial::Scenes {
        cases: |_, _| {
            let case = |light, codes: [u8; 4]| {
                Case::wanting(SpanScene::new(&[light], vec![flat(1)]), move |pixel| {
                    of_reflection_form(pixel, |k| codes[k as usize])
                })
            };
            vec![case(-DVec3::Z, [0, 0, 16, 26]), case(DVec3::X, [0, 64, 81, 88])]
        },
        variants: reflection_forms,
    },
};

/// Row 24.
pub const LARGEST_EXPONENT: Row = Row {
    id: "24",
    input: "n = 8191, D as long as it can be, with g2's overshoot",
    wanted: "n D.D does not wrap around: no highlight",
    trial: Trial::Scenes {
        cases: |draw, extent| {
            let half = libm::acos(0.8f64.sqrt()).to_degrees();
            let span = |n| RawSpan::between([tilted(-half), tilted(half)], 3, mirror(n));
            let scene = SpanScene::new(&[-DVec3::Z], [16, 8191].map(span).into());
            let mut random = spans(draw, extent, [0.0, 90.0], lit);
            random.iter_mut().for_each(|span| span.material.shininess = draw.between(4096, 8191) as u32);
            let dark = |pixel: &Pixel| of_reflection_form(pixel, |_| 0);
            vec![Case::wanting(scene, dark), Case::new(aimed(draw, random))]
        },
        variants: || reflection_forms().into_iter().chain(approximations()).collect(),
    },
};

/// Row 25.
pub const OPPOSITE_REFLECTION: Row = Row {
    id: "25",
    input: "L = -R along an axis: a component of D is +2",
    wanted: "no overflow: no highlight for n = 8191",
    trial: Trial::Scenes {
        cases: |_, _| {
            let scene = SpanScene::new(&[-DVec3::Z], vec![flat(8191)]);
            vec![Case::wanting(scene, |pixel| of_reflection_form(pixel, |_| 0))]
        },
        variants: reflection_forms,
    },
};

/// Row 27.
pub const LARGEST_GAIN: Row = Row {
    id: "27",
    input: "z = 0: g2 = 2, and 6.75 after three Newton steps; n = 8191",
    wanted: "ambient light in the middle, nothing wraps around",
    trial: Trial::Scenes {
        cases: |_, _| {
            let scene = SpanScene::new(&[DVec3::Z], vec![RawSpan::between([DVec3::X, -DVec3::X], 3, lit(8191))]);
            let ambient = |pixel: &Pixel| {
                let vanishes = |lyon: &LyonSpec| lyon.normals == Normals::Linear;
                pixel.i != 1 || !lyon(pixel).is_some_and(vanishes) || pixel.code() == pixel.ambient()
            };
            vec![Case::wanting(scene, ambient)]
        },
        variants: approximations,
    },
};

/// Row 28.
pub const OVERSHOOT: Row = Row {
    id: "28",
    input: "z = 0.8, where g2 makes normals 0.176 % too long and 2 N.V = 2.0036",
    wanted: "no overflow",
    trial: Trial::Scenes {
        cases: |_, _| {
            let half = libm::acos(0.8f64.sqrt()).to_degrees();
            let spans = || [1, 16, 8191].map(|n| RawSpan::between([tilted(-half), tilted(half)], 3, lit(n)));
            [DVec3::Z, -DVec3::Z, tilted(60.0)].map(|light| Case::new(SpanScene::new(&[light], spans().into()))).into()
        },
        variants: approximations,
    },
};

/// Row 30.
pub const ROOT_OF_N: Row = Row {
    id: "30",
    input: "m = 90 times D of length 2",
    wanted: "whether m D has an integer part suffices: no highlight",
    trial: Trial::Scenes {
        cases: |_, _| {
            let case = |light| {
                let scene = SpanScene::new(&[light], [64, 1024, 8191].map(flat).into());
                Case::wanting(scene, |pixel| of_reflection_form(pixel, |_| 0))
            };
            [-DVec3::Z, DVec3::X, -DVec3::Y].map(case).into()
        },
        variants: reflection_forms,
    },
};

/// Row 31.
pub const ONE_AXIS: Row = Row {
    id: "31",
    input: "D along one axis, with an integer part and no fraction",
    wanted: "no highlight for n = 256 and above, of any form",
    trial: Trial::Scenes {
        cases: |_, _| {
            let case = |light| {
                let scene = SpanScene::new(&[light], [256, 8191].map(flat).into());
                let short = |lyon: &LyonSpec| lyon.normalisation == Normalisation::None;
                Case::wanting(scene, move |pixel| lyon(pixel).is_none_or(short) || pixel.method() > 0.0 || pixel.code() == 0)
            };
            [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y].map(case).into()
        },
        variants: reflection_forms,
    },
};

/// How lyon's R - L form and its default do at places where NUMERICS tells of them.
pub fn printed_form(fraction_bits: u32) -> Vec<Variant> {
    let bits = |name: &str, integer: &str| format!("formats.{name} = \"{integer}.{fraction_bits}\"\n");
    let formats = [bits("vector", "S1"), bits("length_squared", "U1"), bits("gain", "U2"), bits("difference", "S2")].concat();
    let table = format!("difference = \"reflection-minus-light\"\nnewton_steps = 0\n{formats}");
    vec![Variant { method: Method::Lyon, table }]
}
