//! Linear interpolation, a + t (b - a), of bytes: beside its formula, with its proof.
//!
//! ```text
//! cargo run --release -p specula-datapath --example lerp
//! ```
mod common;

use std::error::Error;

use specula_datapath::builder::{Builder, Sig};
use specula_datapath::{Format, InputPort, SpanPacket};

/// a + t (b - a), rounded to a whole number.
fn lerp(a: &Sig, b: &Sig, t: &Sig) -> Sig {
    (a + t * (b - a)).rounded(0) // U8.0: between a and b, since 0 <= t < 1
}

/// Builds, prints, simulates and judges the design.
///
/// # Errors
/// A mistake in using the builder, or an error beyond the proven bound.
pub fn main() -> Result<(), Box<dyn Error>> {
    let builder = Builder::new("lerp", "a + t (b - a)");
    let control = builder.control();
    let byte = Format::unsigned(8, 0);
    let [a, b] = ["a", "b"].map(|name| builder.input(&InputPort::whole(name, byte)));
    let t = builder.input(&InputPort::whole("t", Format::unsigned(0, 8)));
    let between = lerp(&a, &b, &t).assumed(0.0, 255.0, "a lerp lies between its ends");
    let design = builder.finish(&control.valid, &[("between", between)])?;
    common::show(&design, "a + t (b - a)");

    // The host rounds t to 8 bits: what the real t is, the design cannot see, and its bound covers.
    let rows: Vec<[i64; 3]> = (0..256)
        .flat_map(|t| [[0, 255, t], [255, 0, t], [17, 18, t], [200, 60, t], [0, 0, t]])
        .collect();
    let spans = rows.iter().map(|row| SpanPacket::pixel(row.to_vec())).collect();
    let real: Vec<Vec<f64>> = rows
        .iter()
        .map(|&[a, b, t]| [a, b, t].map(|raw| raw as f64))
        .map(|[a, b, t]| vec![a + (t + 0.499) / 256.0 * (b - a)])
        .collect();
    common::judged(&design, &common::simulated(&design, &spans)?, &real)
}
