//! A filter of five taps over the pixels of a span: y(i) = Σ c(k) x(i - k), with x before the span
//! as at its first pixel.
//!
//! ```text
//! cargo run --release -p specula-datapath --example fir
//! ```
mod common;

use std::error::Error;

use specula_datapath::builder::{Builder, LoopInvariant, Sig};
use specula_datapath::{Format, InputPort, SpanPacket};

/// Binomial coefficients, in sixteenths.
const COEFFICIENTS: [i64; 5] = [1, 4, 6, 4, 1];

/// The last five values of a signal, the present one first.
fn taps(builder: &Builder, first: &Sig, x: &Sig) -> [Sig; 5] {
    let invariant =
        LoopInvariant { limits: (0.0, 1.0), fact: "taps are inputs", error: x.error_value() };
    builder.carried(first, ([x; 5], [x]), x.fraction_bits(), &invariant, |before, [now]| {
        let [a, b, c, d, _] = before;
        [now, a, b, c, d].map(Sig::clone)
    })
}

/// Builds, prints, simulates and judges the design.
///
/// # Errors
/// A mistake in using the builder, or an error beyond the proven bound.
pub fn main() -> Result<(), Box<dyn Error>> {
    let builder = Builder::new("fir", "y(i) = sum of c(k) x(i - k)");
    let control = builder.control();
    let format = Format::unsigned(0, 12);
    let start = builder.input(&InputPort::whole("start_value", format));
    let step = builder.input(&InputPort::whole("step", Format::signed(0, 12)));
    // What is filtered: a ramp, which the span's first pixel loads.
    let fact = "the ramp stays below 1";
    let x = Sig::accumulated(&control.start, &start, &step, (0.0, 1.0), 63, fact);
    let first = control.start.clone();
    let weighted = taps(&builder, &first, &x)
        .iter()
        .zip(COEFFICIENTS)
        .map(|(tap, c)| tap * builder.integer(c))
        .reduce(|sum, term| sum + term)
        .ok_or("a filter has taps")?;
    let y = weighted.times_power_of_two(-4).rounded(12);
    let design = builder.finish(&control.valid, &[("y", y)])?;
    common::show(&design, "y(i) = sum of c(k) x(i - k)");

    let ramps = [(0.0, 0.01), (0.9, -0.012), (0.5, 0.0), (0.25, 0.011)];
    let spans: Vec<SpanPacket> = ramps
        .iter()
        .map(|&(start, step)| SpanPacket {
            length: 64,
            inputs: vec![format.quantise(start), Format::signed(0, 12).quantise(step)],
        })
        .collect();
    let filtered = |&(start, step): &(f64, f64), i: i32| {
        let x = |i: i32| start + step * f64::from(i.max(0));
        let terms = COEFFICIENTS.iter().zip(0..).map(|(&c, k)| c as f64 / 16.0 * x(i - k));
        vec![terms.sum::<f64>()]
    };
    let real: Vec<Vec<f64>> =
        ramps.iter().flat_map(|ramp| (0..64).map(move |i| filtered(ramp, i))).collect();
    common::judged(&design, &common::simulated(&design, &spans)?, &real)
}
