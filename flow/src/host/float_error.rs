//! How far host code in float is off.
use specula_datapath::format::power_of_two;

use super::code::SentInput;
use super::program::Given;

/// Units of a float's last place by which a value of an input may be off before it is rounded.
const UNITS_OF_FLOAT: f64 = 16.0;
/// Fraction bits of floats from 1/2 to 1.
const FRACTION_BITS: i64 = 24;

/// By how many units of its last place an input may be off that is computed in float.
pub fn float_error(input: &SentInput) -> i64 {
    let (format, (low, high)) = (input.port.format, input.port.range);
    // What small values are made of is about 1.
    let largest = (low.abs().max(high.abs()) as f64 * format.ulp()).max(1.0);
    let scale = power_of_two(i64::from(format.fraction_bits) - FRACTION_BITS);
    let one = 1 + (UNITS_OF_FLOAT * largest * scale).floor() as i64;
    match input.given {
        Given::Rounded(_) => one,
        Given::Difference { .. } => 2 * one,
    }
}
