//! The arithmetic of the host, which rounds the inputs.

/// What the host's f64 arithmetic adds to the error of an accumulated value at most, which shows in
/// formats finer than f64: sums of a few products no larger than 4, each off by 2^-53 of itself.
/// Steps are as small as the span is long, so they add up to no more.
pub const HOST_ERROR: f64 = 1.0 / (1u64 << 48) as f64;
