//! golden (placeholder)
