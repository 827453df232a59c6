//! hdl (placeholder)
