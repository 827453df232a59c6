//! The search for broken bounds, small: some hundred scenes by each method.
use rayon::ThreadPoolBuilder;
use specula_experiments::climb::{MethodReport, Peak, Search, climb};
use specula_scene::{load, parse};
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

/// Scenes that are tried by each method.
const SCENES: u64 = 300;

fn complaint(report: &MethodReport) -> impl Iterator<Item = String> + '_ {
    report.wrong.iter().map(|peak: &Peak| {
        let (measured, bound) = (peak.quantisation_lsb, peak.bound_lsb);
        let what =
            peak.fault.clone().unwrap_or_else(|| format!("off by {measured} LSB, bound {bound}"));
        format!("{}: {what}\n{}", report.method, peak.scene)
    })
}

#[test]
fn no_bound_is_broken() {
    let methods = Method::ALL.to_vec();
    let search = Search { seed: 1, scenes: SCENES * methods.len() as u64, methods };
    let reports = climb(&search, &|| ());
    let complaints: Vec<String> = reports.iter().flat_map(complaint).collect();
    assert!(complaints.is_empty(), "seed {}\n{}", search.seed, complaints.join("\n"));
    for (report, method) in reports.iter().zip(Method::ALL) {
        let largest = report.largest.as_ref().expect("some core has a bound");
        println!("{}: {:.4}, {} refused", report.method, largest.ratio, report.refused);
        assert!(report.scenes == SCENES && report.refused + report.without_bound < SCENES / 2);
        // A search that measures nothing, or climbs nowhere, does not come near.
        assert!(
            largest.ratio > 0.9 && largest.ratio <= 1.0,
            "{}: {}",
            report.method,
            largest.ratio
        );
        let loaded = parse("highest.toml", largest.scene.clone()).expect("it is a scene file");
        assert_eq!(loaded.core_spec(None).expect("it has its core").method(), method);
    }
}

/// Scenes that the search found to be wrong once.
#[test]
fn what_was_found_is_mended() {
    for scene in [
        "root-of-a-constant",
        "short-of-the-reach",
        "direction-lost-in-rounding",
        "normal-that-may-be-anywhere",
    ] {
        let file = format!("{}/tests/climbed/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
        let loaded = load(&file, None).unwrap();
        let spec = loaded.core_spec(None).unwrap();
        let bench = Bench::new(&loaded.frame, &spec, "core").unwrap();
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        let (error, bound) =
            (outcome.comparison.errors.quantisation.max_lsb, bench.design.error_bound());
        assert_eq!(outcome.fault(), None, "{scene}");
        assert!(error <= bound, "{scene}: off by {error} LSB, bound {bound}");
    }
}

#[test]
fn what_is_found_depends_on_the_seed_and_on_no_thread() {
    let of = |seed: u64, threads: usize| {
        let search = Search { seed, scenes: 1100, methods: vec![Method::Gouraud] };
        let pool =
            ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be had");
        pool.install(|| climb(&search, &|| ()))
    };
    let one = of(7, 1);
    assert_eq!(one, of(7, 3));
    assert_ne!(one, of(8, 1));
}
