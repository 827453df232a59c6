//! Kinds of netlists and of runs.

/// What a drawn netlist is like.
#[derive(Clone, Copy, Debug)]
pub struct Profile {
    /// Signals beside control and inputs, more or less.
    pub signals: usize,
    /// Units beside the core.
    pub units: usize,
    /// Spans, and pixels of the longest.
    pub spans: usize,
    pub longest: u32,
    /// Registers that read later signals.
    pub feedback: bool,
    /// For a Verilog simulator: registers that are loaded often, nothing that a linter takes for a
    /// mistake.
    pub verilog: bool,
}

impl Profile {
    pub fn small(number: u64) -> Profile {
        let signals = 5 + (number as usize * 7) % 36;
        Profile {
            signals,
            units: number as usize % 4,
            spans: 1 + number as usize % 9,
            longest: 6,
            feedback: true,
            verilog: false,
        }
    }

    pub fn large(number: u64) -> Profile {
        let signals = 200 + (number as usize * 37) % 401;
        Profile {
            signals,
            units: number as usize % 9,
            spans: 10,
            longest: 8,
            feedback: !number.is_multiple_of(3),
            verilog: false,
        }
    }

    pub fn long(number: u64) -> Profile {
        let signals = 10 + (number as usize * 7) % 50;
        let units = number as usize % 3;
        Profile { signals, units, spans: 30, longest: 150, feedback: true, verilog: false }
    }

    pub fn verilog() -> Profile {
        Profile { signals: 500, units: 9, spans: 60, longest: 4, feedback: true, verilog: true }
    }
}
