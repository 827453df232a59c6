//! The clock that a core was made for, in the format of its target's tools.
use super::StreamCore;
use super::files::File;

/// The file's suffix and text, if the core has a target for which the format is known.
pub fn constraints(core: &StreamCore) -> Option<File> {
    let (version, name) = (env!("CARGO_PKG_VERSION"), core.name());
    let mhz = core.spec.target.as_ref()?.clock_mhz;
    let about = format!("# Specula {version}: the clock of {name}_ip.\n");
    let suffix = suffix(core)?;
    let clock = match suffix {
        "lpf" => format!("FREQUENCY PORT \"aclk\" {mhz} MHZ;\n"),
        _ => {
            let period = 1e3 / mhz;
            format!("create_clock -name aclk -period {period:.3} [get_ports aclk]\n")
        }
    };
    Some(File { name: format!("{name}.{suffix}"), text: about + &clock })
}

/// What the name of the core's file ends with, after a dot.
pub fn suffix(core: &StreamCore) -> Option<&'static str> {
    match core.spec.target.as_ref()?.name.as_str() {
        "ecp5" => Some("lpf"),
        "xilinx7" => Some("xdc"),
        "gowin" => Some("sdc"),
        _ => None,
    }
}
