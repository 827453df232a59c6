//! Prints the table of docs/formats.md: every method on the built-in scenes, in its default formats
//! and in the cheapest that are found for which it is faithful.
use std::time::{Duration, Instant};

use specula_experiments::cost::{Cost, GENERIC_BLOCK};
use specula_experiments::formats::{FAITHFUL, Products, Wanted, cheapest_formats};
use specula_scene::{LoadedScene, builtin_names, load};
use specula_spec::{CoreSpec, Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "| scene | method | blocks | adder bits | register bits | bound | measured | cells | tried | ms | processor ms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let is_asked = |name: &&&str| asked.is_empty() || asked.iter().any(|asked| asked == **name);
    for name in builtin_names().iter().filter(is_asked) {
        let scene = load(name, None)?;
        for method in Method::ALL {
            if let Ok(start) = scene.core_spec(Some(method)) {
                println!("{}", row(&scene, &start)?);
            }
        }
    }
    Ok(())
}

fn row(scene: &LoadedScene, start: &CoreSpec) -> Result<String, Box<dyn std::error::Error>> {
    let wanted = Wanted { below: FAITHFUL, products: Products::Blocks(GENERIC_BLOCK), kept: &[] };
    let (begin, clock) = (processor_time(), Instant::now());
    let found = cheapest_formats(start, &scene.frame, &wanted)??;
    let wall = clock.elapsed().as_millis();
    let taken = processor_time().saturating_sub(begin).as_millis();
    let [before, after] = [start, &found.spec].map(|spec| figures(scene, spec));
    let (before, after) = (before?, after?);
    let cells: Vec<String> =
        before.iter().zip(&after).map(|(before, after)| format!("{before} → {after}")).collect();
    let (scene, method, tried) = (&scene.name, start.method().name(), found.tried);
    Ok(format!("| {scene} | {method} | {} | {tried} | {wall} | {taken} |", cells.join(" | ")))
}

/// Blocks, bits of adders and registers, proven bound and largest error measured in the scene.
fn figures(
    scene: &LoadedScene,
    spec: &CoreSpec,
) -> Result<[String; 6], Box<dyn std::error::Error>> {
    let bench = Bench::new(&scene.frame, spec, "core")?;
    let outcome = bench.run(EngineKind::Fast, &mut |_, _| ())?;
    let error = outcome.comparison.errors.quantisation.max_lsb;
    let cost = Cost::of(&bench.design, Some(GENERIC_BLOCK));
    Ok([
        cost.blocks.unwrap_or(0).to_string(),
        cost.adder_bits.to_string(),
        cost.register_bits.to_string(),
        format!("{:.3}", outcome.bound_lsb),
        format!("{error:.3}"),
        cost.cells().to_string(),
    ])
}

/// Time that all processors together spent on this program, where the system tells it.
#[cfg(unix)]
fn processor_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    // A processor's time is not negative, and nanoseconds are below 10^9.
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}

#[cfg(not(unix))]
fn processor_time() -> Duration {
    Duration::ZERO
}
