//! Cosines and bases, over every pair of small operands.
use specula_datapath::bound::Interval;
use specula_hdl::units::{self, Base};
use specula_spec::Format;

use super::{Bench, outputs, rounded};

const P: Format = Format::signed(1, 4);
const Q: Format = Format::signed(1, 4);

fn pairs(a: (i64, i64), b: (i64, i64)) -> Vec<Vec<i64>> {
    (a.0..=a.1).flat_map(|a| (b.0..=b.1).map(move |b| vec![a, b])).collect()
}

/// The s with (s - 1/2)² q ≤ 1 < (s + 1/2)² q, q of 4 bits at 2^-4 or more, s of `bits`.
fn reciprocal_root(q: i64, bits: u32) -> i64 {
    let one = 1i64 << (2 * bits + 2 + 4);
    (0..=4i64 << bits).find(|s| (2 * s + 1).pow(2) * q > one).expect("1/sqrt q is 4 at most")
}

/// c = p/√q through s, with q = 0 and below included.
#[test]
fn every_cosine_is_rounded_and_limited() {
    for (root_bits, cosine_bits) in [(5, 4), (3, 6), (4, 10)] {
        let bench = Bench::new();
        let ends = (P.min_raw(), P.max_raw());
        let (p, q) = (bench.input("p", P, ends), bench.input("q", Q, (Q.min_raw(), 16)));
        let length = units::root(&bench.b, &q, Format::unsigned(2, root_bits));
        let cosine = units::cosine(&bench.b, &p, &length, cosine_bits);
        let amount = units::clamp_nonnegative(&bench.b, &cosine, 3);
        let design = bench.finish(&[("cosine", cosine), ("amount", amount)]);
        let rows = pairs(ends, (Q.min_raw(), 16));
        for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
            let s = if row[1] > 0 { reciprocal_root(row[1], root_bits) } else { 0 };
            let product = row[0] * s;
            let from = 4 + root_bits;
            let nearest =
                if from > cosine_bits { rounded(product, from - cosine_bits) } else { product };
            // A product with fewer bits than asked for keeps those it has.
            let bits = from.min(cosine_bits);
            let cosine = nearest.clamp(-1 << bits, 1 << bits);
            assert_eq!(got, [cosine, rounded(cosine, bits - 3).max(0)], "{row:?}");
        }
    }
}

/// P w of a reciprocal, clamped.
#[test]
fn every_cosine_by_a_reciprocal_is_rounded_and_limited() {
    let bench = Bench::new();
    let ends = (P.min_raw(), P.max_raw());
    let (p, w) = (bench.input("p", P, ends), bench.input("w", Format::unsigned(3, 3), (0, 32)));
    let cosine = units::cosine_by_reciprocal(&bench.b, &p, &p, &w, 5);
    let design = bench.finish(&[("cosine", cosine)]);
    let rows = pairs(ends, (0, 32));
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        assert_eq!(got, [rounded(row[0] * row[1], 2).clamp(-32, 32)], "{row:?}");
    }
}

/// 2 v c - L·V from 0 to 1, for every v and c, some L·V, and with and without a direction.
#[test]
fn every_reflected_base_is_rounded_and_limited() {
    let bench = Bench::new();
    let ends = (-16, 16);
    let (v, c) = (bench.input("v", P, ends), bench.input("c", P, ends));
    let (dot_view, q) =
        (bench.input("dot_view", P, ends), bench.input("q", Format::unsigned(1, 0), (0, 1)));
    let has_direction = bench.b.integer(0).less_than(&q);
    let to = Base { fraction_bits: 5, product_error: f64::INFINITY };
    let base = units::reflected_base(&bench.b, (&v, &c), &dot_view, &has_direction, to);
    let design = bench.finish(&[("base", base)]);
    let with = |row: Vec<i64>| {
        [-16, -7, 0, 5, 16]
            .into_iter()
            .flat_map(move |l| [0, 1].map(|q| [row.clone(), vec![l, q]].concat()))
    };
    let rows: Vec<Vec<i64>> = pairs(ends, ends).into_iter().flat_map(with).collect();
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        let exact = 2 * row[0] * row[1] - (row[2] << 4);
        assert_eq!(got, [row[3] * rounded(exact, 3).clamp(0, 32)], "{row:?}");
    }
}

/// What is lost with the direction of a normal is all of the base, where rounding may decide that:
/// N·V of 0 leaves -L·V.
#[test]
fn a_base_whose_direction_is_unsure_may_be_off_by_all_of_it() {
    for (smallest, wanted) in [(0.25, false), (0.0, true)] {
        let bench = Bench::new();
        let q = bench
            .input("q", Format::unsigned(1, 4), (0, 16))
            .real_within(Interval::at_least(smallest), "stated");
        let [v, dot_view] = ["v", "dot_view"].map(|name| bench.input(name, P, (0, 0)));
        let length = units::root(&bench.b, &q, Format::unsigned(2, 5));
        let to = Base { fraction_bits: 5, product_error: f64::INFINITY };
        let base = units::reflected_base(&bench.b, (&v, &v), &dot_view, &length.has_direction, to);
        assert_eq!(base.error_value() >= 1.0, wanted, "{smallest}: {}", base.error_value());
    }
}
