//! Inputs that are always the same are off by what the host rounded, like any other, whatever
//! hardware they leave out.
use specula_datapath::Design;
use specula_datapath::builder::Sig;
use specula_hdl::units::{self, Differences, Steps};
use specula_spec::Format;

use super::Bench;

/// 2^-4.
const FORMAT: Format = Format::signed(1, 4);
const ULP: f64 = 1.0 / 16.0;
const WHOLE: (i64, i64) = (-16, 16);

impl Bench {
    /// A port that is always given this raw value.
    fn always(&self, name: &str, raw: i64) -> Sig {
        self.input(name, FORMAT, (raw, raw))
    }
}

/// The largest |fixed - real| of an operator on real operands up to half a unit from raw ones
/// within these ranges: at corners, since it is linear or a product.
fn worst(ranges: [(i64, i64); 2], of: impl Fn(f64, f64) -> f64) -> f64 {
    let corners = |(low, high): (i64, i64)| [low as f64, high as f64];
    let mut worst: f64 = 0.0;
    for (a, b) in corners(ranges[0]).into_iter().flat_map(|a| corners(ranges[1]).map(|b| (a, b))) {
        for (e, f) in [-0.5, 0.5].into_iter().flat_map(|e| [-0.5, 0.5].map(|f| (e, f))) {
            worst = worst.max((of(a, b) - of(a + e, b + f)).abs());
        }
    }
    worst
}

/// Sums, differences and products with inputs that are always 0, 1, -3 or 16, which fold in
/// different ways, are off as those with any others.
#[test]
fn operators_on_constant_inputs_have_the_error_of_what_was_rounded() {
    for raw in [0, 1, -3, 16] {
        let bench = Bench::new();
        let (a, c) = (bench.input("a", FORMAT, WHOLE), bench.always("c", raw));
        let sums = worst([WHOLE, (raw, raw)], |a, b| a + b) * ULP;
        let products = worst([WHOLE, (raw, raw)], |a, b| a * b) * ULP * ULP;
        for (sig, wanted) in [
            (&a + &c, sums),
            (&c + &a, sums),
            (&a - &c, sums),
            (&c - &a, sums),
            (&a * &c, products),
            (&c * &a, products),
        ] {
            assert_eq!(sig.error_value(), wanted, "{raw}");
        }
        let of_two = worst([(raw, raw), (raw, raw)], |a, b| a * b) * ULP * ULP;
        assert_eq!((&c * &bench.always("d", raw)).error_value(), of_two, "{raw}");
        assert_eq!(c.squared().error_value(), of_two, "{raw}");
    }
}

/// Constants of a formula are exact.
#[test]
fn constants_of_a_formula_have_no_error() {
    let bench = Bench::new();
    let a = bench.input("a", FORMAT, WHOLE);
    let integer = |value| bench.b.integer(value);
    assert_eq!((&a * integer(0)).error(), 0.0);
    assert_eq!((&a * integer(1)).error(), 0.5);
    assert_eq!((&a + integer(0)).error(), 0.5);
    assert_eq!((&integer(3) * &integer(0)).error(), 0.0);
}

/// The step that the host rounded to 0 is off by up to half a unit at every pixel: S of them for
/// what is linear, and S²/4 for second differences.
#[test]
fn what_grows_by_a_step_that_was_rounded_to_0_is_off_by_every_step() {
    let steps = 228;
    let s = f64::from(steps);
    for start in [(-16, 16), (7, 7), (0, 0)] {
        let bench = Bench::new();
        let (start, step) = (bench.input("start", FORMAT, start), bench.always("step", 0));
        let grown = Sig::accumulated(&bench.start, &start, &step, (-20.0, 20.0), steps, "it stays");
        assert_eq!(grown.error(), 0.5 * (1.0 + s));
        let linear = units::linear(
            &bench.b,
            &bench.start,
            Steps { start: &start, step: &step, limit: 1.0 },
            steps,
        );
        assert!((linear.error() - 0.5 * (1.0 + s)).abs() < 1e-9);
        let of = Differences {
            start: &start,
            first_difference: &step,
            second_difference: &bench.always("second", 0),
        };
        let quadratic = units::quadratic(&bench.b, &bench.start, of, (-1.0, 1.0), steps);
        assert!((quadratic.error() - 0.5 * (1.0 + s + s * (s - 1.0) / 2.0)).abs() < 1e-9);
    }
}

