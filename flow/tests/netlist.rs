//! Netlists of cores, simulated with the models of their cells.
use specula_datapath::{Builder, Design, Format, InputPort, SpanPacket};
use specula_fixtures::specs::spec;
use specula_fixtures::{few_spans, tools};
use specula_flow::synth::{Netlist, SynthTarget};
use specula_scene::Frame;
use specula_sim::{Columns, Engine, Flow, Icarus, RustHdl, Stimulus};
use specula_spec::{CoreSpec, Method, TargetClock};
use specula_testbench::{Bench, Outcome};

/// Whether Yosys and Icarus are there.
fn installed() -> bool {
    ["yosys", "iverilog"].into_iter().all(tools::is_installed)
}

/// A number with a sign or without, of so many bits.
fn format((bits, signed): (u32, bool)) -> Format {
    if signed { Format::signed(bits - 1, 0) } else { Format::unsigned(bits, 0) }
}

/// Operands of products for which a synthesiser takes blocks in different ways.
const OPERANDS: [[(u32, bool); 2]; 7] = [
    [(18, true), (18, true)],
    [(17, false), (18, true)],
    [(18, false), (18, true)],
    [(18, false), (18, false)],
    [(9, false), (9, false)],
    [(25, true), (12, false)],
    [(20, true), (20, true)],
];

fn products() -> Design {
    let builder = Builder::new("products", "a b");
    let control = builder.control();
    let product = |(number, formats): (usize, &[(u32, bool); 2])| {
        let [a, b] = [("a", formats[0]), ("b", formats[1])].map(|(name, operand)| {
            builder.input(&InputPort::whole(format!("{name}_{number}"), format(operand)))
        });
        (format!("product_{number}"), &a * &b)
    };
    let products: Vec<_> = OPERANDS.iter().enumerate().map(product).collect();
    let outputs: Vec<_> = products.iter().map(|(name, sig)| (name.as_str(), sig.clone())).collect();
    builder.finish(&control.valid, &outputs).unwrap()
}

/// Spans of one pixel with operands at random, and some at their ends.
fn operands(design: &Design) -> Vec<SpanPacket> {
    let mut random = fastrand::Rng::with_seed(1993);
    let ranges: Vec<_> =
        design.inputs.iter().flatten().map(|&input| design.node(input).range).collect();
    let mut packet = || {
        let value = |range: &specula_datapath::design::Range| match random.u8(..4) {
            0 => range.low,
            1 => range.high,
            _ => random.i64(range.low..=range.high),
        };
        SpanPacket { length: 1, inputs: ranges.iter().map(value).collect() }
    };
    (0..2000).map(|_| packet()).collect()
}

/// All that an engine gives of a design's outputs.
fn given(engine: &mut dyn Engine, design: &Design, stimulus: &Stimulus) -> Columns {
    let mut all = Columns::new(&design.outputs);
    let run = engine.run(stimulus, &design.outputs, &mut |batch| {
        all.extend(batch);
        Flow::Continue
    });
    run.unwrap();
    all
}

#[test]
fn blocks_that_yosys_takes_for_products_give_them() {
    if !installed() {
        return;
    }
    let design = products();
    let netlist = Netlist::of(&design, &SynthTarget::ECP5).unwrap();
    assert!(netlist.core.contains("MULT18X18D"), "{}", netlist.core);
    let packets = operands(&design);
    let stimulus = Stimulus::whole(&packets, &design);
    let expected = given(&mut RustHdl::new(&design).unwrap(), &design, &stimulus);
    let source = netlist.with_models().unwrap();
    let found = given(&mut Icarus::of_netlist(&design, &source).unwrap(), &design, &stimulus);
    let first = design.latency() as usize;
    for (expected, found) in expected.values.iter().zip(&found.values) {
        assert_eq!(expected[first..], found[first..]);
    }
}

/// The pixels of a netlist of `bench`'s core.
fn simulated(bench: &Bench, source: &str) -> Outcome {
    let mut engine = Icarus::of_netlist(&bench.design, source).unwrap();
    bench.run_ports(&mut engine, &mut |_, _| {}).unwrap()
}

/// A core for a few spans alone.
fn small_core(frame: &Frame) -> CoreSpec {
    spec(frame, Method::Gouraud).specialised(frame)
}

#[test]
fn netlists_with_blocks_give_the_same_pixels() {
    if !installed() {
        return;
    }
    let frame = few_spans::frame(14, 1, 12);
    let any_device = small_core(&frame);
    let target = TargetClock { name: "ecp5".to_owned(), clock_mhz: 200.0 };
    // Its colours are inputs, and products with constants need no block.
    let for_clock = CoreSpec { target: Some(target), ..spec(&frame, Method::Gouraud).general() };
    for (spec, has_registers) in [(any_device, false), (for_clock, true)] {
        let bench = Bench::new(&frame, &spec, "core").unwrap().with_bubbles(5);
        let netlist = Netlist::of(&bench.design, &SynthTarget::ECP5).unwrap();
        assert!(netlist.core.contains("MULT18X18D"), "{}", netlist.core);
        let inside = netlist.core.contains(".REG_PIPELINE_CLK(\"CLK0\")");
        assert_eq!(inside, has_registers, "{}", netlist.core);
        let outcome = simulated(&bench, &netlist.with_models().unwrap());
        assert_eq!((outcome.pixels, outcome.fault()), (frame.shaded_pixels(), None));
    }
}

#[test]
fn a_netlist_gives_the_same_pixels_and_most_with_a_wrong_cell_do_not() {
    if !installed() {
        return;
    }
    let frame = few_spans::frame(14, 1, 12);
    let spec = small_core(&frame);
    let bench = Bench::new(&frame, &spec, "core").unwrap().with_bubbles(6);
    let netlist = Netlist::of(&bench.design, &SynthTarget::ICE40_HX).unwrap();
    let source = netlist.with_models().unwrap();
    let outcome = simulated(&bench, &source);
    assert_eq!((outcome.pixels, outcome.fault()), (frame.shaded_pixels(), None));
    let is_noticed = |part: &usize| {
        let outcome = simulated(&bench, &with_inverted_table(&source, *part, 6));
        outcome.comparison.first_mismatch.is_some()
    };
    // Some tables are of low bits alone, which are rounded off.
    let noticed: Vec<usize> = (1..6).filter(is_noticed).collect();
    assert!(noticed.len() >= 3, "{noticed:?}");
}

/// The netlist with one look-up table inverted, before which `part` of `parts` of all stand.
fn with_inverted_table(source: &str, part: usize, parts: usize) -> String {
    const INIT: &str = ".LUT_INIT(16'h";
    let places: Vec<usize> = source.match_indices(INIT).map(|(at, _)| at + INIT.len()).collect();
    let at = places[places.len() * part / parts];
    let digits = &source[at..][..source[at..].find(')').unwrap()];
    let table = u16::from_str_radix(digits, 16).unwrap();
    [&source[..at], &format!("{:04x}", !table), &source[at + digits.len()..]].concat()
}
