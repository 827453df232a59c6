//! Kernels whose lanes depend on the lanes before, and tables.
use std::collections::VecDeque;

use proptest::collection::vec;
use proptest::prelude::*;
use specula_kernels::{Lane, accumulate, accumulate_in_turn, hold, look_up};

use crate::lanes::{Shape, column, in_lanes, numbers, shape, unfilled};

/// The low 24 bits in two's complement.
fn low_bits(value: i64) -> i64 {
    (value << 40) >> 40
}

/// value = first ? start : state, state ← valid ? low bits of value + step : state, of so many
/// states in turn; the column comes in two parts, as batches follow each other.
fn accumulated<S: Lane, T: Lane, O: Lane>(
    (shape, states): (Shape, usize),
    cut: usize,
    [valid, first]: [&[i64]; 2],
    start: &[i64],
    step: &[i64],
) {
    let (mut kept, mut expected) = (VecDeque::from(vec![0; states]), vec![]);
    for (lane, &valid) in valid[..shape.lanes].iter().enumerate() {
        let (start, step) = (shape.of(start, 1)[lane], shape.of(step, 2)[lane]);
        let value = if shape.of(first, 0)[lane] != 0 { start } else { kept[0] };
        expected.push(value);
        if valid != 0 {
            kept.pop_front();
            kept.push_back(low_bits((i128::from(value) + i128::from(step)) as i64));
        }
    }
    let (first, start, step) = (in_lanes::<i32>(first), in_lanes::<S>(start), in_lanes::<T>(step));
    let (first, start, step) = (shape.of(&first, 0), shape.of(&start, 1), shape.of(&step, 2));
    let mut out = unfilled::<O>(shape.lanes);
    let cut = cut.min(shape.lanes);
    let (front, back) = out.split_at_mut(cut);
    let mut got = vec![0; states];
    let mut run = |out: &mut [O], from: usize| {
        let operands = (&start[from..], &step[from..]);
        let enabled = |lane: usize| valid[from + lane] != 0;
        match &mut got[..] {
            [state] => accumulate(out, &first[from..], operands, state, enabled, low_bits),
            states => {
                accumulate_in_turn(out, &first[from..], operands, states, enabled, low_bits);
            }
        }
    };
    run(front, 0);
    run(back, cut);
    assert_eq!((numbers(&out), got), (expected, Vec::from(kept)));
}

/// state ← enable ? low bits of value : state, with the column in two parts.
fn held<I: Lane, O: Lane>(shape: Shape, cut: usize, enable: &[i64], value: &[i64]) {
    let (mut state, mut expected) = (0, vec![]);
    for (&enable, &value) in shape.of(enable, 0).iter().zip(shape.of(value, 1)) {
        if enable != 0 {
            state = low_bits(value);
        }
        expected.push(state);
    }
    let (enable, value) = (in_lanes::<i32>(enable), in_lanes::<I>(value));
    let (enable, value) = (shape.of(&enable, 0), shape.of(&value, 1));
    let mut out = unfilled::<O>(shape.lanes);
    let (cut, mut got_state) = (cut.min(shape.lanes), 0);
    let (front, back) = out.split_at_mut(cut);
    hold(front, enable, value, &mut got_state, low_bits);
    hold(back, &enable[cut..], &value[cut..], &mut got_state, low_bits);
    assert_eq!((numbers(&out), got_state), (expected, state));
}

fn looked_up<O: Lane>(shape: Shape, address: &[i64], table: &[i64]) {
    let entry =
        |&at: &i64| usize::try_from(at).ok().and_then(|at| table.get(at)).copied().unwrap_or(0);
    let expected: Vec<i64> = shape.of(address, 0).iter().map(entry).collect();
    let mut out = unfilled::<O>(shape.lanes);
    look_up(&mut out, shape.of(&in_lanes::<i32>(address), 0), table);
    assert_eq!(numbers(&out), expected);
}

proptest! {
    #[test]
    fn accumulators_add_up_pixel_by_pixel(
        shape in shape(),
        cut in 0..70usize,
        states in 1..5usize,
        valid in column(1),
        first in column(1),
        narrow in column(24),
        wide in column(60),
    ) {
        let (of, control) = ((shape, states), [&valid[..], &first]);
        accumulated::<i32, i32, i32>(of, cut, control, &narrow, &narrow);
        accumulated::<i32, i32, i64>(of, cut, control, &narrow, &narrow);
        accumulated::<i32, i64, i32>(of, cut, control, &narrow, &wide);
        accumulated::<i64, i32, i64>(of, cut, control, &wide, &narrow);
        accumulated::<i64, i64, i64>(of, cut, control, &wide, &wide);
    }

    #[test]
    fn registers_that_hold(shape in shape(), cut in 0..70usize, enable in column(1), narrow in column(32), wide in column(64)) {
        held::<i32, i32>(shape, cut, &enable, &narrow);
        held::<i32, i64>(shape, cut, &enable, &narrow);
        held::<i64, i64>(shape, cut, &enable, &wide);
    }

    #[test]
    fn tables_are_looked_up_lane_by_lane(
        shape in shape(),
        address in column(5),
        far in column(32),
        narrow in vec(any::<i32>(), 0..20),
        wide in vec(any::<i64>(), 0..20),
    ) {
        let narrow: Vec<i64> = narrow.into_iter().map(i64::from).collect();
        for address in [address, far] {
            looked_up::<i32>(shape, &address, &narrow);
            looked_up::<i64>(shape, &address, &wide);
        }
    }
}
