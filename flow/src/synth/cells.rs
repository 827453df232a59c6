//! Cells that a core takes.
use serde::Serialize;

use super::target::SynthTarget;

/// Cells of a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Cells {
    /// Look-up tables, those of carry chains included.
    pub luts: u64,
    /// Flip-flops.
    pub flip_flops: u64,
    /// Multiplier blocks.
    pub blocks: u64,
    /// Block RAMs.
    pub memories: u64,
}

impl Cells {
    /// Cells that Yosys's `stat` lists, a line for each kind with its number before or behind it,
    /// as versions of Yosys have it.
    pub fn listed(text: &str, target: &SynthTarget) -> Cells {
        let count = |kinds: &[(&str, u64)]| {
            kinds.iter().map(|(kind, each)| specula_sim::cells(text, kind) * each).sum()
        };
        Cells {
            luts: count(target.luts),
            flip_flops: count(target.flip_flops),
            blocks: count(target.blocks),
            memories: count(target.memories),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_counted_whichever_column_they_stand_in() {
        let older = "\n     CCU2C                        1060\n     LUT4                          472\n     \
                     MULT18X18D                     54\n     TRELLIS_FF                   3632\n";
        let newer =
            "     1060  CCU2C\n      472   LUT4\n       54   MULT18X18D\n     3632  TRELLIS_FF\n";
        let expected = Cells { luts: 2592, flip_flops: 3632, blocks: 54, memories: 0 };
        for text in [older, newer] {
            assert_eq!(Cells::listed(text, &SynthTarget::ECP5), expected);
        }
    }

    #[test]
    fn flip_flops_of_every_kind_count() {
        let text =
            "  SB_CARRY 7\n  SB_DFF 10\n  SB_DFFE 4\n  SB_DFFSR 2\n  SB_LUT4 30\n  SB_RAM40_4K 1\n";
        let expected = Cells { luts: 30, flip_flops: 16, blocks: 0, memories: 1 };
        assert_eq!(Cells::listed(text, &SynthTarget::ICE40_HX), expected);
    }
}
