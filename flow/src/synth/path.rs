//! The critical path in the names of the design.
use std::collections::HashSet;

use serde::{Deserialize, Serialize};
use specula_datapath::Design;
use specula_datapath::design::ScopeId;

use super::harness;

/// The longest path from flip-flop to flip-flop.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CriticalPath {
    /// Its delay, in nanoseconds.
    pub nanoseconds: f64,
    /// The signals that it goes through, each with what computes it.
    pub steps: Vec<Step>,
}

/// The part of a path that belongs to a signal.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Step {
    /// Name of the signal with the units around it, as the Verilog has it.
    pub signal: String,
    /// The cells that compute it, each kind once, such as `MULT18X18D` or `CCU2C`.
    pub cells: Vec<String>,
    /// Delay of those cells, in nanoseconds.
    pub logic: f64,
    /// Delay of the wires between them and of those that lead on, in nanoseconds.
    pub routing: f64,
}

/// A path as nextpnr's report has it.
#[derive(Deserialize)]
pub struct ReportedPath {
    from: String,
    to: String,
    path: Vec<Segment>,
}

/// A cell, or a wire between two.
#[derive(Deserialize)]
struct Segment {
    delay: f64,
    from: End,
    #[serde(default)]
    to: Option<End>,
    #[serde(rename = "type")]
    kind: String,
}

#[derive(Deserialize)]
struct End {
    cell: String,
}

impl ReportedPath {
    /// Whether it begins and ends with a clock, and not at a pin.
    pub fn is_clocked(&self) -> bool {
        [&self.from, &self.to].iter().all(|end| end.contains("edge "))
    }

    /// Its delay, set-up included, in nanoseconds.
    pub fn nanoseconds(&self) -> f64 {
        self.path.iter().map(|segment| segment.delay).sum()
    }

    /// The cells that its last net comes from and leads to.
    pub fn last_net(&self) -> Option<[&str; 2]> {
        let is_net = |segment: &&Segment| segment.kind == "routing";
        let net = self.path.iter().rev().find(is_net)?;
        Some([&net.from.cell, &net.to.as_ref()?.cell])
    }

    /// Mean delay of the cells between its flip-flops, carries that take no time left out, in
    /// nanoseconds.
    pub fn mean_logic(&self) -> Option<f64> {
        let is_logic = |segment: &&Segment| segment.kind == "logic" && segment.delay > 0.0;
        let delays: Vec<f64> = self.path.iter().filter(is_logic).map(|part| part.delay).collect();
        (!delays.is_empty()).then(|| delays.iter().sum::<f64>() / delays.len() as f64)
    }

    /// The path in the names of `design`. A wire counts with the signal that drives it.
    pub fn named(&self, design: &Design) -> CriticalPath {
        let names = Names::of(design);
        let mut steps: Vec<Step> = vec![];
        for segment in &self.path {
            let (signal, kind) = names.of_cell(&segment.from.cell);
            if steps.last().is_none_or(|step| step.signal != signal) {
                steps.push(Step { signal, cells: vec![], logic: 0.0, routing: 0.0 });
            }
            // A step was put in if there was none.
            let Some(step) = steps.last_mut() else { continue };
            match segment.kind.as_str() {
                "routing" => step.routing += segment.delay,
                _ => step.logic += segment.delay,
            }
            if !step.cells.contains(&kind) {
                step.cells.push(kind);
            }
        }
        CriticalPath { nanoseconds: self.nanoseconds(), steps }
    }
}

/// Names of the signals of a design, as cells' names begin.
struct Names {
    top: String,
    signals: HashSet<String>,
}

impl Names {
    fn of(design: &Design) -> Names {
        let top = design.scope(ScopeId::TOP).instance.clone();
        let signals = design.iter().map(|(id, _)| design.full_name(id)).collect();
        Names { top, signals }
    }

    /// The signal that a cell is of, and the cell's kind.
    ///
    /// Yosys calls a cell after the signal that it drives, the kind of cell behind it, and port and
    /// number: `core.normalise.product_MULT18X18D_B0`. The longest beginning that is a signal of
    /// the design's is that signal; what is the harness's keeps its name.
    fn of_cell(&self, cell: &str) -> (String, String) {
        let Some(inside) = cell.strip_prefix(harness::INSTANCE).and_then(|c| c.strip_prefix('.'))
        else {
            return ("harness".to_owned(), kind(cell));
        };
        let ends = inside.char_indices().filter(|(_, c)| *c == '_').map(|(place, _)| place);
        let mut beginnings: Vec<&str> = ends.map(|end| &inside[..end]).collect();
        beginnings.push(inside);
        let known = |name: &&&str| self.signals.contains(&format!("{}.{name}", self.top));
        match beginnings.iter().rev().find(known) {
            Some(signal) => ((*signal).to_owned(), kind(&inside[signal.len()..])),
            None => (inside.to_owned(), kind(inside)),
        }
    }
}

