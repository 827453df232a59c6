//! What is measured with a testbench: error against run time, searches for formats, ablations,
//! stress, reproduction of the papers' figures, and engines against each other.
pub mod benchmark;
pub mod climb;
pub mod explore;
pub mod figure9;
pub mod operations;
mod pareto;
pub mod reproduce;
mod savings;
pub mod search;
mod shares;
pub mod stress;
pub mod tradeoff;

pub use pareto::pareto_front;
pub use savings::{
    AgainstGeneral, Baseline, Saving, Savings, Spared, SparedCells, Synthesis, savings,
};
pub use shares::{Share, shares};
