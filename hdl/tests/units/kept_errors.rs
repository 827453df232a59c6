//! Bounds that must not be lost where hardware is left out, merged or shared: every operator on
//! constants, twins and choices, against real values that the host rounded.
use specula_datapath::builder::{LoopInvariant, Sig};
use specula_fixtures::Draw;
use specula_spec::Format;
use specula_spec::format::power_of_two;

use super::{Bench, outputs};

/// 2^-3.
const FORMAT: Format = Format::signed(3, 3);
const WHOLE: (i64, i64) = (-24, 24);

/// What is known of a condition is not what is known of its real counterpart: x < 1 of an x that is
/// always short of it by less than it is off.
#[test]
fn a_condition_that_is_always_the_same_may_come_out_otherwise_for_the_real_value() {
    let bench = Bench::new();
    let one = bench.b.integer(1);
    let x = bench.input("x", FORMAT, (7, 7)).override_error("stated", 0.5);
    let below = x.less_than(&one);
    let (near, far) = (bench.input("near", FORMAT, WHOLE), x.clone());
    for chosen in [below.choose(&near, &far), below.not().choose(&far, &near)] {
        assert_eq!(chosen.id(), near.id(), "no multiplexer is built");
        assert_eq!(chosen.error_value(), 0.5);
    }
}

/// What a unit says of choices that come out otherwise outlasts clamps: the real value may be
/// anywhere.
#[test]
fn what_is_stated_of_a_choice_is_not_cut_off_by_what_was_known_before() {
    let bench = Bench::new();
    let clamped = bench.input("x", FORMAT, (0, 0)).at_least_zero().clamped_above(1);
    let unsure = bench.b.integer(0).less_than(&clamped).override_error("stated", 1.0);
    let chosen = unsure.choose(&clamped, &bench.b.integer(0));
    assert_eq!(chosen.error_value(), FORMAT.ulp() / 2.0);
    assert_eq!(chosen.override_error("stated", 1.0).error_value(), 1.0);
}

/// The real value of a constant 0 that is off by 4 lies from -4 to 0 after a clamp, and from 0 to 4
/// without its sign.
#[test]
fn a_value_without_its_sign_may_have_had_one() {
    let bench = Bench::new();
    let below = bench.input("x", FORMAT, (0, 0)).override_error("stated", 4.0).clamped_above(0);
    assert_eq!(below.at_least_zero().error_value(), 0.0);
    assert_eq!(below.absolute().error_value(), 4.0);
    assert_eq!(below.absolute().at_least_zero().error_value(), 4.0);
}

/// A constant input is off by half a unit, counted in units of what shifts, roundings and
/// truncations make of it.
#[test]
fn shifted_constants_are_off_as_their_value_is() {
    for raw in [0, 1, -5, 8] {
        let bench = Bench::new();
        let half_unit = FORMAT.ulp() / 2.0;
        let x = bench.input("x", FORMAT, (raw, raw));
        for exponent in [-5, -1, 0, 1, 3, 5] {
            let moved = x.times_power_of_two(exponent);
            assert_eq!(
                moved.error_value(),
                half_unit * power_of_two(exponent.into()),
                "{exponent}"
            );
        }
        assert_eq!(x.rounded(1).error_value(), half_unit + 0.25);
        assert_eq!(x.truncated(1).error_value(), half_unit + 0.5);
        assert_eq!(x.low_bits(0).error_value(), half_unit);
        for factor in [2, 4] {
            let product = bench.input("y", FORMAT, WHOLE) * bench.b.integer(factor);
            assert_eq!(product.error_value(), half_unit * factor as f64, "only wires");
        }
    }
}

/// An entry is off by what the caller says of the table, also where the address is a constant and
/// no table is built.
#[test]
fn entries_at_a_constant_address_are_off_as_any() {
    let bench = Bench::new();
    for address in [0, 1, 7] {
        let entry = bench.b.integer(address).looked_up(vec![3, 5], 4, 0.5);
        assert_eq!(entry.error(), 0.5, "{address}");
    }
}