/// Two values that are one signal, because both have the same operands, may stand for different
/// real ones. Neither loses its error to the other, whichever comes first.
#[test]
fn twins_keep_their_own_errors() {
    for coarse_first in [false, true] {
        let bench = Bench::new();
        let (a, factor) = (bench.input("a", FORMAT, WHOLE), bench.input("factor", FORMAT, WHOLE));
        let coarse = a.clone().override_error("stated", 0.25);
        let product = |sig: &Sig| sig * &factor;
        let (of_fine, of_coarse) = if coarse_first {
            let of_coarse = product(&coarse);
            (product(&a), of_coarse)
        } else {
            let of_fine = product(&a);
            (of_fine, product(&coarse))
        };
        assert_eq!(of_fine.id(), of_coarse.id(), "one multiplier does for both");
        assert_eq!(of_fine.error(), 8.0 + 8.0 + 0.25);
        assert_eq!(of_coarse.error(), 16.0 * 4.0 + 8.0 + 2.0);
        assert_eq!(
            (a.error(), coarse.error()),
            (0.5, 4.0),
            "what is stated of a value is stated of no other"
        );
        let design = bench.finish(&[("fine", of_fine), ("coarse", of_coarse)]);
        assert_eq!(design.output_errors, [16.25 * ULP * ULP, 74.0 * ULP * ULP]);
    }
}

/// What is chosen where the choice is always the same still has the larger error of both.
#[test]
fn choices_that_are_always_the_same_keep_the_larger_error() {
    let bench = Bench::new();
    let a = bench.input("a", FORMAT, WHOLE);
    let coarse = a.clone().override_error("stated", 0.25);
    for bit in [0, 1] {
        assert_eq!(bench.b.integer(bit).choose(&a, &coarse).error(), 4.0);
        assert_eq!(bench.b.integer(bit).choose(&coarse, &a).error(), 4.0);
    }
}

/// Clamping keeps the error, also where all rounded values lie on one side, or are the same: the
/// real one need not.
#[test]
fn clamps_know_nothing_of_the_real_value_but_what_they_leave_of_it() {
    let clamped = |low, high| {
        let bench = Bench::new();
        let input = bench.input("x", FORMAT, (low, high));
        input.at_least_zero().clamped_above(1)
    };
    // From -1/2 to 1/2 unit, of which 0 to 1/2 is left.
    assert_eq!(clamped(0, 0).error(), 0.5);
    // From 15.5 to 16.5, of which 15.5 to 16 is left.
    assert_eq!(clamped(16, 16).error(), 0.5);
    // From 2.5 to 3.5.
    assert_eq!(clamped(3, 3).error(), 0.5);
    // Always 0, and so is the real one; or it is always 1.
    assert_eq!((clamped(-3, -1).error(), clamped(17, 19).error()), (0.0, 0.0));
    // From -9.5 to 0.5, of which 0 to 0.5 is left.
    assert_eq!(clamped(-9, 0).error(), 0.5);
}

/// A value whose error is larger than the range is off by what the clamps leave, counted from where
/// it is.
#[test]
fn between_two_clamps_a_value_is_off_by_their_distance_at_most() {
    for ((low, high), wanted) in
        [((-32, 32), 1.0), ((0, 0), 1.0), ((4, 4), 0.75), ((16, 16), 1.0), ((40, 50), 1.0)]
    {
        let bench = Bench::new();
        let input =
            bench.input("x", Format::signed(3, 4), (low, high)).override_error("stated", 5.0);
        for clamped in
            [input.at_least_zero().clamped_above(1), input.clamped_above(1).at_least_zero()]
        {
            assert_eq!(clamped.error_value(), wanted, "{low} to {high}");
            assert_eq!(
                clamped.rounded(2).at_least_zero().clamped_above(1).error_value(),
                wanted,
                "{low} to {high}"
            );
        }
    }
}

/// A stated fact is about what the core computes, and leaves the error as it is.
#[test]
fn stated_facts_leave_errors_alone() {
    let bench = Bench::new();
    let sum = &bench.input("x", FORMAT, (3, 5)) + &bench.input("y", FORMAT, (3, 3));
    let assumed = sum.assumed(0.4, 0.4, "it is 0.4");
    assert_eq!((assumed.error(), assumed.range().extent()), (1.0, 1.0));
}

/// Of values that have a time slot each and are the same constant, the largest error counts.
#[test]
fn turns_that_are_all_the_same_have_the_largest_error() {
    let b = specula_datapath::builder::Builder::new("bench", "");
    let slots = b.time_slots(&b.control(), 2);
    let coarse = b.integer(0).override_error("stated", 0.25);
    for values in [[coarse.clone(), b.integer(0)], [b.integer(0), coarse]] {
        assert_eq!(slots.multiplexed(&values).error(), 0.25);
    }
}

/// Inputs of half a unit, multiplied and rounded again: nothing that an output leaves out is lost
/// on the way through units.
#[test]
fn errors_cross_the_borders_of_units() {
    let bench = Bench::new();
    let (x, zero) = (bench.input("x", FORMAT, WHOLE), bench.always("zero", 0));
    let inside = |name: &str, x: &Sig| {
        bench.b.unit(name, "", (("x", x), ("zero", &zero)), |_, (x, zero)| x * zero)
    };
    let (fine, coarse) =
        (inside("fine", &x), inside("coarse", &x.clone().override_error("stated", 1.0)));
    assert_eq!((fine.error(), coarse.error()), (8.25, 16.0 * 0.5 + 16.0 * 0.5));
    let design: Design = bench.finish(&[("fine", fine), ("coarse", coarse)]);
    assert_eq!(design.error_bound(), 16.0 * ULP * ULP);
}
