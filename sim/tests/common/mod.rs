//! What several test programs share.
// Each test program takes what it needs.
#![allow(dead_code)]
pub mod dump;
pub mod engines;
pub mod frames;
pub mod number;
pub mod program;
pub mod random;
pub mod tools;
