//! GTKWave's save file for a waveform: the signals that matter, grouped by unit and shown as the
//! numbers they stand for.
//!
//! The format is not documented; what is written here was tried with GTKWave 3.3.118, which shows
//! fractions below 10^-4 as 0. Flags stand before a signal as `@` and a hexadecimal number, bits as
//! in `TraceEntFlagBits` of GTKWave's `analyzer.h`.
//!
//! None is written for Surfer: we found no description of its state files (`.surf.ron`), and no
//! promise that they stay as they are.
use std::collections::HashSet;
use std::io::{self, BufWriter, Write};
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Register, ScopeId};

use crate::vcd::PERIOD;

const DECIMAL: u64 = 1 << 2;
const BINARY: u64 = 1 << 3;
const RIGHT_JUSTIFIED: u64 = 1 << 5;
const BLANK: u64 = 1 << 9;
const SIGNED_DECIMAL: u64 = 1 << 10;
const CLOSED: u64 = 1 << 22;
const GROUP_BEGIN: u64 = 1 << 23;
const GROUP_END: u64 = 1 << 24;
const FIXED_POINT: u64 = 1 << 30;

/// Pixels that the waves take in a window of the size that the file asks for.
const PIXELS: f64 = 1000.0;
/// Clocks shown at first where a marker says which: few enough that numbers can be read.
const CLOCKS_AT_MARKER: u64 = 12;

/// What the viewer is to open with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct View<'a> {
    /// The waveform's file name, in the directory of the save file.
    pub dump_file: &'a str,
    /// The clocks that the waveform covers.
    pub window: Range<u64>,
    /// The clock to look at, if there is one: that of the worst pixel, or of the first wrong one.
    pub marker: Option<u64>,
}

/// The signals of a design that a reader looks for: ports of units and signals with a name of their
/// own, without delays of others.
pub fn interesting(design: &Design) -> Vec<NodeId> {
    let read_outside = unit_outputs(design);
    let wanted = |&(id, node): &(NodeId, &Node)| {
        read_outside.contains(&id) || is_interesting(design, id, node)
    };
    design.iter().filter(wanted).map(|(id, _)| id).collect()
}

/// Writes the save file; signals of `shown` that the waveform does not hold make GTKWave complain,
/// so give those that it holds.
///
/// # Errors
/// What the system says if `out` cannot be written.
pub fn write(out: impl Write, design: &Design, shown: &[NodeId], view: &View) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    heading(&mut out, design, view)?;
    let mut save = Save { out, design, shown };
    save.core()?;
    save.out.flush()
}

fn heading(out: &mut impl Write, design: &Design, view: &View) -> io::Result<()> {
    let clocks = view.window.end.saturating_sub(view.window.start).max(1);
    let (first, visible) = match view.marker {
        Some(marker) => (
            marker.saturating_sub(CLOCKS_AT_MARKER / 2).max(view.window.start),
            clocks.min(CLOCKS_AT_MARKER),
        ),
        None => (view.window.start, clocks),
    };
    // At zoom z the screen shows 2^-z nanoseconds on every 200 pixels; z is never above 0.
    let zoom = (PIXELS / 200.0 / (visible * PERIOD) as f64).log2();
    let marker = view.marker.map_or(-1, |clock| (PERIOD * clock) as i64);
    writeln!(out, "[*] GTKWave save file, written by Specula")?;
    writeln!(out, "[dumpfile] \"{}\"", view.dump_file)?;
    writeln!(out, "[timestart] {}", PERIOD * first)?;
    writeln!(out, "[size] 1500 900\n[pos] -1 -1")?;
    writeln!(out, "*{zoom:.6} {marker}{}", " -1".repeat(26))?;
    writeln!(out, "[treeopen] {}.", design.scope(ScopeId::TOP).instance)?;
    writeln!(out, "[sst_width] 220\n[signals_width] 380\n[sst_expanded] 0")
}

/// A save file while its list of signals is written.
struct Save<'a, W: Write> {
    out: W,
    design: &'a Design,
    shown: &'a [NodeId],
}

