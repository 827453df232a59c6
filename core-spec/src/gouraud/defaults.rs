//! Options and formats of `gouraud`: defaults for a scene, and what may be asked for.
use specula_datapath::Format;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use super::{GouraudFormats, GouraudSpec, Interpolation};
use crate::defaults::span_bits;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::{NarrowingPoint, SIGNED_UNIT, UNIT};
use crate::shading_method::{OptionDomain, ShadingMethod, Viewpoint};

impl GouraudSpec {
    /// Options and their values.
    pub const OPTION_DOMAINS: &'static [OptionDomain] =
        &[OptionDomain { key: "interpolation", values: &["\"linear\"", "\"uniform\""] }];

    /// 12 fraction bits leave 0.03 LSB in each intensity. A step is off by half a unit in the last
    /// place, and so is S times that at the end of the span: log2 S + 1 more bits keep that within
    /// half a unit of the intensity's.
    pub fn for_needs(needs: &Needs) -> GouraudSpec {
        GouraudSpec {
            interpolation: Interpolation::Linear,
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
        vec![("interpolation", interpolation.to_owned())]
    }

    /// Intensities at the vertices are the host's work, wherever the light is.
    fn places_seen_from(&self) -> Viewpoint {
        Viewpoint::Vertex
    }

    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a> {
        Box::new(super::set_up::GouraudSetUp { gouraud: self, frame })
    }
}