/// The bound of what goes round is the one that is proven above it, whatever its start and what
/// follows are.
#[test]
fn loops_of_constants_are_off_as_is_known_of_them() {
    let bench = Bench::new();
    let zero = bench.input("zero", FORMAT, (0, 0));
    let invariant = || LoopInvariant { limits: (-1.0, 1.0), fact: "it stays", error: 0.75 };
    let [held] = bench.b.recurrence(&bench.start, [&zero], 3, &invariant(), |[x]| [x.clone()]);
    let [carried] =
        bench.b.carried(&bench.start, ([&zero], [&zero]), 3, &invariant(), |[x], [y]| {
            [(x + y).rounded(3)]
        });
    for value in [held, carried] {
        assert_eq!(value.error_value(), 0.75);
        assert_eq!(value.rounded(2).error_value(), 0.75 + 0.125);
        assert_eq!(value.at_least_zero().error_value(), 0.75);
    }
}

/// Terms that the host rounded to 0 are off at every clock of a pixel.
#[test]
fn what_adds_up_over_the_turns_of_a_pixel_is_off_by_every_term() {
    let bench = Bench::new();
    let [start, term] = ["start", "term"].map(|name| bench.input(name, FORMAT, (0, 0)));
    let sum = Sig::summed(&bench.start, &start, &term, (0.0, 4.0), 4, "it stays");
    assert_eq!(sum.error(), 0.5 + 4.0 * 0.5);
}

/// Registers that hold a constant hold its error.
#[test]
fn held_constants_keep_the_larger_error() {
    let bench = Bench::new();
    let one = bench.b.integer(1);
    let fine = bench.input("fine", FORMAT, (0, 0));
    let coarse = fine.clone().override_error("stated", 1.0);
    assert_eq!(coarse.held(&one).error_value(), 1.0);
    for (value, loaded) in [(&fine, &coarse), (&coarse, &fine)] {
        assert_eq!(value.held_or_loaded(&one, &bench.start, loaded).error_value(), 1.0);
    }
}

/// A signal, and the real values that it stands for at each sample.
#[derive(Clone)]
struct Term {
    sig: Sig,
    real: Vec<f64>,
}

impl Term {
    fn with(&self, sig: Sig, real: impl Fn(f64) -> f64) -> Term {
        Term { sig, real: self.real.iter().map(|&x| real(x)).collect() }
    }

    fn and(&self, other: &Term, sig: Sig, real: impl Fn(f64, f64) -> f64) -> Term {
        let pairs = self.real.iter().zip(&other.real);
        Term { sig, real: pairs.map(|(&x, &y)| real(x, y)).collect() }
    }
}

/// Raw values of the ports and what was rounded to them, for each sample.
struct Samples {
    rows: Vec<Vec<i64>>,
    reals: Vec<Vec<f64>>,
}

const SAMPLES: usize = 40;

impl Samples {
    fn new() -> Samples {
        Samples { rows: vec![Vec::new(); SAMPLES], reals: Vec::new() }
    }

    /// A port of a few values or of one, each off by up to half a unit.
    fn port(&mut self, bench: &Bench, draw: &mut Draw) -> Term {
        let number = self.reals.len();
        let low = i64::from(draw.between_or_end(0, 32)) - 16;
        let high = low + i64::from(draw.one_of(&[0, 0, 0, 1, 5]));
        let sig = bench.input(&format!("x{number}"), FORMAT, (low, high));
        let real = self.rows.iter_mut().map(|row| {
            let raw = low + i64::from(draw.between_or_end(0, (high - low) as u32));
            row.push(raw);
            let off = match draw.between_or_end(0, 3) {
                0 => -0.5,
                1 => 0.5,
                _ => draw.unit() - 0.5,
            };
            (raw as f64 + off) * FORMAT.ulp()
        });
        let real: Vec<f64> = real.collect();
        self.reals.push(real.clone());
        Term { sig, real }
    }
}