impl<W: Write> Save<'_, W> {
    /// Control, the pixel that leaves, the span that enters, then a group for each unit.
    fn core(&mut self) -> io::Result<()> {
        let design = self.design;
        let core = design.scope(ScopeId::TOP).instance.clone();
        self.begin("control", 0)?;
        writeln!(self.out, "@{:x}\n{core}.clock\n{core}.reset", BINARY | RIGHT_JUSTIFIED)?;
        self.signals(&[design.valid, design.start, design.valid_out])?;
        self.end("control")?;
        self.begin("pixel", 0)?;
        self.signals(&design.outputs)?;
        self.end("pixel")?;
        self.begin("span", CLOSED)?;
        self.signals(&design.inputs.iter().flatten().copied().collect::<Vec<_>>())?;
        self.end("span")?;
        let ports = |id: &NodeId| {
            [design.valid, design.start, design.valid_out].contains(id)
                || design.outputs.contains(id)
                || design.node(*id).op == Op::Input
        };
        let others: Vec<NodeId> = self.members(ScopeId::TOP).filter(|id| !ports(id)).collect();
        self.signals(&others)?;
        self.units(ScopeId::TOP, 0)
    }

    /// The units in `outer`; those deep inside are closed, so that the list stays short.
    fn units(&mut self, outer: ScopeId, depth: u32) -> io::Result<()> {
        for index in 0..self.design.scopes.len() as u32 {
            let scope = ScopeId(index);
            if self.design.scope(scope).parent != Some(outer) || !self.holds_any(scope) {
                continue;
            }
            let instance = self.design.scope(scope).instance.clone();
            self.begin(&instance, if depth == 0 { 0 } else { CLOSED })?;
            let members: Vec<NodeId> = self.members(scope).collect();
            self.signals(&members)?;
            self.units(scope, depth + 1)?;
            self.end(&instance)?;
        }
        Ok(())
    }

    fn members(&self, scope: ScopeId) -> impl Iterator<Item = NodeId> + use<'_, W> {
        self.shown.iter().copied().filter(move |&id| self.design.node(id).scope == scope)
    }

    /// Whether a shown signal is in `scope` or in a unit within it.
    fn holds_any(&self, scope: ScopeId) -> bool {
        self.shown.iter().any(|&id| {
            let mut at = Some(self.design.node(id).scope);
            while at.is_some_and(|at| at != scope) {
                at = at.and_then(|at| self.design.scope(at).parent);
            }
            at.is_some()
        })
    }

    fn begin(&mut self, group: &str, closed: u64) -> io::Result<()> {
        writeln!(self.out, "@{:x}\n-{group}", GROUP_BEGIN | BLANK | closed)
    }

    fn end(&mut self, group: &str) -> io::Result<()> {
        writeln!(self.out, "@{:x}\n-{group}", GROUP_END | BLANK)
    }

    fn signals(&mut self, ids: &[NodeId]) -> io::Result<()> {
        for &id in ids.iter().filter(|id| self.shown.contains(id)) {
            let node = self.design.node(id);
            let bounds =
                if node.width() > 1 { format!("[{}:0]", node.width() - 1) } else { String::new() };
            writeln!(self.out, "@{:x}", flags(node))?;
            if node.width() > 1 && node.fraction_bits > 0 {
                writeln!(self.out, "[fpshift_count] {}", node.fraction_bits)?;
            }
            writeln!(self.out, "{}{bounds}", self.design.full_name(id))?;
        }
        Ok(())
    }
}

/// How a signal is shown: a bit as a bit, anything else as a number.
fn flags(node: &Node) -> u64 {
    let radix = match (node.width(), node.range.signed()) {
        (1, _) => return BINARY | RIGHT_JUSTIFIED,
        (_, true) => SIGNED_DECIMAL,
        (_, false) => DECIMAL,
    };
    radix | RIGHT_JUSTIFIED | if node.fraction_bits > 0 { FIXED_POINT } else { 0 }
}

/// Signals of units that the unit around them reads.
fn unit_outputs(design: &Design) -> HashSet<NodeId> {
    let crosses =
        |node: &Node, of: NodeId| design.scope(design.node(of).scope).parent == Some(node.scope);
    let read = |node: &Node| match node.op {
        Op::Copy(of) if crosses(node, of) => Some(of),
        _ => None,
    };
    let outputs = design.nodes.iter().filter_map(read);
    outputs.filter(|&of| design.node(of).op.constant().is_none()).collect()
}

fn is_interesting(design: &Design, id: NodeId, node: &Node) -> bool {
    if design.outputs.contains(&id) || [design.valid, design.start, design.valid_out].contains(&id)
    {
        return true;
    }
    match node.op {
        Op::Constant(_) => false,
        Op::Copy(of) if node.register == Register::None && design.node(of).scope != node.scope => {
            // An input port of a unit; what comes out of one is shown there, not where it is read.
            design.scope(node.scope).parent == Some(design.node(of).scope)
        }
        _ => node.named,
    }
}
