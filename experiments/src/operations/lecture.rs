//! The operation counts that the lecture prints, compared with the cores.
use specula_datapath::Design;
use specula_scene::{Frame, Needs};
use specula_spec::Method;

use super::{Contents, general_core};
use specula_testbench::BenchError;

/// A count that the lecture prints.
#[derive(Clone, Copy, Debug)]
pub struct Count {
    /// The section that prints it.
    pub section: &'static str,
    /// The quantity that is counted.
    pub what: &'static str,
    /// The printed text; in brackets what follows from the formulas, where nothing is printed.
    pub printed: &'static str,
    /// The method.
    pub method: Method,
    /// Its options.
    pub options: &'static str,
    /// The operations of the core.
    pub core: Contents,
}

/// Contents with this many accumulators, multipliers, dividers and units for 1/√.
const fn contents([accumulators, multipliers, dividers, reciprocal_roots]: [usize; 4]) -> Contents {
    Contents { accumulators, multipliers, dividers, reciprocal_roots, square_roots: 0 }
}

/// All counts.
pub const COUNTS: [Count; 5] = [
    Count {
        section: "3.1",
        what: "Gouraud shading",
        printed: "one addition for an intensity",
        method: Method::Gouraud,
        options: "",
        core: contents([2, 0, 0, 0]),
    },
    Count {
        section: "4.1",
        what: "naive Phong shading",
        printed: "three additions for N (and 10 ×, 7 ±, 3 ÷, √)",
        method: Method::Phong,
        options: "",
        core: contents([1, 13, 0, 1]),
    },
    Count {
        section: "4.2, 4.3",
        what: "fast Phong shading, one Newton step",
        printed: "(8 +, 1 −, 4 ×, 3 ÷)",
        method: Method::Direct,
        options: "direct.root = \"newton\"\ndirect.newton_steps = 1\n",
        core: contents([2, 7, 3, 0]),
    },
    Count {
        section: "4.4",
        what: "slerp of the normal",
        printed: "4 ± and 8 × for sines and cosines",
        method: Method::Slerp,
        options: "slerp.form = \"vector\"\nslerp.frame = \"ends\"\n",
        core: contents([4, 24, 0, 0]),
    },
    Count {
        section: "4.4",
        what: "slerp of N·L and N·V",
        printed: "the same",
        method: Method::Slerp,
        options: "",
        core: contents([2, 12, 0, 0]),
    },
];

impl Count {
    /// The general core for a frame.
    ///
    /// # Errors
    /// [`BenchError`] if it cannot be built for the frame.
    pub fn design(&self, frame: &Frame) -> Result<Design, BenchError> {
        general_core(&Needs::of(frame), self.method, self.options)
    }

    /// The operations of that core.
    ///
    /// # Errors
    /// As [`design`](Self::design).
    pub fn contents(&self, frame: &Frame) -> Result<Contents, BenchError> {
        Ok(Contents::of(&self.design(frame)?))
    }
}
