//! A core's module is called as nothing in it, whatever its scene is called.
use std::collections::BTreeSet;

use specula_datapath::Design;
use specula_datapath::design::ScopeId;
use specula_datapath::verilog::CONTROL;
use specula_hdl::elaborate;
use specula_hdl::module_name;
use specula_spec::{CoreSpec, Method, SceneCore};

/// General cores, and those of the built-in scenes.
fn specs() -> Vec<CoreSpec> {
    let scenes =
        ["icosahedron", "lamps"].map(|scene| specula_scene::load(scene, Some((16, 12))).unwrap());
    let of_scene = |scene: &specula_scene::LoadedScene| {
        let specs = Method::ALL.into_iter().filter_map(|method| scene.core_spec(Some(method)).ok());
        specs.flat_map(|spec| [spec.general(), spec]).collect::<Vec<_>>()
    };
    scenes.iter().flat_map(of_scene).collect()
}

/// What is declared in the core's own module.
fn declared(design: &Design) -> BTreeSet<&str> {
    let signals = design
        .nodes
        .iter()
        .filter(|node| node.scope == ScopeId::TOP)
        .map(|node| node.name.as_str());
    let instances = design.scopes.iter().filter(|scope| scope.parent == Some(ScopeId::TOP));
    signals.chain(instances.map(|scope| scope.instance.as_str())).chain(CONTROL).collect()
}

/// Names of what goes in and comes out, in their order.
fn ports(design: &Design) -> Vec<&str> {
    let inputs =
        design.inputs.iter().flatten().chain([&design.valid, &design.start, &design.valid_out]);
    inputs.chain(&design.outputs).map(|id| design.node(*id).name.as_str()).collect()
}

#[test]
fn no_module_has_the_name_of_something_in_it() {
    for spec in specs() {
        let design = elaborate(&spec, "some_scene").unwrap();
        let (ports, names) = (ports(&design), declared(&design));
        for port in ports.iter().copied().chain(CONTROL) {
            let module = module_name(port, &spec);
            assert!(!names.contains(module.as_str()), "{module}, {spec:?}");
        }
        // Signals inside make room; ports stay as they are.
        for name in names.iter().copied().filter(|name| !ports.contains(name)).step_by(101) {
            let module = module_name(name, &spec);
            let renamed = elaborate(&spec, &module).unwrap();
            assert!(!declared(&renamed).contains(module.as_str()), "{module}, {spec:?}");
            assert_eq!(self::ports(&renamed), ports, "{module}, {spec:?}");
        }
    }
}
