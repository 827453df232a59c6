//! Every kernel, compiled for the baseline and for the best instruction set of the processor,
//! against plain arithmetic.
//!
//! Columns have from no lanes to several vectors and a tail, and operands begin at any lane.
mod arithmetic;
mod lanes;
mod logic;
mod products;
mod serial;
