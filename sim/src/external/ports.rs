//! The ports of a core, as a simulator's main program sees them.
use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, ScopeId};

/// A port of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// The signal.
    pub node: NodeId,
    /// Its name.
    pub name: String,
    /// Its width in bits.
    pub width: u32,
    /// Whether it is an input.
    pub input: bool,
}

impl Port {
    /// Its bounds in a declaration; nothing for a single bit.
    pub fn bounds(&self) -> String {
        if self.width == 1 { String::new() } else { format!("[{}:0] ", self.width - 1) }
    }
}

/// The ports of a core, by what a main program does with them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ports {
    /// Name of the core.
    pub core: String,
    /// Whether there is a clock.
    pub clock: bool,
    /// Whether there is a reset.
    pub reset: bool,
    /// The bit that says a pixel enters.
    pub valid: Port,
    /// The bit that says the pixel is the first of its span.
    pub start: Port,
    /// Data inputs that are there, in the order of the design's inputs.
    pub inputs: Vec<Port>,
    /// Outputs, `valid_out` first.
    pub outputs: Vec<Port>,
}

impl Ports {
    /// The ports of `design`.
    pub fn of(design: &Design) -> Ports {
        let port = |&node: &NodeId| Port {
            node,
            name: design.node(node).name.clone(),
            width: design.node(node).width(),
            input: design.node(node).op == Op::Input,
        };
        Ports {
            core: design.scope(ScopeId::TOP).instance.clone(),
            clock: design.nodes.iter().any(Node::registered),
            reset: design.to_block().has_reset(),
            valid: port(&design.valid),
            start: port(&design.start),
            inputs: design.inputs.iter().flatten().map(port).collect(),
            outputs: [design.valid_out].iter().chain(&design.outputs).map(port).collect(),
        }
    }

    /// Inputs and outputs, clock and reset apart.
    pub fn all(&self) -> impl Iterator<Item = &Port> {
        [&self.valid, &self.start]
            .into_iter()
            .chain(&self.inputs)
            .chain(self.outputs.iter().filter(|port| !port.input))
    }

    /// The places among all ports of those that carry the `watched` signals; `None` if a signal is
    /// inside the core.
    pub fn numbers(&self, watched: &[NodeId]) -> Option<Vec<usize>> {
        watched.iter().map(|&node| self.all().position(|port| port.node == node)).collect()
    }
}
