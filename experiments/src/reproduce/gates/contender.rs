//! The datapaths that are compared, each in the coarsest formats that keep to an error.
use specula_scene::{Frame, Needs};
use specula_spec::{CoreSpec, Method};
use specula_testbench::BenchError;

use crate::search::{Measured, NotFound, error_of_method, largest_error, narrowest_formats};
use crate::stress::variant::Variant;

/// A datapath.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contender {
    /// Its short name in tables.
    pub name: &'static str,
    /// Its formulas.
    pub what: &'static str,
    /// The method whose core it is.
    pub method: Method,
    /// The method's options, as lines of its table in a scene file.
    pub table: &'static str,
}

/// Standard Phong shading first, with which the others are compared.
pub const CONTENDERS: [Contender; 4] = [
    Contender {
        name: "Phong",
        what: "N normalised by an exact reciprocal root, (R·L)^n by tables of logarithms and powers",
        method: Method::Phong,
        table: "highlight = \"reflection\"\n",
    },
    Contender {
        name: "Lyon, figures 6 and 7",
        what: "N near unit length by g2, D = R − L, x = (n/2) D·D, f_2",
        method: Method::Lyon,
        table: "difference = \"reflection-minus-light\"\nnormalisation = \"g2\"\n\
                newton_steps = 0\nshape = \"f-k\"\nsquarings = 2\n",
    },
    Contender {
        name: "Lyon, figure 8",
        what: "the same with x = mD·mD/2, m = √n, f_1",
        method: Method::Lyon,
        table: "difference = \"reflection-minus-light\"\nnormalisation = \"g2\"\n\
                newton_steps = 0\nshape = \"root\"\nsquarings = 1\n",
    },
    Contender {
        name: "Lyon with H × N",
        what: "figures 6 and 7 with D = H × N (this project's)",
        method: Method::Lyon,
        table: "difference = \"halfway-cross-normal\"\nnormalisation = \"g2\"\n\
                newton_steps = 0\nshape = \"f-k\"\nsquarings = 2\n",
    },
];

/// A core in the coarsest formats that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct EqualCore {
    /// The core, for any scene with the same ranges.
    pub spec: CoreSpec,
    /// Largest error of the datapath in exact arithmetic against exact Phong shading, in LSBs: what
    /// it changes in the picture by design.
    pub method_lsb: f64,
    /// Largest error of the core against the datapath in exact arithmetic, in LSBs.
    pub quantisation_lsb: f64,
}

impl Contender {
    /// The core in the coarsest formats that keep its quantisation error within `most` LSBs at every
    /// pixel of a frame.
    ///
    /// # Errors
    /// [`BenchError`] if no core can be built for the frame; the inner error if no formats that were
    /// tried keep the error.
    pub fn core(
        &self,
        frame: &Frame,
        most: f64,
    ) -> Result<Result<EqualCore, NotFound>, BenchError> {
        let variant = Variant { method: self.method, table: self.table.to_owned() };
        let start = variant.core_spec(&Needs::of(frame))?;
        let spec = match narrowest_formats(&start, frame, (Measured::Quantisation, most))? {
            Ok(spec) => spec,
            Err(not_found) => return Ok(Err(not_found)),
        };
        let method_lsb = error_of_method(&spec, frame);
        let quantisation_lsb = largest_error(&spec, frame)?;
        Ok(Ok(EqualCore { spec, method_lsb, quantisation_lsb }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every datapath keeps to the error, and none in formats that are finer than needed: with a bit
    /// fewer at every narrowing point it does not.
    #[test]
    fn cores_quantise_equally_well_and_no_better() {
        let frame = specula_scene::load("icosahedron", Some((24, 18))).unwrap().frame;
        for contender in &CONTENDERS {
            let found = contender.core(&frame, 1.0).unwrap().unwrap();
            assert!(found.quantisation_lsb <= 1.0, "{}: {found:?}", contender.name);
            let coarser = found.spec.finer(-1, &[]).unwrap();
            assert!(largest_error(&coarser, &frame).unwrap() > 1.0, "{}", contender.name);
        }
    }

    /// What Lyon changes by design, the shape of the highlight, is not Phong's to the last bit; what
    /// standard Phong shading computes is.
    #[test]
    fn only_standard_phong_shading_is_exact_by_design() {
        let frame = specula_scene::load("icosahedron", Some((48, 36))).unwrap().frame;
        let errors =
            CONTENDERS.map(|contender| contender.core(&frame, 4.0).unwrap().unwrap().method_lsb);
        assert!(errors[0] < 1e-6 && errors[1..].iter().all(|&error| error > 1.0), "{errors:?}");
    }
}
