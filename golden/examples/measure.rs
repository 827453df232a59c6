//! Quantisation errors of 50 000 spans a row, for the documentation:
//! `cargo run -p specula-golden --release --example measure`.
use specula_fixtures::Draw;
use specula_fixtures::frames::{material, mirror};
use specula_fixtures::highlights::{Drawn, SpanRange, choices, draw_frame};
use specula_fixtures::specs::{packet, spec};
use specula_golden::exact::MethodSpan;
use specula_golden::fixed::{Model, Observation};
use specula_scene::Material;
use specula_spec::lyon::Difference;
use specula_spec::{CoreSpec, Method, MethodSpec};

const TYPICAL: SpanRange = SpanRange { widest: 30.0, tilt: 70.0, log2_length: 12.0, lights: 1 };
const EXTREME: SpanRange = SpanRange { widest: 90.0, tilt: 45.0, ..TYPICAL };

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
    /// Adds the errors of the first and the last pixel and of the highlight's pixel.
    fn add(&mut self, core: &CoreSpec, drawn: &Drawn) {
        let span = &drawn.frame.spans[0];
        let (model, packet) = (Model::new(core), packet(core, &drawn.frame));
        let method = MethodSpan::new(core, &drawn.frame, span);
        for i in [0, drawn.highlight, span.steps()] {
            let trace = model.trace(&packet, i).expect("the packet is this core's");
            let value = |name| {
                Observation::named(&trace, name).expect("every method has the value").value()
            };
            let exact = method.pixel(i)[0];
            let error = value("colour_r").min(255.0) - exact;
            self.pixels += 1;
            self.largest = self.largest.max(error.abs());
            self.squares += error * error;
            self.most_codes = self.most_codes.max((value("code_r") - exact.round()).abs());
        }
    }
}

fn row(
    name: &str,
    range: SpanRange,
    method: Method,
    material: &Material,
    change: impl Fn(&mut CoreSpec),
) {
    let mut errors = Errors::default();
    let mut draw = Draw::new(1);
    for _ in 0..50_000 {
        let drawn = draw_frame(range, &choices(&mut draw), material.clone());
        let mut core = spec(&drawn.frame, method);
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
        let two = SpanRange { lights: 2, ..TYPICAL };
        row("30 degrees, two lights, .1 .4 .5", two, method, &material(0.1, 0.4, 0.5, 256), |_| ());
        let four = SpanRange { lights: 4, ..TYPICAL };
        row(
            "30 degrees, four lights, 0 .2 .5",
            four,
            method,
            &material(0.0, 0.2, 0.5, 256),
            |_| (),
        );
        row(
            "150 degrees, highlight alone",
            SpanRange { widest: 150.0, ..EXTREME },
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
