//! testbench (placeholder)
