//! Options and formats of `gouraud`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{GouraudFormats, GouraudSpec, Highlight, Interpolation, default_squarings};
use crate::defaults::span_bits;
use crate::error::{SpecError, within};
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{NarrowingPoint, SIGNED_UNIT, UNIT};
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};

impl GouraudSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] = &[
        OptionDomain { key: "interpolation", values: &["\"linear\"", "\"uniform\""] },
        OptionDomain { key: "highlight", values: &["\"power\"", "\"f-k\""] },
        OptionDomain { key: "squarings", values: &["0", "1", "2", "3", "4"] },
    ];

    /// 12 fraction bits leave 0.03 LSB in each intensity. A step is off by half a unit in the last
    /// place, and so is S times that at the end of the span: log2 S + 1 more bits keep that within
    /// half a unit of the intensity's.
    pub fn for_needs(needs: &Needs) -> GouraudSpec {
        GouraudSpec {
            interpolation: Interpolation::Linear,
            highlight: Highlight::Power,
            squarings: default_squarings(),
            formats: GouraudFormats {
                accumulator: Format::signed(1, 12 + span_bits(needs.longest_span) + 1),
                intensity: Format::unsigned(1, 12),
            },
        }
    }
}

impl ShadingMethod for GouraudSpec {
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint> {
        // Taken apart, so that a format that is new there cannot be forgotten here.
        let &GouraudFormats { accumulator, intensity } = &self.formats;
        let sums = "start and step of the intensities, rounded by the host";
        match self.interpolation {
            Interpolation::Linear => vec![
                NarrowingPoint::accumulated(
                    "accumulator",
                    accumulator,
                    SIGNED_UNIT,
                    (1, span_bits),
                    sums,
                ),
                NarrowingPoint::rounded(
                    "intensity",
                    intensity,
                    UNIT,
                    "diffuse and specular intensity, clamped to 0..1",
                )
                .no_finer_than(accumulator),
            ],
            Interpolation::Uniform => {
                vec![NarrowingPoint::rounded(
                    "intensity",
                    intensity,
                    UNIT,
                    "diffuse and specular intensity, rounded by the host",
                )]
            }
        }
    }

    fn options(&self) -> Vec<(&'static str, String)> {
        let interpolation = match self.interpolation {
            Interpolation::Linear => "linear, from the vertices",
            Interpolation::Uniform => "none: uniform over each polygon",
        };
        let mut options = vec![("interpolation", interpolation.to_owned())];
        if self.highlight == Highlight::FK {
            let factors = 1_u32 << self.squarings;
            let shape = format!("(1 - n D.D/{})^{factors} of D = R - L, by the host", 2 * factors);
            options.push(("highlight", shape));
        }
        options
    }

    fn check_options(&self) -> Result<(), SpecError> {
        within("squarings", self.squarings.into(), 0.0, 4.0)
    }

    /// Intensities at the vertices are the host's work, wherever the light is.
    fn places_seen_from(&self) -> Viewpoint {
        Viewpoint::Vertex
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::GouraudSetUp { gouraud: self, frame })
    }
}
