//! Waveforms are read back, and are what was written.
use std::collections::{HashMap, HashSet};

use specula_datapath::Design;
use specula_datapath::design::{NodeId, Op, Range};
use specula_fixtures::few_spans;
use specula_fixtures::specs::{packets, spec};
use specula_sim::{Columns, Fast, Stimulus, fst, gtkw, vcd as dump_vcd};
use specula_spec::Method;
use vcd::{Command, Header, IdCode, Parser, Value};

use crate::agreement;
use crate::dump::{Format, read, written};
use crate::elaborated;
use crate::program::{Operation, Place, Program, port};

/// A core and every signal of it over a window that begins late.
fn window(method: Method) -> (Design, Columns) {
    let frame = few_spans::frame(3, 1, 60);
    let spec = spec(&frame, method);
    let design = elaborated(&spec);
    let packets = packets(&spec, &frame);
    let all: Vec<NodeId> = design.variables();
    let stimulus = Stimulus::whole(&packets, &design).leading_to(&(240..250), &design);
    let columns = agreement::run(&mut Fast::new(&design), &stimulus, &all).unwrap();
    assert!(columns.first_clock > 0);
    (design, columns)
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
    let file = written(Format::Vcd, &design, &columns, 37);
    let mut parser = Parser::new(file.as_slice());
    let header = parser.parse_header().unwrap();
    assert_eq!(header.timescale, Some((1, vcd::TimescaleUnit::NS)));
    let codes: Vec<IdCode> =
        columns.nodes.iter().map(|&node| variable(&header, &design, node)).collect();
    let core = design.path(specula_datapath::design::ScopeId::TOP)[0];
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
                assert_ne!(
                    bits.insert(code, vec![value]),
                    Some(vec![value]),
                    "written without a change"
                );
                if code == clock && value == Value::V0 {
                    // The clock falls when everything of this clock has been written.
                    assert_eq!(time, 10 * (columns.first_clock + rows as u64) + 5);
                    assert_eq!(bits[&reset], [Value::V0]);
                    let got: Vec<i64> = codes
                        .iter()
                        .zip(&columns.nodes)
                        .map(|(code, &n)| number(&bits[code], &design, n))
                        .collect();
                    let wanted: Vec<i64> =
                        columns.values.iter().map(|column| column[rows]).collect();
                    assert_eq!(got, wanted);
                    rows += 1;
                }
            }
            Command::ChangeVector(code, value) => {
                assert_eq!(time % 10, 0);
                assert_ne!(
                    bits.insert(code, value.clone()),
                    Some(value),
                    "written without a change"
                );
            }
            _ => {}
        }
    }
    assert_eq!((rows, time), (columns.clocks(), 10 * columns.span().end));
}

/// Bits that are left out are 0.
fn number(bits: &[Value], design: &Design, node: NodeId) -> i64 {
    let raw = bits.iter().fold(0, |raw, &bit| {
        assert!(matches!(bit, Value::V0 | Value::V1));
        raw * 2 + i64::from(bit == Value::V1)
    });
    let node = design.node(node);
    let negative =
        node.range.signed() && bits.len() == node.width() as usize && bits[0] == Value::V1;
    if negative { raw - (1 << bits.len()) } else { raw }
}

/// Both kinds of file, read as a viewer does, hold every value of every signal.
fn viewers_read(method: Method) {
    let (design, columns) = window(method);
    for format in [Format::Vcd, Format::Fst] {
        // Pieces of odd sizes, smaller and larger than a block.
        for piece in [1, 63, 150, 1000] {
            let file = written(format, &design, &columns, piece);
            let got = read(file, &design, &columns.nodes, columns.span());
            agreement::assert_same(&design, &columns, &got, 0, &format!("{format:?}"));
        }
    }
}

#[test]
fn viewers_read_lyons_waveforms() {
    viewers_read(Method::Lyon);
}

#[test]
fn viewers_read_the_hybrids_waveforms() {
    viewers_read(Method::Hybrid);
}

#[test]
fn waveforms_from_the_first_clock_on_read_back() {
    let (design, mut columns) = window(Method::Lyon);
    columns.first_clock = 0;
    for format in [Format::Vcd, Format::Fst] {
        let file = written(format, &design, &columns, 64);
        agreement::assert_same(
            &design,
            &columns,
            &read(file, &design, &columns.nodes, columns.span()),
            0,
            &format!("{format:?}"),
        );
    }
}

