//! Kernels with feedback, whose lanes depend on the lanes before.
use std::hint::select_unpredictable;

use crate::Lane;

/// For each lane: value = first ? start : state, then state ← enabled ? `wrap` of value + step :
/// state. `state` is the accumulator before the first lane and, afterwards, behind the last.
/// `enabled` says of each lane whether it counts.
pub fn accumulate<S: Lane, T: Lane, O: Lane>(
    out: &mut [O],
    first: &[i32],
    (start, step): (&[S], &[T]),
    state: &mut i64,
    enabled: impl Fn(usize) -> bool,
    wrap: impl Fn(i64) -> i64,
) {
    let n = out.len();
    let (first, start, step) = (&first[..n], &start[..n], &step[..n]);
    let mut q = *state;
    for i in 0..n {
        let value = select_unpredictable(first[i] != 0, start[i].to_i64(), q);
        out[i] = O::from_i64(value);
        q = select_unpredictable(enabled(i), wrap(value.wrapping_add(step[i].to_i64())), q);
    }
    *state = q;
}

/// As [`accumulate`], of several states that take turns: a lane that counts leaves its own behind
/// the others. `states` holds at least one, the next one first.
pub fn accumulate_in_turn<S: Lane, T: Lane, O: Lane>(
    out: &mut [O],
    first: &[i32],
    (start, step): (&[S], &[T]),
    states: &mut [i64],
    enabled: impl Fn(usize) -> bool,
    wrap: impl Fn(i64) -> i64,
) {
    let n = out.len();
    let (first, start, step) = (&first[..n], &start[..n], &step[..n]);
    let mut next = 0;
    for i in 0..n {
        let value = select_unpredictable(first[i] != 0, start[i].to_i64(), states[next]);
        out[i] = O::from_i64(value);
        if enabled(i) {
            states[next] = wrap(value.wrapping_add(step[i].to_i64()));
            next = if next + 1 == states.len() { 0 } else { next + 1 };
        }
    }
    states.rotate_left(next);
}

/// For each lane: state ← enable ? `wrap` of value : state; the column holds the new state. `state`
/// is the register before the first lane and, afterwards, behind the last.
pub fn hold<I: Lane, O: Lane>(
    out: &mut [O],
    enable: &[i32],
    value: &[I],
    state: &mut i64,
    wrap: impl Fn(i64) -> i64,
) {
    let n = out.len();
    let (enable, value) = (&enable[..n], &value[..n]);
    let mut q = *state;
    for i in 0..n {
        q = select_unpredictable(enable[i] != 0, wrap(value[i].to_i64()), q);
        out[i] = O::from_i64(q);
    }
    *state = q;
}

/// The entries of `table` at `address`; an address behind the last entry gives 0.
pub fn look_up<O: Lane>(out: &mut [O], address: &[i32], table: &[i64]) {
    for (out, &at) in out.iter_mut().zip(address) {
        *out = O::from_i64(table.get(at as usize).copied().unwrap_or(0));
    }
}
