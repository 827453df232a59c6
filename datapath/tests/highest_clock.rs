//! The highest clock that a target allows a graph.

use specula_datapath::graph::Graph;
use specula_datapath::pass::{ClockLimit, clock_limit, highest_clock};
use specula_datapath::target::{Fabric, Target};
use specula_datapath::{Builder, Format, InputPort};

/// Ten sums of 41 bits side by side.
fn sums() -> Graph {
    let builder = Builder::new("core", "x + k");
    let control = builder.control();
    let x = builder.input(&InputPort::whole("x", Format::unsigned(40, 0)));
    let sums: Vec<_> = (0..10i64).map(|k| &x + builder.integer((1 << 39) + 2 * k + 1)).collect();
    let names: Vec<String> = (0..10).map(|k| format!("sum_{k}")).collect();
    let outputs: Vec<_> = names.iter().zip(sums).map(|(name, sum)| (name.as_str(), sum)).collect();
    builder.graph(&control.valid, &outputs).expect("it can be built")
}

/// An ECP5 whose placement keeps so many carries short.
fn target(carries: Option<u32>) -> Target {
    let mut families = Target::families();
    let target = families.find(|target| target.name == "ecp5").expect("it is there");
    let fabric = target.fabric.map(|fabric| Fabric { carries, ..fabric });
    Target { fabric, ..target }
}

#[test]
fn sums_are_cut_as_often_as_placement_bears() {
    let graph = sums();
    let [all, enough, few] = [None, Some(1000), Some(5)].map(target);
    let fastest = highest_clock(&graph, &all);
    assert_eq!(highest_clock(&graph, &enough), fastest);
    assert!(matches!(
        clock_limit(&graph, &all, fastest),
        Some(ClockLimit::Path { in_loop: false, .. })
    ));
    // A sum of 41 bits is whole up to 1000/(1.40 + .85 + .62 + 41 · .0383) = 225 MHz.
    let slower = highest_clock(&graph, &few);
    assert_eq!(slower, 225.0);
    let limit = clock_limit(&graph, &few, slower);
    assert_eq!(limit, Some(ClockLimit::Carries { needed: 10, most: 5 }));
}
