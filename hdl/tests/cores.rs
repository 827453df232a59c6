//! Both cores, elaborated.
use specula_hdl::block::check_all;
use specula_hdl::verilog::{self, Header};
use specula_scene::{CoreSpec, Method, Needs};

fn needs() -> Needs {
    Needs {
        lights: 2,
        longest_span: 256,
        largest_shininess: 256,
        uneven_shininess: None,
        brightest_coefficient: 1.0,
        widest_angle: 20.0,
        shortest_normal: 0.95,
    }
}

#[test]
fn cores_pass_rust_hdls_checks() {
    for method in Method::ALL {
        let spec = CoreSpec::for_scene(&needs(), None, Some(method)).unwrap();
        let design = specula_hdl::elaborate(&spec, method.name()).unwrap();
        let block = design.to_block();
        check_all(&block).unwrap();
        let text = verilog::print(&block, &Header::default());
        std::fs::write(format!("/tmp/vt/{}.v", method.name()), text).unwrap();
        println!(
            "{} latency {} bound {} {:?} nodes {}",
            method.name(),
            design.latency(),
            design.error_bound(),
            design.size(),
            design.nodes.len()
        );
        for s in design.unit_sizes() {
            println!("  {:?}", s);
        }
    }
}
