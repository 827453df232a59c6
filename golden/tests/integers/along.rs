//! Vectors along a span on raw values.
use specula_spec::Format;

use crate::raw::{Raw, round};

/// The formats of the weight's accumulator, the weight, the components' accumulators and the vector.
pub type Formats = [Format; 4];

/// The vector at pixel `i`: `start` and a share of `NAME_delta`, or, by repeated addition,
/// `NAME_step` as often.
pub fn vector(raw: &Raw, [start, name]: [&str; 2], i: u32, formats: Formats) -> [i128; 3] {
    let [a, w, s, v] = formats.map(|format| format.fraction_bits);
    let start = raw.vector(start);
    if raw.has(&format!("{name}_step_x")) {
        let step = raw.vector(&format!("{name}_step"));
        let sum = (0..i).fold(start, |sum, _| [0, 1, 2].map(|c| sum[c] + step[c]));
        return sum.map(|c| round(c, s, v));
    }
    let delta = raw.vector(&format!("{name}_delta"));
    let weight = round(i128::from(i) * raw.get("weight_step"), a, w);
    [0, 1, 2].map(|c| round((start[c] << w) + weight * delta[c], v + w, v))
}
