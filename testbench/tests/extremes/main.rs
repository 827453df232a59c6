//! The rows of docs/extremes.md that concern the cores, through the hardware; numbers in names and
//! comments are its rows.
//!
//! [`run::assert_agrees`] asserts in every one that pixels, clocks, stated facts and error bounds are
//! right, so tests say only what else is wanted. Rows 7 to 9 and 11 are about other methods'
//! normals, 18 to 20 about Newton's root, 30 about another data path, 36 about an arc cosine that
//! no core has.
mod cores;
mod degenerate;
mod direct;
mod facets;
mod gouraud;
mod highlights;
mod lyon_options;
mod phong;
mod ranges;
mod run;
mod slerp;
mod spans;
mod viewpoints;
