//! Every kernel, compiled for the baseline and for the best that the processor has, against plain
//! arithmetic.
//!
//! Columns have from no lanes to several vectors and a tail, and operands begin anywhere.
mod arithmetic;
mod lanes;
mod logic;
mod products;
mod serial;
