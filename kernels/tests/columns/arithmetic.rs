//! Sums, differences, products and copies with all steps that can follow them before they are
//! stored.
//!
//! A kernel is right where the raw result fits the lane in which it is computed. So lanes whose
//! exact result does not fit are left out, and what is stored is expected to have the low bits of
//! the exact result.
use proptest::prelude::*;
use specula_kernels::{
    Arithmetic, Binary, InstructionSet, Lane, Post, Shift, Wrap, narrow, narrow_through_wide,
    narrowing, wide, widening,
};

use crate::lanes::{Shape, column, in_lanes, instruction_sets, number, numbers, shape, unfilled};

const OPERATORS: [Arithmetic; 4] =
    [Arithmetic::Copy, Arithmetic::Add, Arithmetic::Sub, Arithmetic::Mul];

fn exact(operator: Arithmetic, a: i64, b: i64) -> i128 {
    let (a, b) = (i128::from(a), i128::from(b));
    match operator {
        Arithmetic::Copy => a,
        Arithmetic::Add => a + b,
        Arithmetic::Sub => a - b,
        Arithmetic::Mul => a * b,
    }
}

fn shifted(shift: Shift, value: i128) -> i128 {
    match shift {
        Shift::None => value,
        Shift::Floor(bits) => value.div_euclid(1 << bits),
        // Rounds to nearest, ties up: adds half a unit of the last place that stays and drops the
        // rest.
        Shift::Round(bits) => (value + (1 << bits)).div_euclid(2 << bits),
    }
}

fn wrapped(wrap: Wrap, value: i128) -> i128 {
    match wrap {
        Wrap::None => value,
        Wrap::Unsigned(width) => value.rem_euclid(1 << width),
        Wrap::Signed(width) => {
            let low = value.rem_euclid(1 << width);
            if low >> (width - 1) == 1 { low - (1 << width) } else { low }
        }
    }
}

pub fn fits(bits: u32, value: i128) -> bool {
    value >> (bits - 1) == 0 || value >> (bits - 1) == -1
}

/// Every kind of constant, shift and wrap that such a kernel can be asked for, provided that 0, so
/// treated, fits.
pub fn posts(computed: u32, stored: u32) -> impl Strategy<Value = Post> {
    let shift = prop_oneof![
        Just(Shift::None),
        (0..64u32).prop_map(Shift::Floor),
        (0..62u32).prop_map(Shift::Round),
        (1..12u32).prop_map(Shift::Round),
    ];
    let wrap = |bits: u32| {
        prop_oneof![
            Just(Wrap::None),
            (1..=bits).prop_map(Wrap::Signed),
            (1..bits).prop_map(Wrap::Unsigned)
        ]
    };
    let plus = prop_oneof![Just(0), number(24), number(40)];
    (plus, wrap(computed), shift, wrap(stored))
        .prop_map(|(plus, first, shift, wrap)| Post { plus, first, shift, wrap })
        .prop_filter("0 becomes something that fits", move |post| {
            finished(*post, computed, 0).is_some_and(|result| fits(stored, result))
        })
}

/// What is stored of a raw result; `None` if it does not fit the lane that computes.
pub fn finished(post: Post, computed: u32, raw: i128) -> Option<i128> {
    let sum = raw + i128::from(post.plus);
    let first = wrapped(post.first, sum);
    let fit = [raw, sum, first, first + i128::from(post.half())]
        .into_iter()
        .all(|value| fits(computed, value));
    fit.then(|| wrapped(post.wrap, shifted(post.shift, first)))
}

/// Operands whose exact results all fit the lane in which they are computed.
struct Operands {
    a: Vec<i64>,
    b: Vec<i64>,
    results: Vec<i128>,
}

/// Operands, with lanes whose exact result does not fit set to 0.
fn operands(
    operator: Arithmetic,
    post: Post,
    (computed, stored): (u32, u32),
    shape: Shape,
    a: &[i64],
    b: &[i64],
) -> Operands {
    let (mut a, mut b) = (a.to_vec(), b.to_vec());
    let mut results = vec![];
    for lane in 0..shape.lanes {
        let (at_a, at_b) = (shape.offsets[0] + lane, shape.offsets[1] + lane);
        let result = |a, b| {
            finished(post, computed, exact(operator, a, b)).filter(|&result| fits(stored, result))
        };
        match result(a[at_a], b[at_b]) {
            Some(result) => results.push(result),
            None => {
                (a[at_a], b[at_b]) = (0, 0);
                results.push(result(0, 0).expect("a post-operation of 0 fits"));
            }
        }
    }
    Operands { a, b, results }
}

type Kernel<I, O> = fn(Arithmetic, Post, InstructionSet) -> Binary<I, O>;

