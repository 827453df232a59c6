//! Measurements made with a test bench: error against run time, searches for formats, ablations,
//! stress, reproduction of the papers' figures, and benchmarks of engines.
mod ablation;
pub mod auto;
pub mod benchmark;
mod bound_shares;
pub mod climb;
pub mod cost;
pub mod explore;
pub mod figure9;
pub mod formats;
pub mod operations;
mod pareto;
mod picture;
pub mod reproduce;
pub mod search;
pub mod stress;
pub mod tradeoff;

pub use ablation::{
    AgainstGeneral, Baseline, CellDelta, KeepCost, KeepError, Saving, Savings, SizeDelta,
    Synthesis, ablation, keep_costs,
};
pub use bound_shares::{BoundShare, bound_shares};
pub use pareto::pareto_front;
