//! The rows of EXTREMES.md that concern the two cores, through the hardware; numbers in names and comments are its rows.
//!
//! [`common::shade`] asserts in every one that pixels, clocks, stated facts and error bounds are right, so tests say only what else is
//! wanted. Rows 7 to 9 and 11 are about other methods' normals, 13 to 20 about slerp and Newton's root, 30 about another data path, 36
//! about an arc cosine that no core has.
#[path = "../common/mod.rs"]
mod common;
mod degenerate;
mod gouraud;
mod highlights;
mod lyon_options;
mod ranges;
mod spans;
mod viewpoints;