/// Compares a kernel that computes in `computed` bits with the exact results, with every operator
/// and at both instruction_sets.
fn check<I: Lane, O: Lane>(
    kernel: Kernel<I, O>,
    computed: u32,
    post: Post,
    shape: Shape,
    a: &[i64],
    b: &[i64],
) {
    for operator in OPERATORS {
        let operands = operands(operator, post, (computed, O::BITS), shape, a, b);
        let (a, b): (Vec<I>, Vec<I>) = (in_lanes(&operands.a), in_lanes(&operands.b));
        for instruction_set in instruction_sets() {
            let mut out = unfilled::<O>(shape.lanes);
            kernel(operator, post, instruction_set).run(&mut out, shape.of(&a, 0), shape.of(&b, 1));
            let got: Vec<i128> = numbers(&out).into_iter().map(i128::from).collect();
            assert_eq!(
                got,
                operands.results,
                "{operator:?} {post:?} {shape:?} {}",
                instruction_set.name()
            );
        }
    }
}

/// Two columns of numbers that fit `bits` bits or fewer, so that sums and products often fit as
/// well.
fn columns(bits: u32) -> impl Strategy<Value = (Vec<i64>, Vec<i64>)> {
    prop_oneof![
        (column(bits), column(bits)),
        (column(bits / 2), column(bits / 2)),
        (column(bits - 1), column(bits - 1))
    ]
}

proptest! {
    #[test]
    fn narrow_lanes_are_narrow_arithmetic(post in posts(32, 32), shape in shape(), (a, b) in columns(32)) {
        check::<i32, i32>(narrow, 32, post, shape, &a, &b);
    }

    #[test]
    fn narrow_lanes_through_wide_ones(post in posts(64, 32), shape in shape(), (a, b) in columns(32)) {
        check::<i32, i32>(narrow_through_wide, 64, post, shape, &a, &b);
    }

    #[test]
    fn narrow_to_wide_lanes(post in posts(64, 64), shape in shape(), (a, b) in columns(32)) {
        check::<i32, i64>(widening, 64, post, shape, &a, &b);
    }

    #[test]
    fn wide_lanes_are_wide_arithmetic(post in posts(64, 64), shape in shape(), (a, b) in columns(64)) {
        check::<i64, i64>(wide, 64, post, shape, &a, &b);
    }

    #[test]
    fn wide_to_narrow_lanes(post in posts(64, 32), shape in shape(), (a, b) in columns(64)) {
        check::<i64, i32>(narrowing, 64, post, shape, &a, &b);
    }

    /// Where the raw result does not fit, its low bits are still right.
    #[test]
    fn overflow_keeps_the_low_bits(width in 1..=32u32, a in number(32), b in number(32)) {
        for operator in OPERATORS {
            let post = Post { wrap: Wrap::Signed(width), ..Post::default() };
            for instruction_set in instruction_sets() {
                let mut out = [0];
                narrow(operator, post, instruction_set).run(&mut out, &[a as i32], &[b as i32]);
                assert_eq!(i128::from(out[0]), wrapped(post.wrap, exact(operator, a, b)), "{operator:?} {}", instruction_set.name());
            }
        }
    }
}

/// Tests every amount of every kind of shift and every width at the extremes.
#[test]
fn every_amount_at_the_extremes() {
    let wide_values = [
        i64::MIN,
        i64::MAX - 1,
        i64::MIN + 1,
        -1,
        0,
        1,
        1 << 31,
        -(1 << 31),
        (1 << 31) - 1,
        -(1 << 62),
        1 << 62,
    ];
    let shape = Shape { lanes: wide_values.len(), offsets: [0; 3] };
    let zeros = vec![0; wide_values.len()];
    let narrow_values =
        wide_values.map(|value| value.clamp(i32::MIN.into(), i64::from(i32::MAX) - 1));
    for bits in 0..64 {
        let widths =
            (1..64).map(Wrap::Unsigned).chain((1..=64).map(Wrap::Signed)).chain([Wrap::None]);
        for wrap in widths {
            for shift in [Shift::Floor(bits), Shift::Round(bits.min(61))] {
                let post = Post { shift, wrap, ..Post::default() };
                check::<i64, i64>(wide, 64, post, shape, &wide_values, &zeros);
                let narrow_wrap = match wrap {
                    Wrap::None => true,
                    Wrap::Unsigned(width) => width < 32,
                    Wrap::Signed(width) => width <= 32,
                };
                let has_room = post.half() <= 1 << 30;
                if narrow_wrap && has_room {
                    check::<i32, i32>(narrow, 32, post, shape, &narrow_values, &zeros);
                }
            }
        }
    }
}
