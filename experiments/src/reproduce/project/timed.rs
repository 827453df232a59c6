//! A model, timed.
use specula_golden::loops::software::{Method, by_name};
use specula_scene::SceneError;

use super::ALGORITHMS;
use super::model::{Illumination, Model};
use crate::tradeoff::software::{Software, TimingExtent, measure_loops};

/// The measurements of a model under one illumination.
#[derive(Clone, Debug, PartialEq)]
pub struct Timed {
    /// The model's name.
    pub model: String,
    /// Where light and eye are.
    pub illumination: Illumination,
    /// Number of visible triangles.
    pub triangles: usize,
    /// Number of spans.
    pub spans: usize,
    /// Number of shaded pixels.
    pub pixels: u64,
    /// Each algorithm's title, with its loop's measurements.
    pub rows: Vec<(&'static str, Software)>,
}

/// Times every algorithm on a model in one run, in a picture of `size` pixels.
///
/// # Errors
/// [`SceneError`] if none of the model's triangles can be seen.
pub fn timed(
    model: &Model,
    size: (u32, u32),
    illumination: Illumination,
    extent: TimingExtent,
) -> Result<Timed, SceneError> {
    let frame = model.frame(size, illumination)?;
    let loops = loops(illumination);
    let methods: Vec<Method> = loops.iter().map(|(_, method)| *method).collect();
    let measured = measure_loops(&methods, &frame, extent, &mut || ());
    Ok(Timed {
        model: model.name.clone(),
        illumination,
        triangles: frame.triangles.len(),
        spans: frame.spans.len(),
        pixels: frame.shaded_pixels(),
        rows: loops.iter().map(|(title, _)| *title).zip(measured).collect(),
    })
}

/// The loops of the algorithms that are of use under an illumination.
fn loops(illumination: Illumination) -> Vec<(&'static str, Method)> {
    let name = |algorithm: &super::Algorithm| match illumination {
        Illumination::Infinity => algorithm.at_infinity,
        Illumination::Places => Some(algorithm.at_places),
    };
    let all = ALGORITHMS.iter();
    all.filter_map(|algorithm| Some((algorithm.title, by_name(name(algorithm)?)?))).collect()
}

impl Timed {
    /// The measurements of a loop, by its name.
    pub fn of(&self, name: &str) -> Option<&Software> {
        self.rows.iter().map(|(_, row)| row).find(|row| row.name == name)
    }

    /// The measurements of naive Phong shading.
    pub fn naive(&self) -> Option<&Software> {
        self.of(match self.illumination {
            Illumination::Infinity => "phong",
            Illumination::Places => "phong-places",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHORT: TimingExtent = TimingExtent { rounds: 1, pixels: 1 };

    /// Every loop runs for every model, and is off by no more than its method: each is measured
    /// here against exact shading, at infinity and at places.
    #[test]
    fn every_loop_shades_every_model() {
        let models = [Model::teapot(), Model::torus(), Model::stand_in().unwrap()];
        for (model, illumination) in
            models.iter().flat_map(|model| Illumination::ALL.map(|place| (model, place)))
        {
            let timed = timed(model, (160, 120), illumination, SHORT).unwrap();
            let expected = ALGORITHMS.len() - usize::from(illumination == Illumination::Infinity);
            assert_eq!(timed.rows.len(), expected, "{}", model.name);
            for (title, row) in &timed.rows {
                let most = most(row.name, illumination);
                assert!(
                    row.error.rms_lsb < most && row.error.max_lsb.is_finite(),
                    "{title} on the {} {}: {:?}",
                    model.name,
                    illumination.name(),
                    row.error
                );
            }
        }
    }

    /// The root mean square in LSB that a loop may be off: roundings for what is Phong's formula, an
    /// arc or a wrap for what is nearly that, and what intensities of vertices or consistent normals
    /// are off by on coarse triangles; at places, what directions turn by from the middle of a span.
    fn most(name: &str, illumination: Illumination) -> f64 {
        match (name, illumination) {
            ("phong" | "phong-places" | "phong-wrapped-places", _)
            | ("duff" | "fast-phong", Illumination::Infinity) => 0.05,
            ("slerp" | "reflection", Illumination::Infinity) => 0.3,
            ("gouraud" | "hybrid" | "consistent" | "consistent-trigonometric", _) => 4.0,
            ("consistent-normal", _) => 10.0,
            _ => 1.5,
        }
    }
}
