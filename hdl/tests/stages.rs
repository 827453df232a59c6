//! Cores clock by clock: nothing is lost, and nothing is there twice.
use specula_datapath::block::Module;
use specula_datapath::design::{Design, NodeId};
use specula_datapath::stages::{Carried, Stage};
use specula_datapath::timing::Timing;
use specula_datapath::verilog::Counted;
use specula_spec::{CoreSpec, Method, SceneCore, TargetClock};

/// Cores of all methods, for any device and for two clocks of a target.
fn cores() -> Vec<(CoreSpec, Design)> {
    let scene = specula_scene::load("teapot", Some((48, 36))).expect("it is built in");
    let clock = |clock_mhz| TargetClock { name: "ecp5".to_owned(), clock_mhz };
    let targets = [None, Some(clock(80.0)), Some(clock(240.0))];
    let made = |method: Method| {
        let spec = scene.core_spec(Some(method)).expect("every method shades the teapot");
        targets.clone().map(|target| {
            let spec = CoreSpec { target, ..spec.clone() };
            let design = specula_hdl::elaborate(&spec, "core").expect("no signal is too wide");
            (spec, design)
        })
    };
    Method::ALL.into_iter().flat_map(made).collect()
}

fn carried(stages: &[Stage]) -> Carried {
    stages.iter().map(|stage| stage.carried).fold(Carried::default(), Carried::plus)
}

#[test]
fn register_bits_of_all_clocks_are_those_of_the_core() {
    let (mut with_blocks, mut with_memories) = (0, 0);
    for (spec, design) in cores() {
        let stages = design.stages();
        let about = format!("{} for {:?}", spec.method().name(), spec.target);
        assert_eq!(stages.len(), design.depth() as usize + 1, "{about}");
        let bits = carried(&stages);
        assert_eq!(bits.total(), design.size().register_bits, "{about}");
        with_blocks += u32::from(bits.in_blocks > 0);
        with_memories += u32::from(bits.in_memories > 0);
        let registers = design.iter().filter(|(_, node)| node.registered()).map(|(id, _)| id);
        let mut ends: Vec<NodeId> = stages.into_iter().flat_map(|stage| stage.ends).collect();
        ends.retain(|&id| design.node(id).registered());
        ends.sort();
        assert!(registers.eq(ends), "{about}");
    }
    assert!(with_blocks >= 5 && with_memories >= 5, "{with_blocks} {with_memories}");
}

#[test]
fn flip_flops_are_those_of_the_printed_core() {
    for (spec, design) in cores().into_iter().filter(|(spec, _)| spec.target.is_some()) {
        let bits = carried(&design.stages());
        let module: Module = design.to_block();
        let printed = Counted::of(&module).flip_flops;
        // Memories have counters, one for each of some tens of lengths, of at most 7 bits; they are no
        // registers of the design.
        let counters = printed.checked_sub(bits.flip_flops);
        let about = format!("{}: {printed} printed, {bits:?}", spec.method().name());
        assert!(counters.is_some_and(|bits| bits < 256), "{about}");
        assert!(bits.in_memories > 0 || counters == Some(0), "{about}");
    }
}

#[test]
fn every_operator_is_in_its_clocks() {
    for (spec, design) in cores() {
        let stages = design.stages();
        let mut computed: Vec<NodeId> =
            stages.iter().flat_map(|stage| &stage.operators).map(|of| of.node).collect();
        let mut expected: Vec<NodeId> =
            design.iter().map(|(id, _)| id).filter(|&id| is_operator(&design, id)).collect();
        for block in &design.multipliers {
            expected.extend((1..block.registers.max(1)).map(|_| block.product));
        }
        computed.sort();
        expected.sort();
        assert_eq!(computed, expected, "{}", spec.method().name());
    }
}

/// Whether a signal is computed, by something that is not inside a block.
fn is_operator(design: &Design, id: NodeId) -> bool {
    let inside = |block: &specula_datapath::design::MultiplierBlock| {
        block.product != id && block.inside().any(|inside| inside == id)
    };
    design.operator_kind(id).is_some() && !design.multipliers.iter().any(inside)
}

#[test]
fn the_slowest_path_of_all_clocks_is_that_of_the_core() {
    for (spec, design) in cores() {
        let Some(target) = spec.target.as_ref().and_then(|clock| clock.target().ok()) else {
            continue;
        };
        let timing = Timing::of(&design, &target).expect("its delays are known");
        let ends = design.stages().into_iter().flat_map(|stage| stage.ends);
        let slowest = ends.map(|id| timing.arrival(id)).fold(0.0, f64::max);
        assert_eq!(slowest, timing.period, "{}", spec.method().name());
        let last = *timing.path.last().expect("a core has registers");
        assert_eq!(timing.path_to(&design, last), timing.path);
        assert_eq!(timing.arrival(last), timing.period);
    }
}