/// An operator on terms that there are.
fn grown(bench: &Bench, draw: &mut Draw, terms: &[Term]) -> Term {
    let any =
        |draw: &mut Draw| terms[draw.between_or_end(0, terms.len() as u32 - 1) as usize].clone();
    let (a, b) = (any(draw), any(draw));
    let limit = i64::from(draw.between_or_end(0, 3)) - 1;
    match draw.between_or_end(0, 13) {
        0 => a.and(&b, &a.sig + &b.sig, |x, y| x + y),
        1 => a.and(&b, &a.sig - &b.sig, |x, y| x - y),
        2 => a.and(&b, &a.sig * &b.sig, |x, y| x * y),
        3 => a.with(a.sig.squared(), |x| x * x),
        4 => a.with(a.sig.rounded(draw.between_or_end(1, 4)), |x| x),
        5 => a.with(a.sig.truncated(draw.between_or_end(1, 4)), |x| x),
        6 => a.with(a.sig.clamped_below(limit), |x| x.max(limit as f64)),
        7 => a.with(a.sig.clamped_above(limit), |x| x.min(limit as f64)),
        8 => a.with(a.sig.absolute(), f64::abs),
        9 => a.with(a.sig.at_least_zero().clamped_above(1), |x| x.clamp(0.0, 1.0)),
        10 => a.with(-&a.sig, |x| -x),
        11 => {
            let exponent = draw.between_or_end(0, 4) as i32 - 2;
            a.with(a.sig.times_power_of_two(exponent), |x| x * 2f64.powi(exponent))
        }
        // A choice by a bit of the formula, and one of pieces that meet: the larger and the smaller.
        12 => {
            let bit = bench.b.integer(draw.between_or_end(0, 1).into());
            let is_a = bit.is(&bench.b.integer(1));
            a.and(&b, bit.choose(&a.sig, &b.sig), |x, y| if is_a { x } else { y })
        }
        _ => a.and(&b, a.sig.less_than(&b.sig).choose(&b.sig, &a.sig), f64::max),
    }
}

/// Widths and depth at which a design stays small.
fn is_small(term: &Term) -> bool {
    term.sig.fraction_bits() <= 16 && term.sig.range().width() <= 24
}

/// Whatever operators are put together, of ports that are always the same and of others, no output
/// is off by more than it says. Ten thousand signals.
#[test]
fn no_operator_is_off_by_more_than_it_says() {
    let mut closest: f64 = 0.0;
    for seed in 0..400 {
        let (bench, mut draw, mut samples) = (Bench::new(), Draw::new(seed), Samples::new());
        let mut terms: Vec<Term> = (0..4).map(|_| samples.port(&bench, &mut draw)).collect();
        while terms.len() < 30 {
            let next = grown(&bench, &mut draw, &terms);
            if is_small(&next) {
                terms.push(next);
            }
        }
        let ulps: Vec<(f64, f64)> =
            terms.iter().map(|term| (term.sig.ulp(), term.sig.error_value())).collect();
        let names: Vec<String> = (0..terms.len()).map(|k| format!("out{k}")).collect();
        let signals: Vec<(&str, Sig)> = names
            .iter()
            .zip(&terms)
            .map(|(name, term)| (name.as_str(), term.sig.clone()))
            .collect();
        let design = bench.finish(&signals);
        for (sample, got) in outputs(&design, &samples.rows).into_iter().enumerate() {
            for (k, (raw, &(ulp, error))) in got.into_iter().zip(&ulps).enumerate() {
                let off = (raw as f64 * ulp - terms[k].real[sample]).abs();
                assert!(off <= error + 1e-9, "seed {seed}, {}: {off} of {error}", names[k]);
                closest = closest.max(if error > 0.0 { off / error } else { 0.0 });
            }
        }
    }
    assert!(closest > 0.999, "{closest}");
}