/// A core with ports of every width, with sign and without.
fn every_width() -> Design {
    let mut program = Program::default();
    for (width, signed) in (1..=63).flat_map(|width| [(width, false), (width, true)]) {
        program.ports.push(port(
            format!("{}{width}", if signed { "s" } else { "u" }),
            Range::whole(width, signed),
            0,
        ));
        assert!(
            program.push(Operation::Negated, &[program.ports.len() - 1], Place::Core) || width > 60
        );
    }
    program.describe().unwrap().design
}

/// The columns of every signal, between its extremes.
fn extremes(design: &Design, clocks: usize) -> Columns {
    let nodes: Vec<NodeId> = design.variables();
    let mut columns = Columns::new(&nodes);
    columns.first_clock = 7;
    for (index, &id) in nodes.iter().enumerate() {
        let node = design.node(id);
        let (width, signed) = (node.width(), node.range.signed());
        let (low, high) =
            if signed { (-1 << (width - 1), !(-1 << (width - 1))) } else { (0, !(-1 << width)) };
        let values = [high, low, low, 0, high / 2, if signed { -1 } else { 1 }];
        columns.values[index] = match (node.op, node.registered()) {
            // Connected signals have one value.
            (Op::Copy(of), false) => {
                columns.of(of).unwrap().iter().map(|&raw| node.wrap(raw)).collect()
            }
            _ => (0..clocks).map(|clock| values[clock % values.len()]).collect(),
        };
    }
    columns
}

#[test]
fn extreme_values_of_every_width_read_back() {
    let design = every_width();
    let columns = extremes(&design, 200);
    let widths: HashSet<(u32, bool)> = columns
        .nodes
        .iter()
        .map(|&id| (design.node(id).width(), design.node(id).range.signed()))
        .collect();
    assert!(
        (1..=63).all(|width| widths.contains(&(width, false)) && widths.contains(&(width, true))),
        "{widths:?}"
    );
    for format in [Format::Vcd, Format::Fst] {
        let file = written(format, &design, &columns, 50);
        agreement::assert_same(
            &design,
            &columns,
            &read(file, &design, &columns.nodes, columns.span()),
            0,
            &format!("{format:?}"),
        );
    }
}

#[test]
fn a_file_without_clocks_is_whole() {
    let (design, columns) = window(Method::Lyon);
    let mut file = vec![];
    dump_vcd::Waves::begin(&mut file, &design, &columns.nodes, "").unwrap().end().unwrap();
    assert!(String::from_utf8(file).unwrap().ends_with("$enddefinitions $end\n"));
    let mut file = std::io::Cursor::new(vec![]);
    // A name that is longer than its field, with a letter across the field's end.
    let about = format!("{}\u{e9} and more", "x".repeat(126));
    fst::Waves::begin(&mut file, &design, &columns.nodes, &about).unwrap().end().unwrap();
}

#[test]
fn what_cannot_be_written_is_an_error() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let (design, columns) = window(Method::Lyon);
    let result = dump_vcd::write(Full, &design, &columns, "");
    assert_eq!(result.unwrap_err().kind(), std::io::ErrorKind::StorageFull);
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
    let view = gtkw::View { dump_file: "lyon.vcd", window: columns.span(), marker: Some(245) };
    gtkw::write(&mut file, &design, &shown, &view).unwrap();
    let text = String::from_utf8(file).unwrap();
    let waveform = written(Format::Vcd, &design, &columns, 100);
    let header = Parser::new(waveform.as_slice()).parse_header().unwrap();
    let names = text.lines().filter(|line| line.starts_with("lyon."));
    let mut count = 0;
    for name in names {
        let path: Vec<&str> = name.split('[').next().unwrap().split('.').collect();
        assert!(header.find_var(&path).is_some(), "{name} is not in the waveform");
        assert!(
            !name.contains(".product_") && !name.contains("_d1"),
            "{name} has no name of its own"
        );
        count += 1;
    }
    // The clock and reset beside what was asked for, each once.
    assert_eq!(count, shown.len() + 2);
    assert!(text.contains("[dumpfile] \"lyon.vcd\"") && text.contains(" 2450 -1"));
}
