//! What an elaborated core does in a pixel, counted as the papers count: powers and the materials' products left out.
use specula_hdl::Design;
use specula_hdl::design::{Node, NodeId, Op, Register, Scope, ScopeId};
use specula_scene::{CoreSpec, Frame, Method, Needs};

use crate::BenchError;

/// Units that divide, and units that take a reciprocal root.
const DIVIDERS: [&str; 3] = ["divider", "limited_quotient", "signed_quotient"];
const ROOTS: [&str; 1] = ["reciprocal_square_root"];
/// What the papers leave out: powers, and the materials' products.
const LEFT_OUT: [&str; 4] = ["channel", "power", "square", "any_power"];

/// What a core does in a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contents {
    /// Forward differences: registers that grow by a step.
    pub accumulators: usize,
    /// Products of two variables.
    pub multipliers: usize,
    /// Dividers.
    pub dividers: usize,
    /// Units for 1/√.
    pub reciprocal_roots: usize,
}

impl Contents {
    /// Of a design.
    pub fn of(design: &Design) -> Contents {
        let inner: Vec<&str> = DIVIDERS.into_iter().chain(ROOTS).chain(LEFT_OUT).collect();
        let constant = |id| design.node(id).op.constant().is_some();
        let is_product = |op: Op| matches!(op, Op::Mul(a, b) if !constant(a) && !constant(b));
        let products = design.iter().filter(|(_, node)| is_product(node.op) && !is_within(design, node.scope, &inner)).count();
        // An accumulator's register reads what is described behind it.
        let accumulates =
            |(id, node): &(NodeId, &Node)| node.register == Register::Data && matches!(node.op, Op::Wrap(next) if next > *id);
        Contents {
            accumulators: design.iter().filter(accumulates).count(),
            multipliers: products,
            dividers: outermost(design, &DIVIDERS),
            reciprocal_roots: outermost(design, &ROOTS),
        }
    }
}

/// Whether a scope is one of `units`, or inside one.
fn is_within(design: &Design, mut scope: ScopeId, units: &[&str]) -> bool {
    loop {
        let of = &design.scopes[scope.0 as usize];
        match of.parent {
            _ if units.contains(&of.unit.as_str()) => return true,
            Some(parent) => scope = parent,
            None => return false,
        }
    }
}

/// How many of `units` there are, those inside others not counted.
fn outermost(design: &Design, units: &[&str]) -> usize {
    let is_one = |scope: &&Scope| {
        units.contains(&scope.unit.as_str()) && !scope.parent.is_some_and(|parent| is_within(design, parent, units))
    };
    design.scopes.iter().filter(is_one).count()
}

/// A row of the papers' tables, and the core that does it.
#[derive(Clone, Copy, Debug)]
pub struct Counterpart {
    /// The row's name in [`specula_golden::operations::TABLE`].
    pub row: &'static str,
    /// The method.
    pub method: Method,
    /// Its options.
    pub options: &'static str,
    /// Products that 1/√q or 1/q makes of the row's divisions.
    pub further_products: usize,
}

/// Hast's schemes.
pub const HAST: [Counterpart; 8] = [
    of("hybrid", Method::Hybrid, "", 0),
    of("duff-blinn", Method::Duff, "duff.specular = \"blinn\"", 0),
    of("duff-hybrid", Method::Duff, "duff.specular = \"quotient\"", 1),
    of("duff-quotient", Method::Duff, "duff.specular = \"eq33\"", 1),
    of("duff", Method::Duff, "duff.specular = \"eq34\"", 0),
    of("reflection-blinn", Method::Reflection, "reflection.specular = \"blinn\"", 0),
    of("reflection-hybrid", Method::Reflection, "reflection.specular = \"hybrid\"", 1),
    of("reflection", Method::Reflection, "reflection.specular = \"eq34\"", 0),
];

const fn of(row: &'static str, method: Method, options: &'static str, further_products: usize) -> Counterpart {
    Counterpart { row, method, options, further_products }
}

impl Counterpart {
    /// What the general core for a frame does.
    ///
    /// # Errors
    /// [`BenchError`] if it cannot be built for the frame.
    pub fn contents(&self, frame: &Frame) -> Result<Contents, BenchError> {
        let spec = CoreSpec::for_scene(&Needs::of(frame), Some(&self.options.parse()?), Some(self.method))?;
        Ok(Contents::of(&specula_hdl::elaborate(&spec, "core")?))
    }
}