/// The kind of a cell, which its name has last: the kinds before are those of its neighbours, by
/// which Yosys calls a cell that drives no signal of the design's.
fn kind(rest: &str) -> String {
    const KINDS: [&str; 12] = [
        "MULT18X18D",
        "CCU2C",
        "LUT4",
        "PFUMX",
        "L6MUX21",
        "TRELLIS_FF",
        "DP16KD",
        "SB_MAC16",
        "SB_CARRY",
        "SB_LUT4",
        "SB_DFF",
        "SB_RAM40",
    ];
    let end = |kind: &&str| Some((rest.rfind(kind)? + kind.len(), kind.len()));
    let last = KINDS.into_iter().max_by_key(end).filter(|kind| rest.contains(kind));
    last.unwrap_or("cell").to_owned()
}

#[cfg(test)]
pub(super) mod tests {

    use specula_datapath::{Builder, Format, InputPort};

    use super::*;

    /// c = a b + a.
    pub fn sum_and_product() -> Design {
        let builder = Builder::new("demo", "c = a b + a");
        let control = builder.control();
        let byte = Format::unsigned(8, 0);
        let [a, b] = ["a", "b"].map(|name| builder.input(&InputPort::whole(name, byte)));
        let product = (&a * &b).named("product");
        let sum = (product + a).named("sum");
        builder.finish(&control.valid, &[("c", sum)]).expect("it is a design")
    }

    #[test]
    fn cells_are_told_by_the_signals_that_they_drive() {
        let names = Names::of(&sum_and_product());
        for (cell, signal, kind) in [
            ("core.product_MULT18X18D_B0", "product", "MULT18X18D"),
            ("core.product_MULT18X18D_B0_P18_CCU2C_B0$CCU2_COMB1", "product", "CCU2C"),
            ("core.sum_CCU2C_S0_3$CCU2_COMB0", "sum", "CCU2C"),
            ("core.a_d1_TRELLIS_FF_Q_2", "a_d1", "TRELLIS_FF"),
            ("core.sum_SB_DFF_Q_D_SB_LUT4_O_LC", "sum", "SB_LUT4"),
            ("taken_TRELLIS_FF_Q", "harness", "TRELLIS_FF"),
            ("core.elsewhere", "elsewhere", "cell"),
        ] {
            assert_eq!(names.of_cell(cell), (signal.to_owned(), kind.to_owned()), "{cell}");
        }
    }

    #[test]
    fn a_path_is_told_signal_by_signal() {
        let text = r#"{"from": "posedge clk", "to": "posedge clk", "path": [
            {"delay": 0.5, "type": "clk-to-q", "from": {"cell": "core.a_d1_TRELLIS_FF_Q"}},
            {"delay": 1.5, "type": "routing", "from": {"cell": "core.a_d1_TRELLIS_FF_Q"}},
            {"delay": 0.25, "type": "logic", "from": {"cell": "core.sum_CCU2C_S0"}},
            {"delay": 0.0, "type": "routing", "from": {"cell": "core.sum_CCU2C_S0_1"}},
            {"delay": 0.25, "type": "setup", "from": {"cell": "core.sum_TRELLIS_FF_Q"}}]}"#;
        let path: ReportedPath = serde_json::from_str(text).expect("it is a path");
        assert!(path.is_clocked());
        let step = |signal: &str, cells: &[&str], logic, routing| Step {
            signal: signal.to_owned(),
            cells: cells.iter().map(|cell| (*cell).to_owned()).collect(),
            logic,
            routing,
        };
        let expected = CriticalPath {
            nanoseconds: 2.5,
            steps: vec![
                step("a_d1", &["TRELLIS_FF"], 0.5, 1.5),
                step("sum", &["CCU2C", "TRELLIS_FF"], 0.5, 0.0),
            ],
        };
        assert_eq!(path.named(&sum_and_product()), expected);
    }
}
