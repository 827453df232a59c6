//! The papers' operations per pixel against what the elaborated cores contain, with one light; docs/operations.md explains differences.
use specula_golden::operations::TABLE;
use specula_hdl::Design;
use specula_hdl::design::{Op, Register, ScopeId};
use specula_scene::spec::CoreOptions;
use specula_scene::{CoreSpec, Method, Needs, load};

/// Units that divide or take roots, by what the papers count them as.
const DIVIDERS: [&str; 3] = ["divider", "limited_quotient", "signed_quotient"];
const ROOTS: [&str; 1] = ["reciprocal_square_root"];
/// What the papers leave out: powers, and the materials' products.
const LEFT_OUT: [&str; 4] = ["channel", "power", "square", "any_power"];

/// What a core does in a pixel.
#[derive(Debug, PartialEq, Eq)]
struct Contents {
    /// Forward differences: registers that grow by a step.
    accumulators: usize,
    /// Products of two variables.
    multipliers: usize,
    dividers: usize,
    reciprocal_roots: usize,
}

fn contents(design: &Design) -> Contents {
    let within = |mut scope: ScopeId, units: &[&str]| loop {
        let of = &design.scopes[scope.0 as usize];
        match of.parent {
            _ if units.contains(&of.unit.as_str()) => break true,
            Some(parent) => scope = parent,
            None => break false,
        }
    };
    let outermost = |units: &[&str]| {
        let is_one = |scope: &&specula_hdl::design::Scope| {
            units.contains(&scope.unit.as_str()) && !scope.parent.is_some_and(|parent| within(parent, units))
        };
        design.scopes.iter().filter(is_one).count()
    };
    let inner: Vec<&str> = DIVIDERS.into_iter().chain(ROOTS).chain(LEFT_OUT).collect();
    let constant = |id| design.node(id).op.constant().is_some();
    let is_product = |op: Op| matches!(op, Op::Mul(a, b) if !constant(a) && !constant(b));
    let products = design.iter().filter(|(_, node)| is_product(node.op) && !within(node.scope, &inner)).count();
    // An accumulator's register reads what is described behind it.
    let accumulates = |(id, node): &(specula_hdl::design::NodeId, &specula_hdl::design::Node)| {
        node.register == Register::Data && matches!(node.op, Op::Wrap(next) if next > *id)
    };
    Contents {
        accumulators: design.iter().filter(accumulates).count(),
        multipliers: products,
        dividers: outermost(&DIVIDERS),
        reciprocal_roots: outermost(&ROOTS),
    }
}

fn core(method: Method, options: &str) -> Contents {
    let frame = load("teapot", Some((160, 120))).unwrap().frame;
    let options: CoreOptions = options.parse().unwrap();
    let spec = CoreSpec::for_scene(&Needs::of(&frame), Some(&options), Some(method)).unwrap();
    assert_eq!(spec.lights, 1);
    contents(&specula_hdl::elaborate(&spec, "core").unwrap())
}

/// A method with options, the row of the table, and the products that 1/√q or 1/q makes of the row's divisions.
const CORES: [(&str, Method, &str, usize); 8] = [
    ("hybrid", Method::Hybrid, "", 0),
    ("duff-blinn", Method::Duff, "duff.specular = \"blinn\"", 0),
    ("duff-hybrid", Method::Duff, "duff.specular = \"quotient\"", 1),
    ("duff-quotient", Method::Duff, "duff.specular = \"eq33\"", 1),
    ("duff", Method::Duff, "duff.specular = \"eq34\"", 0),
    ("reflection-blinn", Method::Reflection, "reflection.specular = \"blinn\"", 0),
    ("reflection-hybrid", Method::Reflection, "reflection.specular = \"hybrid\"", 1),
    ("reflection", Method::Reflection, "reflection.specular = \"eq34\"", 0),
];

#[test]
fn forward_differences_are_as_many_as_the_papers_count() {
    for (name, method, options, further_products) in CORES {
        let printed = TABLE.iter().find(|row| row.name == name).unwrap().printed;
        let core = core(method, options);
        println!("{name}: {core:?} printed {printed:?}");
        assert_eq!(core.accumulators, printed.adds as usize, "{name}: additions");
        // 1/√q is one unit, a root and a division together.
        assert_eq!(core.reciprocal_roots, printed.square_roots as usize, "{name}: roots");
        assert_eq!(core.dividers + core.reciprocal_roots, printed.divisions as usize, "{name}: divisions");
        assert_eq!(core.multipliers, printed.multiplies as usize + further_products, "{name}: products");
    }
}
