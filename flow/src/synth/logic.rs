//! A core in logic alone: in two-input gates, as a chip of standard cells has it, and in look-up
//! tables, without the blocks and carry chains of a device.
use std::path::Path;

use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::design::ScopeId;
use specula_datapath::verilog::{Header, LongDelays, print_with};
use specula_sim::{SimError, cells, temporary_directory};

use super::{SynthError, yosys};

/// What a core takes in logic alone. Read-only memory is logic too, and delay lines are flip-flops.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Logic {
    /// NAND gates of two inputs, and inverters.
    pub gates: u64,
    /// Look-up tables of four inputs, of which this would be the number in place of the gates.
    pub luts: u64,
    /// Flip-flops; one with a reset or an enable counts as one.
    pub flip_flops: u64,
}

/// What Yosys counts of gates, and of look-up tables.
const COUNTS: [&str; 2] = ["gates.txt", "luts.txt"];

impl Logic {
    /// Has Yosys map a design, twice after the same preparation: to gates, and to look-up tables.
    ///
    /// # Errors
    /// [`SynthError::Tool`] if Yosys is not installed or fails.
    pub fn of(design: &Design) -> Result<Logic, SynthError> {
        let (yosys, directory) = (yosys::program()?, temporary_directory()?);
        let core = print_with(&design.to_block(), &Header::default(), LongDelays::ShiftRegisters);
        yosys::write(directory.path(), "core.v", &core)?;
        let module = &design.scope(ScopeId::TOP).instance;
        let arguments = ["-q".to_owned(), "-p".to_owned(), script(module)];
        yosys.run_with_warnings(directory.path(), &arguments)?;
        let [gates, luts] = COUNTS.map(|name| listed(directory.path(), name));
        Ok(Logic::counted(&gates?, &luts?))
    }

    /// What Yosys's `stat` lists after both mappings.
    fn counted(gates: &str, luts: &str) -> Logic {
        let flip_flops = ["$_DFF*", "$_SDFF*", "$_ALDFF*"];
        Logic {
            gates: cells(gates, "$_NAND_") + cells(gates, "$_NOT_"),
            luts: cells(luts, "$lut"),
            flip_flops: flip_flops.map(|kind| cells(gates, kind)).iter().sum(),
        }
    }
}

fn listed(directory: &Path, name: &str) -> Result<String, SimError> {
    std::fs::read_to_string(directory.join(name))
        .map_err(SimError::file(format!("read {name} from Yosys")))
}

/// Gates by ABC's thorough script, which leaves out a fifth of those that its quick one has in Lyon's
/// core; look-up tables by the quick one, as `synth -lut 4` has them.
fn script(module: &str) -> String {
    let [gates, luts] = COUNTS;
    [
        "read_verilog core.v".to_owned(),
        format!("synth -flatten -noabc -top {module}"),
        "design -save logic".to_owned(),
        "abc -g NAND".to_owned(),
        "opt_clean".to_owned(),
        format!("tee -q -o {gates} stat"),
        "design -load logic".to_owned(),
        "abc -fast -lut 4".to_owned(),
        "opt_clean".to_owned(),
        format!("tee -q -o {luts} stat"),
    ]
    .join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gates_and_flip_flops_of_every_kind_count_apart() {
        let gates = "     $_DFFE_PP_                     14\n     $_DFF_P_                     2207\n     \
                     $_NAND_                     300\n     $_NOT_                        20\n     \
                     $_SDFF_PP0_                    59\n     $_SDFFE_PP0P_                   1\n";
        let luts = "     $_DFF_P_                     2207\n     16262  $lut\n";
        let expected = Logic { gates: 320, luts: 16262, flip_flops: 2281 };
        assert_eq!(Logic::counted(gates, luts), expected);
    }
}
