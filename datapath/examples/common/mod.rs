//! What every example does with its design: print it, simulate it, hold it against f64.
use std::error::Error;

use specula_datapath::verilog::{Header, print};
use specula_datapath::{Design, SpanPacket};
use specula_sim::{Batch, Columns, Engine, Fast, Flow, Stimulus};

/// Prints the design's Verilog and what is proven of it.
pub fn show(design: &Design, formula: &str) {
    println!("{}", print(&design.to_block(), &Header { lines: vec![formula.to_owned()] }));
    println!("// latency {} clocks, proven error {:.6}", design.latency(), design.error_bound());
}

/// What leaves the design for each pixel of these spans, as values, simulated clock by clock.
pub fn simulated(
    design: &Design,
    spans: &Vec<SpanPacket>,
) -> Result<Vec<Vec<f64>>, Box<dyn Error>> {
    let stimulus = Stimulus::whole(spans, design);
    let mut seen = Columns::new(&design.outputs);
    Fast::new(design).run(&stimulus, &design.outputs, &mut |batch: &Batch| {
        seen.extend(batch);
        Flow::Continue
    })?;
    let pixels: u32 = spans.iter().map(|span| span.length).sum();
    let first = design.latency() as usize;
    let outputs = seen.batch();
    let value = |clock: usize, k: usize| {
        let raw = outputs.lanes(k).get(clock);
        design.node(design.outputs[k]).format().value(raw)
    };
    let pixel = |clock: usize| (0..design.outputs.len()).map(|k| value(clock, k)).collect();
    Ok((first..first + pixels as usize).map(pixel).collect())
}

/// Says how far the simulation is from the real values, and fails where that is beyond the bound.
pub fn judged(
    design: &Design,
    outputs: &[Vec<f64>],
    real: &[Vec<f64>],
) -> Result<(), Box<dyn Error>> {
    let pairs = outputs.iter().flatten().zip(real.iter().flatten());
    let largest = pairs.map(|(fixed, real)| (fixed - real).abs()).fold(0.0, f64::max);
    println!("// {} values simulated, largest error {largest:.6}", outputs.len());
    if largest <= design.error_bound() {
        Ok(())
    } else {
        Err(format!("an error of {largest} is beyond the bound").into())
    }
}
