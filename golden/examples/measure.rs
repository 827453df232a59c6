//! Quantisation errors of 50 000 spans a row, for the documentation:
//! `cargo run -p specula-golden --release --example measure`.
use specula_golden::exact::MethodSpan;
use specula_golden::fixed::Model;
use specula_scene::Material;
use specula_spec::lyon::Difference;
use specula_spec::{CoreSpec, Method, MethodSpec};

#[path = "../tests/common/mod.rs"]
mod common;
use common::draw::{Drawn, Draws, Range, draw_frame};
use common::{material, mirror, packet, spec, value};

const TYPICAL: Range = Range { widest: 30.0, tilt: 70.0, log2_length: 12.0, lights: 1 };
const EXTREME: Range = Range { widest: 90.0, tilt: 45.0, ..TYPICAL };

/// Differences between `fixed` and the method in f64.
#[derive(Default)]
struct Errors {
    pixels: u32,
    /// Largest before the last rounding, in LSBs.
    largest: f64,
    squares: f64,
    most_codes: f64,
}

impl Errors {
    /// Takes in the first, the last and the highlight's pixel.
    fn add(&mut self, core: &CoreSpec, drawn: &Drawn) {
        let span = &drawn.frame.spans[0];
        let (model, packet) = (Model::new(core), packet(core, &drawn.frame));
        let method = MethodSpan::new(core, &drawn.frame, span);
        for i in [0, drawn.highlight, span.steps()] {
            let trace = model.trace(&packet, i).expect("the packet is this core's");
            let exact = method.pixel(i)[0];
            let error = value(&trace, "colour_r").min(255.0) - exact;
            self.pixels += 1;
            self.largest = self.largest.max(error.abs());
            self.squares += error * error;
            self.most_codes = self.most_codes.max((value(&trace, "code_r") - exact.round()).abs());
        }
    }
}

fn row(
    name: &str,
    range: Range,
    method: Method,
    material: &Material,
    change: impl Fn(&mut CoreSpec),
) {
    let mut errors = Errors::default();
    for draw in Draws(1).take(50_000) {
        let drawn = draw_frame(range, &draw, material.clone());
        let mut core = spec(&drawn.frame, method).expect("defaults serve every frame drawn here");
        change(&mut core);
        errors.add(&core, &drawn);
    }
    let rms = (errors.squares / f64::from(errors.pixels)).sqrt();
    let (method, n) = (method.name(), material.shininess);
    println!(
        "{name:34} {method:7} n = {n:4}: largest {:.3}, rms {rms:.3} LSB, {} codes",
        errors.largest, errors.most_codes
    );
}

fn main() {
    for method in Method::ALL {
        for n in [1, 4, 16, 64, 256] {
            row("30 degrees, highlight alone", TYPICAL, method, &mirror(n), |_| ());
        }
        for n in [1, 16, 256, 1024, 4096] {
            row("90 degrees, highlight alone", EXTREME, method, &mirror(n), |_| ());
        }
        row("30 degrees, diffuse alone", TYPICAL, method, &material(0.0, 1.0, 0.0, 256), |_| ());
        let two = Range { lights: 2, ..TYPICAL };
        row("30 degrees, two lights, .1 .4 .5", two, method, &material(0.1, 0.4, 0.5, 256), |_| ());
        let four = Range { lights: 4, ..TYPICAL };
        row(
            "30 degrees, four lights, 0 .2 .5",
            four,
            method,
            &material(0.0, 0.2, 0.5, 256),
            |_| (),
        );
        row(
            "150 degrees, highlight alone",
            Range { widest: 150.0, ..EXTREME },
            method,
            &mirror(256),
            |_| (),
        );
    }
    row("90 degrees, highlight alone", EXTREME, Method::Lyon, &mirror(8191), |_| ());
    for n in [16, 64, 256] {
        row(
            "30 degrees, R - L, two steps",
            TYPICAL,
            Method::Lyon,
            &mirror(n),
            reflection_minus_light,
        );
    }
    for n in [256, 8191] {
        row(
            "90 degrees, R - L, two steps",
            EXTREME,
            Method::Lyon,
            &mirror(n),
            reflection_minus_light,
        );
    }
}

fn reflection_minus_light(core: &mut CoreSpec) {
    if let MethodSpec::Lyon(lyon) = &mut core.method {
        lyon.difference = Difference::ReflectionMinusLight;
        lyon.newton_steps = 2;
    }
}
