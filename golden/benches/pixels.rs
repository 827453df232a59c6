//! Time per pixel of every way to shade: `cargo bench -p specula-golden`.
use std::hint::black_box;
use std::time::Instant;

use specula_fixtures::frames::{frame, material, tilted};
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_golden::fixed::Model;
use specula_scene::{Frame, Needs};
use specula_spec::{CoreSpec, Method};

const LENGTH: u32 = 64;
const ROUNDS: u32 = 5000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let frame = frame(
        [tilted(-10.0), tilted(15.0)],
        LENGTH,
        &[tilted(20.0), tilted(-40.0)],
        material(0.1, 0.4, 0.5, 64),
    );
    let span = &frame.spans[0];
    time("exact::phong", || {
        let shaded = PhongSpan::new(&frame, span);
        sum((0..LENGTH).map(|i| shaded.pixel(i)))
    });
    for method in Method::ALL {
        let spec = CoreSpec::for_scene(&Needs::of(&frame), None, Some(method))?;
        time(&format!("exact::method {}", method.name()), || {
            let shaded = MethodSpan::new(&spec, &frame, span);
            sum((0..LENGTH).map(|i| shaded.pixel(i)))
        });
        time_fixed(&frame, &spec)?;
    }
    Ok(())
}

fn time_fixed(frame: &Frame, spec: &CoreSpec) -> Result<(), Box<dyn std::error::Error>> {
    let (model, packet) = (Model::new(spec), spec.packet(frame, &frame.spans[0]));
    let mut codes = Vec::new();
    model.shade(&packet, &mut codes)?;
    time(&format!("fixed::Model {}", spec.method().name()), || {
        codes.clear();
        // The packet was accepted above.
        let _ = model.shade(black_box(&packet), &mut codes);
        f64::from(codes[0][0])
    });
    Ok(())
}

fn sum(pixels: impl Iterator<Item = [f64; 3]>) -> f64 {
    pixels.map(|p| p[0] + p[1] + p[2]).sum()
}

fn time(name: &str, mut shade_span: impl FnMut() -> f64) {
    let start = Instant::now();
    for _ in 0..ROUNDS {
        black_box(shade_span());
    }
    let nanoseconds = start.elapsed().as_secs_f64() * 1e9 / f64::from(ROUNDS * LENGTH);
    println!("{name:24} {nanoseconds:7.1} ns a pixel (two lights, spans of {LENGTH})");
}
