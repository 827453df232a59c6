//! Comparisons, bitwise operators and multiplexers.
use proptest::prelude::*;
use specula_kernels::{Bits, Extreme, Lane, Wrap, bits, choose, extreme, less_than};

use crate::lanes::{Shape, column, in_lanes, instruction_sets, numbers, shape, unfilled};

fn compared<L: Lane + PartialOrd>(shape: Shape, a: &[i64], b: &[i64]) {
    let (x, y) = (in_lanes::<L>(a), in_lanes::<L>(b));
    let expected: Vec<i64> =
        shape.of(a, 0).iter().zip(shape.of(b, 1)).map(|(a, b)| i64::from(a < b)).collect();
    for instruction_set in instruction_sets() {
        let mut out = unfilled::<i32>(shape.lanes);
        less_than::<L>(instruction_set).run(&mut out, shape.of(&x, 0), shape.of(&y, 1));
        assert_eq!(numbers(&out), expected, "{}", instruction_set.name());
    }
}

fn combined<L>(shape: Shape, a: &[i64], b: &[i64])
where
    L: Lane + std::ops::BitAnd<Output = L> + std::ops::BitOr<Output = L>,
{
    let (x, y) = (in_lanes::<L>(a), in_lanes::<L>(b));
    for operator in [Bits::And, Bits::Or] {
        let meaning = |(&a, &b): (&i64, &i64)| if operator == Bits::And { a & b } else { a | b };
        let expected: Vec<i64> = shape.of(a, 0).iter().zip(shape.of(b, 1)).map(meaning).collect();
        for instruction_set in instruction_sets() {
            let mut out = unfilled::<L>(shape.lanes);
            bits::<L>(operator, instruction_set).run(&mut out, shape.of(&x, 0), shape.of(&y, 1));
            assert_eq!(numbers(&out), expected, "{operator:?} {}", instruction_set.name());
        }
    }
}

fn chosen<L: Lane>(shape: Shape, condition: &[i64], yes: &[i64], no: &[i64]) {
    let (c, x, y) = (in_lanes::<i32>(condition), in_lanes::<L>(yes), in_lanes::<L>(no));
    let branches = shape.of(yes, 0).iter().zip(shape.of(no, 1));
    let expected: Vec<i64> = shape
        .of(condition, 2)
        .iter()
        .zip(branches)
        .map(|(&c, (&yes, &no))| if c != 0 { yes } else { no })
        .collect();
    for instruction_set in instruction_sets() {
        let mut out = unfilled::<L>(shape.lanes);
        choose::<L>(instruction_set).run(
            &mut out,
            shape.of(&c, 2),
            shape.of(&x, 0),
            shape.of(&y, 1),
        );
        assert_eq!(numbers(&out), expected, "{}", instruction_set.name());
    }
}

fn limited(shape: Shape, a: &[i64], b: &[i64]) {
    let (x, y) = (in_lanes::<i32>(a), in_lanes::<i32>(b));
    for which in [Extreme::Min, Extreme::Max] {
        let meaning =
            |(&a, &b): (&i64, &i64)| if which == Extreme::Min { a.min(b) } else { a.max(b) };
        let expected: Vec<i64> = shape.of(a, 0).iter().zip(shape.of(b, 1)).map(meaning).collect();
        let low_bits: Vec<i64> = expected.iter().map(|value| value & 0x7FFF).collect();
        for instruction_set in instruction_sets() {
            for (wrap, expected) in [(Wrap::None, &expected), (Wrap::Unsigned(15), &low_bits)] {
                let mut out = unfilled::<i32>(shape.lanes);
                extreme(which, wrap, instruction_set).run(
                    &mut out,
                    shape.of(&x, 0),
                    shape.of(&y, 1),
                );
                assert_eq!(
                    numbers(&out),
                    *expected,
                    "{which:?} {wrap:?} {}",
                    instruction_set.name()
                );
            }
        }
    }
}

/// Columns that are equal in many lanes, so that comparisons see equal values.
fn alike(bits: u32) -> impl Strategy<Value = (Vec<i64>, Vec<i64>)> {
    (column(bits), column(bits), any::<bool>())
        .prop_map(|(a, b, same)| if same { (a.clone(), a) } else { (a, b) })
}

proptest! {
    #[test]
    fn comparisons_are_made_lane_by_lane(shape in shape(), (a, b) in alike(32), (c, d) in alike(64)) {
        compared::<i32>(shape, &a, &b);
        compared::<i64>(shape, &c, &d);
    }

    #[test]
    fn smaller_and_larger_are_taken_lane_by_lane(shape in shape(), (a, b) in alike(32)) {
        limited(shape, &a, &b);
    }

    #[test]
    fn bits_are_combined_lane_by_lane(shape in shape(), (a, b) in alike(32), (c, d) in alike(64)) {
        combined::<i32>(shape, &a, &b);
        combined::<i64>(shape, &c, &d);
    }

    #[test]
    fn choices_are_made_lane_by_lane(shape in shape(), condition in column(1), (a, b) in alike(32), (c, d) in alike(64)) {
        chosen::<i32>(shape, &condition, &a, &b);
        chosen::<i64>(shape, &condition, &c, &d);
    }
}
