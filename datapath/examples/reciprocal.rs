//! 1/x for x in [1, 2): a table of 32 entries and a Newton step.
//!
//! ```text
//! cargo run --release -p specula-datapath --example reciprocal
//! ```
mod common;

use std::error::Error;

use specula_datapath::builder::{Builder, Sig};
use specula_datapath::{Format, InputPort, SpanPacket};

/// Fraction bits of x, of the table's entries, and of the result.
const FRACTION_BITS: u32 = 16;

/// Address bits of the table.
const ADDRESS_BITS: u32 = 5;

/// The reciprocal in the middle of each of the table's parts of [1, 2).
fn entry(part: i64) -> f64 {
    1.0 / (1.0 + (part as f64 + 0.5) / f64::from(1 << ADDRESS_BITS))
}

/// y = y0 (2 - x y0), y0 from the table.
///
/// With y0 = (1 + d)/x, y is (1 - d²)/x. In a part of width w = 2^-5 the entry is off by
/// |d| <= w/2 (x >= 1), and by half a unit u of its last place times x < 2 more:
///
/// ```text
/// |y - 1/x| <= d²/x <= (w/2 + u)²
/// ```
///
/// and rounding y takes half a unit u. That is against the reciprocal of the x that came in; the
/// real one is off by half a unit, which moves 1/x by no more than half a unit.
fn reciprocal(builder: &Builder, x: &Sig) -> Sig {
    let part = (x - builder.integer(1)).truncated(ADDRESS_BITS).raw();
    let format = Format::unsigned(0, FRACTION_BITS);
    let entries = (0..1 << ADDRESS_BITS).map(|part| format.quantise(entry(part))).collect();
    let y0 = part.looked_up(entries, FRACTION_BITS, 0.5).named("table_entry"); // U0.16
    let twice = builder.integer(2) - (x * &y0).rounded(FRACTION_BITS + 4); // U1.20, near 1
    let y = (&y0 * twice).rounded(FRACTION_BITS); // U1.16
    let (w, u) = (2f64.powi(-(ADDRESS_BITS as i32)), x.ulp());
    // (x y0).rounded is off by half a unit of 20 bits, which y0 <= 1 makes no larger.
    y.override_error("reciprocal", (w / 2.0 + u).powi(2) + u / 32.0 + u / 2.0 + u / 2.0)
}

/// Builds, prints, simulates and judges the design.
///
/// # Errors
/// A mistake in using the builder, or an error beyond the proven bound.
pub fn main() -> Result<(), Box<dyn Error>> {
    let builder = Builder::new("reciprocal", "1/x for x in [1, 2)");
    let control = builder.control();
    let format = Format::unsigned(1, FRACTION_BITS);
    let one = 1 << FRACTION_BITS;
    let port = InputPort { range: (one, 2 * one - 1), ..InputPort::whole("x", format) };
    let x = builder.input(&port);
    let y = reciprocal(&builder, &x);
    let design = builder.finish(&control.valid, &[("y", y)])?;
    common::show(&design, "1/x for x in [1, 2)");

    // Every x there is, each a little more than the host's rounded one.
    let spans = (one..2 * one).map(|raw| SpanPacket::pixel(vec![raw])).collect();
    let real: Vec<Vec<f64>> = (one..2 * one).map(|raw| vec![1.0 / format.value(raw)]).collect();
    common::judged(&design, &common::simulated(&design, &spans)?, &real)
}
