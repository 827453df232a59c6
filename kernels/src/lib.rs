//! Column kernels of the cycle engine: each applies one operator to whole columns of raw values.
//!
//! A column has lanes of 32 or 64 bits. Every kernel is one loop over slices in safe Rust, compiled
//! for the baseline of the target and once more with AVX2; which of the two runs is decided once,
//! by [`InstructionSet`]. The only `unsafe` is the call of the AVX2 copy ([`Binary::run`],
//! [`Products::run`], [`Ternary::run`]), and tests hold it against the baseline copy.
#![expect(unsafe_code, reason = "a copy compiled for AVX2 is called where the processor has it")]

mod arithmetic;
mod bits;
mod instruction_set;
mod kernel;
mod lane;
mod post;
mod products;
mod serial;

pub use arithmetic::{
    Arithmetic, Extreme, extreme, narrow, narrow_through_wide, narrowing, wide, widening,
};
pub use bits::{Bits, bits, choose, less_than};
pub use instruction_set::InstructionSet;
pub use kernel::{Binary, Products, Ternary};
pub use lane::Lane;
pub use post::{Post, Shift, Wrap};
pub use products::{Magnitude, Second, narrow_products, products_through_wide, wide_products};
pub use serial::{accumulate, accumulate_in_turn, hold, look_up};
