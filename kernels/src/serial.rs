//! Kernels with feedback, whose lanes depend on the lanes before, and table look-up.
use crate::Lane;

/// For each lane: value = first ? start : state, then state ← `wrap` of value + step. `state` is
/// the accumulator before the first lane and, afterwards, behind the last.
pub fn accumulate<S: Lane, T: Lane, O: Lane>(
    out: &mut [O],
    first: &[i32],
    start: &[S],
    step: &[T],
    state: &mut i64,
    wrap: impl Fn(i64) -> i64,
) {
    let n = out.len();
    let (first, start, step) = (&first[..n], &start[..n], &step[..n]);
    let mut q = *state;
    for i in 0..n {
        let value = std::hint::select_unpredictable(first[i] != 0, start[i].to_i64(), q);
        out[i] = O::from_i64(value);
        q = wrap(value.wrapping_add(step[i].to_i64()));
    }
    *state = q;
}

/// For each lane: state ← enable ? value : state; the column holds the new state. `state` is the
/// register before the first lane and, afterwards, behind the last.
pub fn hold<I: Lane, O: Lane>(out: &mut [O], enable: &[i32], value: &[I], state: &mut i64) {
    let n = out.len();
    let (enable, value) = (&enable[..n], &value[..n]);
    let mut q = *state;
    for i in 0..n {
        q = std::hint::select_unpredictable(enable[i] != 0, value[i].to_i64(), q);
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
