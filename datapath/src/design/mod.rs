//! An elaborated design: every signal, what computes it, and the units they belong to.
//!
//! The builder makes it; engines run it, `block` turns it into rust-hdl blocks, and `verilog`
//! prints those.
mod multiplier;
mod op;
mod range;
mod size;

use crate::Format;

pub use multiplier::{MultiplierBlock, Primitives};
pub use op::{Op, Table, TableId, wrapped};
pub use range::{Range, WideRange};
pub(crate) use size::Operand;
pub use size::{Extent, Factors, Size, UnitSize};

/// A signal of a [`Design`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub u32);

/// A unit of a [`Design`]; the first is the core itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScopeId(pub u32);

impl ScopeId {
    /// The core itself.
    pub const TOP: ScopeId = ScopeId(0);
}

/// Whether a signal is the output of a register.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Register {
    /// No register: the value follows the operands at once.
    None,
    /// A register without reset.
    Data,
    /// A register that reset clears: what holds validity.
    Validity,
}

/// A signal and what computes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Its operator. Operands come earlier in the design, except those of registers.
    pub op: Op,
    /// Whether a register follows the operator.
    pub register: Register,
    /// Every raw value it takes; its width and sign follow from this.
    pub range: Range,
    /// Bits right of the binary point.
    pub fraction_bits: u32,
    /// Clocks after a pixel's entry at which the value belongs to that pixel; of what is still, the
    /// registers from the inputs to it.
    pub stage: u32,
    /// Whether it is still: the same for every pixel that is under way, from when it has settled.
    pub still: bool,
    /// The unit it belongs to.
    pub scope: ScopeId,
    /// Its name, unique in its unit.
    pub name: String,
    /// Whether somebody gave it its name; those of the others say what computes them, or whose
    /// delay they are, with a number behind.
    pub named: bool,
}

impl Node {
    /// Width in bits, sign included.
    pub fn width(&self) -> u32 {
        self.range.width()
    }

    /// Its format: the range's width laid round the binary point.
    pub fn format(&self) -> Format {
        format_of(self.range, self.fraction_bits)
    }

    /// `raw` brought to the signal's width.
    #[inline]
    pub fn wrap(&self, raw: i64) -> i64 {
        wrapped(raw, self.width(), self.range.signed())
    }

    /// Whether it is the output of a register.
    pub fn registered(&self) -> bool {
        self.register != Register::None
    }

    /// Of a register that holds its value, as the signal `own`, where it does not take over another:
    /// the bit with which it does, its clock enable, and what it takes over.
    pub fn clock_enable(&self, own: NodeId) -> Option<(NodeId, NodeId)> {
        match self.op {
            Op::Select(enable, next, held) if held == own && self.registered() => {
                Some((enable, next))
            }
            _ => None,
        }
    }
}

/// The format of a range of raw values: its width laid round the binary point.
pub fn format_of(range: Range, fraction_bits: u32) -> Format {
    let signed = range.signed();
    let integer_bits = (range.width() - u32::from(signed)).saturating_sub(fraction_bits);
    Format { signed, integer_bits, fraction_bits }
}

/// A unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Scope {
    /// What it is, such as `reflect`; the module is named after it.
    pub unit: String,
    /// Its formula and source, for the module's header.
    pub formula: String,
    /// Name of this instance, unique in its parent.
    pub instance: String,
    /// The unit around it; `None` for the core.
    pub parent: Option<ScopeId>,
    /// Stage at which its inputs are valid.
    pub entry: u32,
    /// Stage at which its outputs are valid.
    pub exit: u32,
}

impl Scope {
    /// Clocks from inputs to outputs.
    pub fn latency(&self) -> u32 {
        self.exit - self.entry
    }
}

/// A fact that intervals cannot see, stated by a unit and checked on every clock of a simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Assumption {
    /// The fact, such as `|N| <= 1`.
    pub fact: String,
    /// The signal that must lie in `range` whenever its pixel is valid.
    pub node: NodeId,
    /// Where it must lie.
    pub range: Range,
}

/// Hardware that was not built, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// The unit it would have been in.
    pub unit: String,
    /// What was left out.
    pub what: String,
    /// Why nothing is lost.
    pub why: String,
}

