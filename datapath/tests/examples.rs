//! The examples hold their own proven bounds in a simulation of each.
#![expect(clippy::duplicate_mod, reason = "each example brings what all of them do with a design")]
use std::error::Error;

#[path = "../examples/complex_product.rs"]
mod complex_product;
#[path = "../examples/fir.rs"]
mod fir;
#[path = "../examples/lerp.rs"]
mod lerp;
#[path = "../examples/reciprocal.rs"]
mod reciprocal;

#[test]
fn a_lerp_stays_within_its_bound() -> Result<(), Box<dyn Error>> {
    lerp::main()
}

#[test]
fn a_filter_stays_within_its_bound() -> Result<(), Box<dyn Error>> {
    fir::main()
}

#[test]
fn a_reciprocal_stays_within_its_bound() -> Result<(), Box<dyn Error>> {
    reciprocal::main()
}

#[test]
fn a_complex_product_stays_within_its_bound() -> Result<(), Box<dyn Error>> {
    complex_product::main()
}
