//! The operations of an elaborated core for a pixel, counted as the papers count them: without
//! powers and the materials' products.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Scope, ScopeId};
use specula_scene::{Frame, Needs};
use specula_spec::{CoreSpec, Method};

use specula_testbench::BenchError;

pub mod lecture;
pub mod lyon;

/// Units that divide.
const DIVIDERS: [&str; 3] = ["divider", "limited_quotient", "signed_quotient"];
const RECIPROCAL_ROOTS: [&str; 1] = ["reciprocal_square_root"];
const ROOTS: [&str; 1] = ["square_root"];
/// Units that the papers leave out: powers, and the materials' products.
const LEFT_OUT: [&str; 4] = ["channel", "power", "square", "any_power"];

/// The operations of a core for a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Contents {
    /// Values that are carried from pixel to pixel: registers that grow by a step or turn by an
    /// angle.
    pub accumulators: usize,
    /// Products of two variables.
    pub multipliers: usize,
    /// Dividers.
    pub dividers: usize,
    /// Units for 1/√.
    pub reciprocal_roots: usize,
    /// Units for √ alone.
    pub square_roots: usize,
}

impl Contents {
    /// Counts the operations of a design.
    pub fn of(design: &Design) -> Contents {
        let inner: Vec<&str> =
            DIVIDERS.into_iter().chain(RECIPROCAL_ROOTS).chain(ROOTS).chain(LEFT_OUT).collect();
        let counts =
            |node: &&Node| design.factors(node).is_some() && !is_within(design, node.scope, &inner);
        // What goes from pixel to pixel is what waits for one.
        let accumulates = |(id, node): &(NodeId, &Node)| node.clock_enable(*id).is_some();
        Contents {
            accumulators: design.iter().filter(accumulates).count(),
            multipliers: design.nodes.iter().filter(counts).count(),
            dividers: outermost(design, &DIVIDERS),
            reciprocal_roots: outermost(design, &RECIPROCAL_ROOTS),
            square_roots: outermost(design, &ROOTS),
        }
    }
}

/// Widths of the operands of each product of two variables inside units of this name, the wider one
/// first, including signs.
pub fn products(design: &Design, unit: &str) -> Vec<[u32; 2]> {
    let widths = |node: &Node| {
        let [a, b] = design.factors(node)?.map(|id| design.node(id).width());
        Some([a.max(b), a.min(b)])
    };
    design
        .nodes
        .iter()
        .filter(|node| is_within(design, node.scope, &[unit]))
        .filter_map(widths)
        .collect()
}

/// Whether a scope is one of `units`, or inside one of them.
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

/// The number of `units`; those inside others are not counted.
fn outermost(design: &Design, units: &[&str]) -> usize {
    let is_one = |scope: &&Scope| {
        units.contains(&scope.unit.as_str())
            && !scope.parent.is_some_and(|parent| is_within(design, parent, units))
    };
    design.scopes.iter().filter(is_one).count()
}

/// A row of the papers' tables, and the core that computes the same.
#[derive(Clone, Copy, Debug)]
pub struct Counterpart {
    /// The row's name in [`specula_golden::loops::operations::TABLE`].
    pub row: &'static str,
    /// The method.
    pub method: Method,
    /// Its options.
    pub options: &'static str,
    /// Number of products by 1/√q or 1/q that replace divisions of the row.
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

const fn of(
    row: &'static str,
    method: Method,
    options: &'static str,
    further_products: usize,
) -> Counterpart {
    Counterpart { row, method, options, further_products }
}

impl Counterpart {
    /// The operations of the general core for a frame.
    ///
    /// # Errors
    /// [`BenchError`] if it cannot be built for the frame.
    pub fn contents(&self, frame: &Frame) -> Result<Contents, BenchError> {
        Ok(Contents::of(&general_core(&Needs::of(frame), self.method, self.options)?))
    }
}

/// The general core of a method with options.
fn general_core(needs: &Needs, method: Method, options: &str) -> Result<Design, BenchError> {
    let spec = CoreSpec::for_scene(needs, Some(&options.parse()?), Some(method))?;
    Ok(specula_hdl::elaborate(&spec, "core")?)
}