/// An elaborated design.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Every signal; a signal's operands come before it unless it is a register.
    pub nodes: Vec<Node>,
    /// Every read-only memory.
    pub tables: Vec<Table>,
    /// Every unit; parents come before children.
    pub scopes: Vec<Scope>,
    /// Data inputs of the core, in the order of the spec's ports; `None` where a port is constant.
    pub inputs: Vec<Option<NodeId>>,
    /// The bit that says a pixel enters.
    pub valid: NodeId,
    /// The bit that says the pixel is the first of its span.
    pub start: NodeId,
    /// Clocks from one pixel to the next.
    pub interval: u32,
    /// Whether values belong to a pixel in the last of these clocks alone: in the others they are
    /// what is left of components that take turns.
    pub last_slot_only: bool,
    /// The bit that says a pixel leaves.
    pub valid_out: NodeId,
    /// The pixel that leaves.
    pub outputs: Vec<NodeId>,
    /// Bound on |fixed - real| of each output that the design's error is about, the first ones, as
    /// a value.
    pub output_errors: Vec<f64>,
    /// What Verilog has cells of the device for.
    pub primitives: Primitives,
    /// Products in multiplier blocks, where the target's are known.
    pub multipliers: Vec<MultiplierBlock>,
    /// SignalInfo to be checked.
    pub assumptions: Vec<Assumption>,
    /// What was left out.
    pub left_out: Vec<LeftOut>,
}

impl Design {
    /// The signal `id`.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The unit `id`.
    pub fn scope(&self, id: ScopeId) -> &Scope {
        &self.scopes[id.0 as usize]
    }

    /// Every signal with its number.
    pub fn iter(&self) -> impl Iterator<Item = (NodeId, &Node)> {
        self.nodes.iter().enumerate().map(|(i, node)| (NodeId(i as u32), node))
    }

    /// Every signal that is no constant.
    pub fn variables(&self) -> Vec<NodeId> {
        self.iter().filter(|(_, node)| node.op.constant().is_none()).map(|(id, _)| id).collect()
    }

    /// Clocks from a pixel's entry to its exit; from the first of its clocks, if it has several that
    /// follow each other. From its last clock it is the depth, whatever was between.
    pub fn latency(&self) -> u32 {
        self.depth() + self.interval - 1
    }

    /// Clocks from what enters to what of it leaves: the stage of the outputs.
    pub fn depth(&self) -> u32 {
        self.node(self.valid_out).stage
    }

    /// The numbers of those inputs that hold for a frame.
    pub fn frame_inputs(&self) -> Vec<usize> {
        let holds = |id: &Option<NodeId>| id.is_some_and(|id| self.node(id).still);
        (0..self.inputs.len()).filter(|&input| holds(&self.inputs[input])).collect()
    }

    /// Clocks before a pixel's entry from which on inputs that hold for a frame have to be what that
    /// pixel sees. They may change when the last pixel before it has left, not earlier.
    ///
    /// What is still has the value of its inputs d clocks later, as many as it has registers before
    /// it. What is not still and reads it for a pixel does so s clocks after the pixel's entry, so
    /// it settles d - s clocks before that; the most of these, or 0.
    pub fn settling(&self) -> u32 {
        let outputs = self.outputs.iter().map(|&output| (output, self.depth()));
        let reads = self.nodes.iter().filter(|node| !node.still).flat_map(|node| {
            let at = node.stage - u32::from(node.registered());
            node.op.operands().map(move |operand| (operand, at))
        });
        let late = |(read, at): (NodeId, u32)| {
            let Node { still, stage, .. } = self.node(read);
            still.then(|| stage.saturating_sub(at))
        };
        reads.chain(outputs).filter_map(late).max().unwrap_or(0)
    }

    /// Bound on the error of an output, in LSBs: rounding and quantised inputs against the same
    /// method in exact arithmetic.
    pub fn error_bound(&self) -> f64 {
        self.output_errors.iter().copied().fold(0.0, f64::max)
    }

    /// Names of the units from the core down to `scope`.
    pub fn path(&self, scope: ScopeId) -> Vec<&str> {
        let mut path = vec![];
        let mut at = Some(scope);
        while let Some(id) = at {
            path.push(self.scope(id).instance.as_str());
            at = self.scope(id).parent;
        }
        path.reverse();
        path
    }

    /// Full name of a signal, units and all, joined by dots.
    pub fn full_name(&self, id: NodeId) -> String {
        let node = self.node(id);
        let mut path = self.path(node.scope);
        path.push(&node.name);
        path.join(".")
    }
}
