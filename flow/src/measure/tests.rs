//! Reports of nextpnr, and one circuit that is measured.
use specula_fixtures::tools;

use super::circuit::{Operator, Pipeline, register};
use super::*;

/// A report with one path of 4 ns, of which .2 are set-up, and one of 2.5 ns; `delay` is how a delay
/// of so many ns is told.
fn report(delay: fn(f64) -> String) -> String {
    let net = |cell: &str, nanoseconds: f64| {
        format!(
            r#"{{"driver": "given_1_FF", "event": "posedge clk", "net": "n", "port": "Q",
                "endpoints": [{{"cell": "{cell}", "event": "posedge clk", "port": "D",
                "delay": {}}}, {{"cell": "pin", "event": "async", "port": "O", "delay": {}}}]}}"#,
            delay(nanoseconds),
            delay(9.0)
        )
    };
    format!(
        r#"{{"critical_paths": [{{"from": "posedge clk", "to": "posedge clk", "path": [
            {{"type": "clk-to-q", "delay": 0.5, "from": {{"cell": "f"}}, "to": {{"cell": "f"}}}},
            {{"type": "logic", "delay": 0.2, "from": {{"cell": "a"}}, "to": {{"cell": "a"}}}},
            {{"type": "logic", "delay": 0.4, "from": {{"cell": "b"}}, "to": {{"cell": "b"}}}},
            {{"type": "logic", "delay": 0.0, "from": {{"cell": "c"}}, "to": {{"cell": "c"}}}},
            {{"type": "routing", "delay": 2.7, "from": {{"cell": "c"}},
              "to": {{"cell": "stage_1_1_FF"}}}},
            {{"type": "setup", "delay": 0.2, "from": {{"cell": "stage_1_1_FF"}},
              "to": {{"cell": "stage_1_1_FF"}}}}]}}],
          "fmax": {{"clk": {{"achieved": 250.0}}}},
          "detailed_net_timings": [{}, {}]}}"#,
        net("stage_1_1_FF", 3.8),
        net("cell_stage_1_1", 2.5)
    )
}

#[test]
fn delays_are_read_as_old_and_new_versions_tell_them() {
    for delay in [|ns: f64| format!("{ns}"), |ns: f64| format!("[{}, {ns}]", ns / 2.0)] {
        let arrivals = Arrivals::read(&report(delay)).expect("it is a report");
        assert_eq!(arrivals.slowest(|_, _| true), Some(4.0), "what leads to a pin does not count");
        assert_eq!(arrivals.slowest(|_, end| end.starts_with(CELL)), Some(2.5));
        assert_eq!(arrivals.slowest(|driver, _| driver.starts_with(CELL)), None);
        assert!((arrivals.logic.expect("it has cells") - 0.3).abs() < 1e-9);
    }
}

#[test]
fn a_report_whose_paths_contradict_its_clock_is_refused() {
    let text = report(|ns| format!("{ns}")).replace("250.0", "200.0");
    let error = Arrivals::read(&text).err().expect("it is none");
    assert!(error.contains("4 ns") && error.contains("5 ns"), "{error}");
    assert!(Arrivals::read(r#"{"fmax": {}, "critical_paths": []}"#).is_err());
}

#[test]
fn a_small_sum_is_measured() {
    if !["yosys", "nextpnr-ice40"].into_iter().all(tools::is_installed) {
        return;
    }
    let laboratory = Laboratory::new(&SynthTarget::ICE40_HX, 1).expect("they are installed");
    let pipeline = Pipeline { width: 8, lanes: 4, stages: 2 };
    let circuit = pipeline.text(|name, [a, b, ..]| register(name, 8, &format!("{a} + {b}")));
    let routed = laboratory.route(&circuit).expect("it fits");
    let slowest = routed[0].slowest(|_, cell| cell.starts_with(STAGE)).expect("it has sums");
    // A flip-flop, a net, a carry chain of 8 bits of .13 ns each.
    assert!((1.5..8.0).contains(&slowest), "{slowest} ns");
    let logic = routed[0].logic.expect("it has cells");
    assert!((0.05..1.5).contains(&logic), "{logic} ns");
}

#[test]
fn a_table_has_what_was_measured() {
    let way = |clocks, into, out| Way { clocks, into, out };
    let delays = Delays {
        programs: ["Yosys".to_owned(), "nextpnr".to_owned()],
        register: 1.5,
        net: 0.5,
        lut: 0.25,
        carry: 0.75,
        carry_bit: 0.0351,
        multiplier: vec![way(0, 8.0, 0.0), way(3, 2.25, 2.75)],
        memory: vec![way(2, 2.5, 3.0)],
        delay_line: Some(3.5),
    };
    let expected = "\
[fabric]
register = 1.50
lut = 0.25
net = 0.50
carry = 0.75
carry_bit = 0.0351

[[multiplier.pipeline]]
clocks = 0
into = 6.00
out = 0.00

[[multiplier.pipeline]]
clocks = 3
into = 0.25
out = 2.75

[[table.pipeline]]
clocks = 2
into = 0.50
out = 3.00

[delay_line]
read = 3.50
";
    assert_eq!(text(&delays), expected);
}

#[test]
fn operators_fill_a_circuit() {
    for operator in [Operator::Gates(4), Operator::Sum(8), Operator::Sum(48)] {
        let text = operator.circuit();
        let stages = text.lines().filter(|line| line.starts_with("  reg") && line.contains(STAGE));
        assert!(stages.count() >= 16, "{operator:?}");
    }
}
