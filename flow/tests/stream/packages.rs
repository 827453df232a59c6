//! What packages a block for other tools: Vivado's Tcl and the LiteX module.
use std::fs;
use std::process::Command;

use specula_fixtures::tools;
use specula_spec::{CoreSpec, Method, TargetClock};

use crate::block::{Block, core, frames, shapes};

/// Stand-ins for Vivado's commands: each prints its words, and gives its own name. Files must be
/// there.
const VIVADO: &str = r#"
proc stand_in {name arguments} {
  puts "$name $arguments"
  return $name
}
foreach name {
  create_project set_property get_filesets get_files update_compile_order close_project
  ipx::package_project ipx::current_core ipx::infer_bus_interfaces ipx::get_bus_interfaces
  ipx::associate_bus_interfaces ipx::get_memory_maps ipx::add_memory_map ipx::get_address_blocks
  ipx::add_address_block ipx::get_user_parameters ipx::create_xgui_files ipx::update_checksums
  ipx::check_integrity ipx::save_core
} {
  namespace eval [namespace qualifiers ::$name] {}
  proc ::$name args "stand_in $name \$args"
}
proc add_files args {
  foreach file [lindex $args end] {
    if {![file exists $file]} { error "no file $file" }
    puts "add_files [file tail $file]"
  }
}
source shader_ip.tcl
"#;

/// Every command is one of Vivado's or Tcl's, every file is there, and what is packaged is complete.
#[test]
fn vivado_packages_the_block() {
    if !tools::is_installed("tclsh") {
        return;
    }
    let frames = frames(19);
    let any = core(Method::Gouraud, &frames, false);
    let target = TargetClock { name: "xilinx7".to_owned(), clock_mhz: 150.0 };
    let own = CoreSpec { target: Some(target), ..any.clone() };
    for (spec, constrained) in [(any, false), (own, true)] {
        let block = Block::new(&spec, &frames, shapes()[0]);
        fs::write(block.path("stand_ins.tcl"), VIVADO).expect("it can be written");
        let (succeeded, said) = block.run("tclsh", &["stand_ins.tcl"]);
        assert!(succeeded, "{said}");
        for file in ["shader.v", "shader_axis.v", "shader_regs.v", "shader_ip.v"] {
            assert!(said.contains(&format!("add_files {file}\n")), "{said}");
        }
        assert_eq!(said.contains("add_files shader.xdc\n"), constrained, "{said}");
        for interface in ["s_axis", "m_axis", "s_axi"] {
            assert!(said.contains(&format!("-busif {interface} -clock aclk")), "{said}");
        }
        assert!(said.contains("ipx::save_core") && said.contains("set_property top shader_ip"));
    }
}

/// The LiteX module becomes Verilog, and shades the frames in the block's bench.
#[test]
fn the_litex_module_shades_the_frames() {
    if !["python3", "iverilog"].into_iter().all(tools::is_installed) || !has_litex() {
        return;
    }
    let frames = frames(20);
    for shape in [shapes()[0], shapes()[3]] {
        let block = Block::new(&core(Method::Gouraud, &frames, false), &frames, shape);
        let said = block.make(&["litex"]);
        let bench = fs::read_to_string(block.path("shader_tb.v")).expect("it is there");
        let of_module = bench.replacen("shader_ip dut", "shader_litex dut", 1);
        assert_ne!(of_module, bench, "{said}");
        fs::write(block.path("litex_tb.v"), of_module).expect("it can be written");
        let sources = [
            "litex_tb.v",
            "shader_litex.v",
            "shader.v",
            "shader_axis.v",
            "shader_regs.v",
            "shader_ip.v",
        ];
        let compile = [&["-g2005", "-s", "shader_tb", "-o", "litex.vvp"][..], &sources].concat();
        let (compiled, said) = block.run("iverilog", &compile);
        assert!(compiled, "{said}");
        let (_, said) = block.run("vvp", &["-n", "litex.vvp", "+seed=6"]);
        assert!(said.contains("\nPASS: ") || said.starts_with("PASS: "), "{said}");
    }
}

/// Whether Python has LiteX.
fn has_litex() -> bool {
    let ended = Command::new("python3").args(["-c", "import litex, migen"]).output();
    let found = ended.is_ok_and(|ended| ended.status.success());
    if !found {
        tools::skipped("Python has no LiteX");
    }
    found
}
