//! Waveforms read by `wellen`, as a viewer would.
use std::io::Cursor;
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_sim::vcd::PERIOD;
use specula_sim::{Columns, fst, vcd};
use wellen::simple::{Waveform, read_from_reader};

/// A kind of file.
#[derive(Clone, Copy, Debug)]
pub enum Format {
    Vcd,
    Fst,
}

/// The columns as such a file, written in pieces of so many clocks.
pub fn written(format: Format, design: &Design, columns: &Columns, piece: usize) -> Vec<u8> {
    let pieces = (0..columns.clocks()).step_by(piece).map(|first| {
        let first = columns.first_clock + first as u64;
        first..first + piece as u64
    });
    let mut file = Cursor::new(vec![]);
    let about = "a scene for $1";
    match format {
        Format::Vcd => {
            let mut waves = vcd::Waves::begin(&mut file, design, &columns.nodes, about).unwrap();
            pieces.for_each(|piece| waves.append(&columns.batch().within(&piece)).unwrap());
            waves.end().unwrap();
        }
        Format::Fst => {
            let mut waves = fst::Waves::begin(&mut file, design, &columns.nodes, about).unwrap();
            pieces.for_each(|piece| waves.append(&columns.batch().within(&piece)).unwrap());
            waves.end().unwrap();
        }
    }
    file.into_inner()
}

/// What a waveform of a design holds of these signals at these clocks; the clock and reset are
/// checked.
pub fn read(file: Vec<u8>, design: &Design, nodes: &[NodeId], clocks: Range<u64>) -> Columns {
    let mut waveform = read_from_reader(Cursor::new(file)).unwrap();
    assert_eq!(waveform.time_table().last(), Some(&(PERIOD * clocks.end)));
    let core = design.path(specula_datapath::design::ScopeId::TOP)[0].to_owned();
    let edges: Vec<u64> =
        clocks.clone().flat_map(|clock| [PERIOD * clock, PERIOD * clock + PERIOD / 2]).collect();
    let levels: Vec<i64> = clocks.clone().flat_map(|_| [1, 0]).collect();
    assert_eq!(values(&mut waveform, &[&core, "clock"], 1, false, edges.iter().copied()), levels);
    assert!(
        values(&mut waveform, &[&core, "reset"], 1, false, edges.into_iter())
            .iter()
            .all(|&level| level == 0)
    );
    let mut columns = Columns::new(nodes);
    columns.first_clock = clocks.start;
    for (column, &id) in columns.values.iter_mut().zip(nodes) {
        let node = design.node(id);
        let name = design.full_name(id);
        let path: Vec<&str> = name.split('.').collect();
        let times = clocks.clone().map(|clock| PERIOD * clock);
        *column = values(&mut waveform, &path, node.width(), node.range.signed(), times);
    }
    columns
}

/// The values of a signal at some times.
fn values(
    waveform: &mut Waveform,
    path: &[&str],
    width: u32,
    signed: bool,
    times: impl Iterator<Item = u64>,
) -> Vec<i64> {
    let (name, scopes) = path.split_last().unwrap();
    let hierarchy = waveform.hierarchy();
    let variable =
        hierarchy.lookup_var(scopes, name).unwrap_or_else(|| panic!("{path:?} is missing"));
    let variable = &hierarchy[variable];
    assert_eq!(variable.length(hierarchy), Some(width), "{path:?}");
    let bounds = variable.index().map(|index| (index.msb(), index.lsb()));
    assert_eq!(bounds, (width > 1).then(|| (i64::from(width) - 1, 0)), "{path:?}");
    let signal = variable.signal_ref();
    waveform.load_signals(&[signal]);
    let mut changes = waveform.get_signal(signal).unwrap().iter_changes().peekable();
    let table = waveform.time_table();
    let mut bits = None;
    let at = |time: u64| {
        while let Some((_, value)) = changes.next_if(|&(index, _)| table[index as usize] <= time) {
            bits = value.to_bit_string();
        }
        number(bits.as_deref().unwrap_or_else(|| panic!("{path:?} has no value at {time}")), signed)
    };
    times.map(at).collect()
}

fn number(bits: &str, signed: bool) -> i64 {
    let raw = i64::from_str_radix(bits, 2)
        .unwrap_or_else(|_| panic!("`{bits}` has other bits than 0 and 1"));
    if signed && bits.starts_with('1') { raw - (1 << bits.len()) } else { raw }
}
