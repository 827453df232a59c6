//! What a frame makes use of, as far as the first cores ask: it decides widths and checks that a core fits.
use crate::frame::{Frame, Span};
use crate::spec::SpecError;

/// What shading this frame needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Needs {
    /// Number of lights.
    pub lights: usize,
    /// Pixels of the longest span.
    pub longest_span: u32,
    /// Largest exponent n of a material.
    pub largest_shininess: u32,
    /// A material whose exponent is no power of two, if there is one.
    pub uneven_shininess: Option<u32>,
    /// Largest product of a material's and a light's (or the ambient light's) colour component; 1.0 is full scale.
    pub brightest_coefficient: f64,
    /// Widest angle between the normals at the two ends of a span, in degrees.
    pub widest_angle: f64,
    /// Length of the shortest interpolated normal, in units of the longer end normal of its span; 0 to 1.
    pub shortest_normal: f64,
}

impl Needs {
    /// Works out the needs of a frame from every one of its spans.
    pub fn of(frame: &Frame) -> Needs {
        let used = || frame.spans.iter().map(|span| frame.material(span));
        let shininess = || used().map(|m| m.shininess);
        Needs {
            lights: frame.lights.len(),
            longest_span: frame.spans.iter().map(|s| s.length).max().unwrap_or(1),
            largest_shininess: shininess().max().unwrap_or(1),
            uneven_shininess: shininess().find(|n| !n.is_power_of_two()),
            brightest_coefficient: brightest_coefficient(frame),
            widest_angle: frame.spans.iter().map(|s| angle(frame, s)).fold(0.0, f64::max),
            shortest_normal: frame.spans.iter().map(|s| shortest(frame, s)).fold(1.0, f64::min),
        }
    }

    /// Whether a method can serve the materials that takes powers of two as exponents and nothing else.
    ///
    /// # Errors
    /// [`SpecError::UnevenShininess`] if not.
    pub(crate) fn power_of_two_shininess(&self, method: &'static str) -> Result<(), SpecError> {
        self.uneven_shininess.map_or(Ok(()), |shininess| {
            let above = shininess.next_power_of_two();
            Err(SpecError::UnevenShininess { method, shininess, below: above / 2, above })
        })
    }
}

fn brightest_coefficient(frame: &Frame) -> f64 {
    let mut brightest: f64 = 0.0;
    for material in &frame.materials {
        for channel in 0..3 {
            brightest = brightest.max(material.ambient[channel] * frame.ambient[channel]);
            for light in &frame.lights {
                let reflectance = material.diffuse[channel].max(material.specular[channel]);
                brightest = brightest.max(reflectance * light.colour[channel]);
            }
        }
    }
    brightest
}

fn angle(frame: &Frame, span: &Span) -> f64 {
    let [a, b] = frame.end_normals(span);
    // atan2 keeps small angles that acos of a rounded dot product loses (EXTREMES row 15).
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

/// Smallest |N| over the span: where the foot of the perpendicular from the origin falls on the segment between the ends.
fn shortest(frame: &Frame, span: &Span) -> f64 {
    let [a, b] = frame.end_normals(span);
    let delta = b - a;
    let foot = if delta.length_squared() > 0.0 { -a.dot(delta) / delta.length_squared() } else { 0.0 };
    (a + delta * foot.clamp(0.0, 1.0)).length()
}
