//! What is measured with a testbench: error against run time, searches for formats, ablations,
//! stress, reproduction of the papers' figures, and engines against each other.
mod ablation;
pub mod benchmark;
pub mod climb;
pub mod explore;
pub mod figure9;
pub mod operations;
mod pareto;
pub mod reproduce;
pub mod search;
mod shares;
pub mod stress;
pub mod tradeoff;

pub use ablation::{
    AgainstGeneral, Baseline, CellDelta, Saving, Savings, SizeDelta, Synthesis, ablation,
};
pub use pareto::pareto_front;
pub use shares::{Share, shares};
