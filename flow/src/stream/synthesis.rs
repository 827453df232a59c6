//! What programs that synthesise, place and route a block are told of its core's target.
use super::template::Values;
use super::{StreamCore, constraints};

/// Adds what templates ask for besides.
pub fn values(core: &StreamCore, values: &mut Values) {
    let target = target(core);
    values.set("YOSYS_ARCH", yosys_arch(target));
    values.set("YOSYS_CELLS", yosys_cells(target));
    let suffix = constraints::suffix(core);
    for (flag, ends) in [("lpf", "lpf"), ("xdc", "xdc"), ("sdc", "sdc")] {
        values.flag(flag, suffix == Some(ends));
    }
    // Pins of the devices on which FuseSoC's targets place the block.
    values.flag("ecp5", yosys_arch(target) == "ecp5" && pins(core) <= 365);
    values.flag("ice40", target == Some("ice40hx") && pins(core) <= 206);
    values.set("ECP5_FILESETS", if suffix == Some("lpf") { "rtl, constraints" } else { "rtl" });
    let mhz = core.spec.target.as_ref().map_or(0.0, |target| target.clock_mhz);
    values.set("CLOCK_MHZ", mhz);
    values.set(
        "CELLS_ABOUT",
        match target {
            Some("ecp5") => " besides the cell MULT18X18D of an ECP5",
            Some("ice40up") => " besides the cell SB_MAC16 of an iCE40 UltraPlus",
            _ => "",
        },
    );
}

/// The name of the core's target; none of a core for any device.
fn target<'a>(core: &'a StreamCore) -> Option<&'a str> {
    core.spec.target.as_ref().map(|target| target.name.as_str())
}

/// Bits of all ports of the block.
fn pins(core: &StreamCore) -> u32 {
    let registers = 2 * (12 + 32 + 2) + 4 + 10;
    2 + core.word.bits() + 3 + core.pixel_bits() + 4 + registers
}

/// Yosys's name for the family of a target; a core for any device is tried on an ECP5.
fn yosys_arch(target: Option<&str>) -> &'static str {
    match target {
        Some("xilinx7") => "xilinx",
        Some("gowin") => "gowin",
        Some(name) if name.starts_with("ice40") => "ice40",
        _ => "ecp5",
    }
}

/// What reads the cells that a core for a target asks for by name, before it is read itself.
fn yosys_cells(target: Option<&str>) -> &'static str {
    match target {
        Some("ecp5") => "read_verilog -lib +/ecp5/cells_sim.v +/ecp5/cells_bb.v; ",
        Some("ice40up") => "read_verilog -lib +/ice40/cells_sim.v; ",
        _ => "",
    }
}
