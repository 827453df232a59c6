//! Models of the ECP5's blocks in Icarus, against Rust's arithmetic.
mod bench;
mod memory;
mod multiplier;
