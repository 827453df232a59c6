//! The product of complex numbers, (a + ib)(c + id), by three multipliers instead of four.
//!
//! ```text
//! cargo run --release -p specula-datapath --example complex_product
//! ```
mod common;

use std::error::Error;

use specula_datapath::builder::{Builder, Sig};
use specula_datapath::{Format, InputPort, SpanPacket};

/// A complex number.
struct Complex {
    re: Sig,
    im: Sig,
}

/// With k = c (a + b), the product is k - b (c + d) + i (k + a (d - c)), to `fraction_bits`.
fn product(x: &Complex, y: &Complex, fraction_bits: u32) -> Complex {
    let k = &y.re * (&x.re + &x.im);
    let re = &k - &x.im * (&y.re + &y.im);
    let im = &k + &x.re * (&y.im - &y.re);
    Complex { re: re.rounded(fraction_bits), im: im.rounded(fraction_bits) }
}

/// Builds, prints, simulates and judges the design.
///
/// # Errors
/// A mistake in using the builder, or an error beyond the proven bound.
pub fn main() -> Result<(), Box<dyn Error>> {
    let builder = Builder::new("complex_product", "(a + ib)(c + id)");
    let control = builder.control();
    let format = Format::signed(0, 10);
    let part = |name: &str| builder.input(&InputPort::whole(name, format));
    let (x, y) =
        (Complex { re: part("a"), im: part("b") }, Complex { re: part("c"), im: part("d") });
    let z = product(&x, &y, 10);
    let design = builder.finish(&control.valid, &[("re", z.re), ("im", z.im)])?;
    common::show(&design, "(a + ib)(c + id)");

    // Whole turns of the unit circle, quantised as a host would.
    let angle = |k: i32| f64::from(k) * 0.017;
    let real: Vec<[f64; 4]> = (0..2000)
        .map(|k| [angle(k).cos(), angle(k).sin(), angle(7 * k).cos(), angle(7 * k).sin()])
        .map(|row| row.map(|value| value.clamp(-1.0, format.value(format.max_raw()))))
        .collect();
    let spans = real
        .iter()
        .map(|row| SpanPacket::pixel(row.map(|value| format.quantise(value)).to_vec()))
        .collect();
    let products: Vec<Vec<f64>> =
        real.iter().map(|[a, b, c, d]| vec![a * c - b * d, a * d + b * c]).collect();
    common::judged(&design, &common::simulated(&design, &spans)?, &products)
}
