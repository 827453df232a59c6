//! Measurements of one core.
use serde::{Deserialize, Serialize};
use specula_datapath::design::Size;
use specula_scene::LoadedScene;
use specula_spec::CoreSpec;

use super::cycles::FrameCycles;
use super::predicted::predicted_mhz;
use super::surface;
use specula_testbench::{Bench, BenchError, EngineKind, ErrorFigures, Errors};

/// The results of simulating all pixels with a core, and figures of its design.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Whether every pixel is the bit-true model's and leaves in its clock, every stated fact held,
    /// and no quantisation error is above its bound.
    pub agrees: bool,
    /// Errors against exact shading: total, of the method, and of quantisation.
    pub errors: Errors,
    /// Errors of the core's codes against exact shading with the true surface's normals, over the
    /// pixels of objects whose surface is known.
    pub surface: Option<ErrorFigures>,
    /// Proven bound on the quantisation error; `None` if there is no finite one.
    pub bound_lsb: Option<f64>,
    /// Clocks for the frame.
    pub cycles: FrameCycles,
    /// The clock, in MHz, that the target's delays predict; `None` of a core for any device.
    pub predicted_mhz: Option<f64>,
    /// The size of the core.
    pub size: Size,
}

impl Measured {
    /// Simulates the core of `spec` on all pixels of a scene.
    ///
    /// # Errors
    /// [`BenchError`] if the core cannot be built or run.
    pub fn new(scene: &LoadedScene, spec: &CoreSpec) -> Result<Measured, BenchError> {
        let bench = Bench::new(&scene.frame, spec, "core")?;
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ())?;
        let bound = bench.design.error_bound();
        Ok(Measured {
            agrees: outcome.agrees(),
            errors: outcome.comparison.errors.clone(),
            surface: surface::errors(scene, &outcome.simulated),
            bound_lsb: bound.is_finite().then_some(bound),
            cycles: FrameCycles::new(&bench.design, &scene.frame),
            predicted_mhz: predicted_mhz(spec, &bench.design),
            size: bench.design.size(),
        })
    }

    /// What is wrong, if not all of that holds.
    pub fn disagreement(&self) -> Option<String> {
        if self.agrees {
            return None;
        }
        let largest = self.errors.quantisation.max_lsb;
        let beyond = self.bound_lsb.filter(|&bound| largest > bound);
        let of_bound = |bound| {
            format!(
                "a quantisation error of {largest:.3} LSB, above the proven bound of {bound:.3}: the set-up or the bound is wrong"
            )
        };
        let otherwise =
            "pixels that are not the bit-true model's, or a stated fact that did not hold";
        Some(beyond.map_or_else(|| otherwise.to_owned(), of_bound))
    }

    /// Full adders of its arithmetic: one for each bit of an adder, and w1·w2 for a product of w1
    /// and w2 bits, as an array multiplier has. It is one number for multipliers and adders;
    /// registers and tables are not included.
    pub fn full_adders(&self) -> u64 {
        self.size.multiplier_bits + self.size.adder_bits
    }
}

#[cfg(test)]
mod tests {
    use specula_scene::load;
    use specula_spec::{Method, SceneCore};

    use super::*;

    #[test]
    fn an_error_above_its_bound_is_told_from_a_wrong_pixel() {
        let scene = load("spheres", Some((24, 18))).expect("it is built in");
        let spec = scene.core_spec(Some(Method::Gouraud)).expect("gouraud shades it");
        let right = Measured::new(&scene, &spec).expect("the core can be built");
        assert_eq!(right.disagreement(), None);
        let wrong = Measured { agrees: false, ..right.clone() };
        assert!(wrong.disagreement().is_some_and(|what| what.contains("bit-true model")));
        let beyond = Measured { bound_lsb: Some(0.25), ..wrong };
        let said = format!(
            "{:.3} LSB, above the proven bound of 0.250",
            right.errors.quantisation.max_lsb
        );
        assert!(beyond.disagreement().is_some_and(|what| what.contains(&said)), "{said}");
    }
}
