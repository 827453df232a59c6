//! Waveforms are read back, and are what was written.
mod common;

use std::collections::HashMap;

use specula_hdl::Design;
use specula_hdl::design::{NodeId, Op};
use specula_scene::Method;
use specula_sim::{Columns, RustHdl, Stimulus, gtkw, vcd::Waves};
use vcd::{Command, Header, IdCode, Parser, Value};

use common::{engines, frames};

/// A core and every signal of it over a window.
fn window(method: Method) -> (Design, Columns) {
    let frame = frames::frame(3, 1, 20);
    let spec = frames::spec(&frame, method);
    let design = frames::design(&spec);
    let packets = frames::packets(&spec, &frame);
    let all: Vec<NodeId> = design.iter().filter(|(_, node)| !matches!(node.op, Op::Constant(_))).map(|(id, _)| id).collect();
    let stimulus = Stimulus::whole(&packets, &design).leading_to(&(90..100), &design);
    let columns = engines::run(&mut RustHdl::new(&design).unwrap(), &stimulus, &all).unwrap();
    assert!(columns.first_clock > 0);
    (design, columns)
}

/// The columns, written in two pieces.
fn written(design: &Design, columns: &Columns) -> Vec<u8> {
    let half = columns.clocks() / 2;
    let piece = |rows: std::ops::Range<usize>| Columns {
        first_clock: columns.first_clock + rows.start as u64,
        nodes: columns.nodes.clone(),
        values: columns.values.iter().map(|column| column[rows.clone()].to_vec()).collect(),
    };
    let mut file = vec![];
    let mut waves = Waves::begin(&mut file, design, &columns.nodes, "a scene for $1").unwrap();
    waves.append(&piece(0..half).batch()).unwrap();
    waves.append(&piece(half..columns.clocks()).batch()).unwrap();
    waves.end().unwrap();
    file
}

fn variable(header: &Header, design: &Design, node: NodeId) -> IdCode {
    let name = design.full_name(node);
    let path: Vec<&str> = name.split('.').collect();
    let variable = header.find_var(&path).unwrap_or_else(|| panic!("{name} is missing"));
    assert_eq!(variable.size, design.node(node).width(), "{name}");
    variable.code
}

fn reads_back(method: Method) {
    let (design, columns) = window(method);
    let file = written(&design, &columns);
    let mut parser = Parser::new(file.as_slice());
    let header = parser.parse_header().unwrap();
    assert_eq!(header.timescale, Some((1, vcd::TimescaleUnit::NS)));
    let codes: Vec<IdCode> = columns.nodes.iter().map(|&node| variable(&header, &design, node)).collect();
    let core = design.path(specula_hdl::design::ScopeId::TOP)[0];
    let clock = header.find_var(&[core, "clock"]).unwrap().code;
    let reset = header.find_var(&[core, "reset"]).unwrap().code;

    let mut bits: HashMap<IdCode, Vec<Value>> = HashMap::new();
    let (mut time, mut rows) = (0, 0);
    for command in parser {
        match command.unwrap() {
            Command::Timestamp(next) => {
                assert!(next > time);
                time = next;
            }
            Command::ChangeScalar(code, value) => {
                assert_ne!(bits.insert(code, vec![value]), Some(vec![value]), "written without a change");
                if code == clock && value == Value::V0 {
                    // The clock falls when everything of this clock has been written.
                    assert_eq!(time, 10 * (columns.first_clock + rows as u64) + 5);
                    assert_eq!(bits[&reset], [Value::V0]);
                    let got: Vec<i64> =
                        codes.iter().zip(&columns.nodes).map(|(code, &n)| number(&bits[code], &design, n)).collect();
                    let wanted: Vec<i64> = columns.values.iter().map(|column| column[rows]).collect();
                    assert_eq!(got, wanted);
                    rows += 1;
                }
            }
            Command::ChangeVector(code, value) => {
                assert_eq!(time % 10, 0);
                assert_ne!(bits.insert(code, value.clone()), Some(value), "written without a change");
            }
            _ => {}
        }
    }
    assert_eq!((rows, time), (columns.clocks(), 10 * columns.span().end));
}

fn number(bits: &[Value], design: &Design, node: NodeId) -> i64 {
    let raw = bits.iter().fold(0, |raw, &bit| {
        assert!(matches!(bit, Value::V0 | Value::V1));
        raw * 2 + i64::from(bit == Value::V1)
    });
    let negative = design.node(node).range.signed() && bits[0] == Value::V1;
    if negative { raw - (1 << bits.len()) } else { raw }
}

#[test]
fn lyons_waveform_reads_back() {
    reads_back(Method::Lyon);
}

#[test]
fn the_hybrids_waveform_reads_back() {
    reads_back(Method::Hybrid);
}

#[test]
fn the_save_file_names_signals_of_the_waveform() {
    let (design, columns) = window(Method::Lyon);
    let shown = gtkw::interesting(&design);
    let mut file = vec![];
    let view = gtkw::View { dump_file: "lyon.vcd", window: columns.span(), marker: Some(95) };
    gtkw::write(&mut file, &design, &shown, &view).unwrap();
    let text = String::from_utf8(file).unwrap();
    let waveform = written(&design, &columns);
    let header = Parser::new(waveform.as_slice()).parse_header().unwrap();
    let names = text.lines().filter(|line| line.starts_with("lyon."));
    let mut count = 0;
    for name in names {
        let path: Vec<&str> = name.split('[').next().unwrap().split('.').collect();
        assert!(header.find_var(&path).is_some(), "{name} is not in the waveform");
        assert!(!name.contains("product_"), "{name} has no name of its own");
        count += 1;
    }
    // The clock and reset beside what was asked for, each once.
    assert_eq!(count, shown.len() + 2);
    assert!(text.contains("[dumpfile] \"lyon.vcd\"") && text.contains(" 950 -1"));
}
