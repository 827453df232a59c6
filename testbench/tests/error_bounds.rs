//! On every built-in scene the measured quantisation error stays within what the core states, and
//! the statement says something.
use specula_scene::{Frame, Needs, load};
use specula_spec::{CoreSpec, Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

/// A bound is to exceed the measured error no more than so many times.
const SLACK: f64 = 4.0;

/// What docs/error-bounds.md says of a scene by a method: bound, measured error and ratio.
fn written(page: &str, scene: &str, method: &str) -> String {
    let row = format!("| `{scene}` | `{method}` |");
    let cells =
        |line: &str| line.trim_matches('|').split('|').skip(3).collect::<Vec<_>>().join("|");
    page.lines().find(|line| line.starts_with(&row)).map(cells).unwrap_or_default()
}

#[test]
fn measured_errors_stay_within_the_stated_bound() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/error-bounds.md");
    let page = std::fs::read_to_string(page).unwrap();
    for scene in specula_fixtures::still_scenes() {
        let loaded = load(scene, Some((120, 90))).unwrap();
        for method in Method::ALL {
            let spec = loaded.core_spec(Some(method)).unwrap();
            let bench = Bench::new(&loaded.frame, &spec, scene).unwrap();
            let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
            let (error, bound) =
                (outcome.comparison.errors.quantisation.max_lsb, bench.design.error_bound());
            println!("{scene} {}: {error} of {bound} LSB, {:.2}", method.name(), bound / error);
            assert_eq!(outcome.fault(), None);
            let now = format!(" {bound:.2} | {error:.2} | {:.1} ", bound / error);
            assert_eq!(written(&page, scene, method.name()), now, "{scene} {}", method.name());
            assert!(error <= bound, "{scene} {}: off by {error} LSB, bound {bound}", method.name());
            // Bounds of ways are propagated: docs/error-bounds.md says how wide they are.
            let is_propagated = spec.follows_ways() && method != Method::Phong;
            let [error, bound] =
                if is_propagated { of_the_middle(&loaded.frame, method) } else { [error, bound] };
            assert!(
                bound <= SLACK * error,
                "{scene} {}: a bound of {bound} LSB is {} times {error}",
                method.name(),
                bound / error
            );
        }
    }
}

/// The measured error and the bound of a core that sees places from the middle of each span.
fn of_the_middle(frame: &Frame, method: Method) -> [f64; 2] {
    let options = format!("[{}]\nplaces = \"span\"", method.name()).parse().unwrap();
    let general = CoreSpec::for_scene(&Needs::of(frame), Some(&options), Some(method)).unwrap();
    let spec = general.specialised(frame);
    let bench = Bench::new(frame, &spec, "middle").unwrap();
    let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None);
    let [error, bound] =
        [outcome.comparison.errors.quantisation.max_lsb, bench.design.error_bound()];
    assert!(error <= bound, "{}: off by {error} LSB, bound {bound}", method.name());
    [error, bound]
}
