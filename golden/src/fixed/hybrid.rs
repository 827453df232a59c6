//! `hybrid`, bit for bit [Hast, Barrera and Bengtsson, eq. 17 to 26; methods C3;
//! `docs/arithmetic.md`].
use specula_spec::hybrid::{HybridFormats, HybridInputs, HybridLight, HybridSpan, HybridSpec};
use specula_spec::{CoreParameters, Format, Linear};

use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::quotient;
use super::method::{Intensities, Method};
use super::number::{Wide, round_to};
use super::observer::Observer;
use super::raised::Raised;
use super::span_extent::SpanExtent;
use super::spot::share_of;
use super::ways::Ways;

/// The method in one core's formats.
pub(super) struct Hybrid {
    power: Raised,
    ways: Ways,
    formats: HybridFormats,
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    i: u32,
    q: Wide,
    /// N·V; 0 where nobody asks.
    view: Wide,
    /// 1/√(E·E) of an eye at a place.
    eye: Option<Wide>,
    exponent: Wide,
}

impl Hybrid {
    pub fn new(core: &CoreParameters, hybrid: &HybridSpec) -> Hybrid {
        Hybrid {
            power: Raised::new(core, hybrid.power_unit()),
            ways: Ways::new(core, hybrid.ways()),
            formats: hybrid.formats.clone(),
        }
    }
}

impl Method for Hybrid {
    type Span = HybridSpan<Wide>;
    type Light = HybridLight<Wide>;
    type State = ();
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.diffuse, specular: self.power.format() }
    }

    fn check(&self, inputs: &HybridInputs<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        let f = &self.formats;
        extent.quadratic(
            format_args!("denominator"),
            &inputs.span.denominator,
            f.accumulator,
            (0, 1),
        )?;
        let span = &inputs.span;
        span.view
            .iter()
            .try_for_each(|view| self.ways.check_linear(format_args!("view"), view, extent))?;
        span.eye.iter().try_for_each(|eye| self.ways.check_eye(eye, extent))?;
        inputs.lights.iter().enumerate().try_for_each(|(index, light)| {
            let name = format_args!("light{index}_numerator");
            light.light.numerator.iter().try_for_each(|numerator| {
                extent.quadratic(name, numerator, f.accumulator, (-1, 1))
            })?;
            let way = light.light.way.as_ref();
            way.map_or(Ok(()), |way| self.ways.check_light(index, way, extent))?;
            let HybridLight { intensity_start: start, intensity_step: step, .. } = light.light;
            let intensity = Linear { start, step };
            extent.linear(
                format_args!("light{index}_intensity"),
                &intensity,
                f.diffuse_accumulator,
                (0, 1),
            )
        })
    }

    fn pixel(
        &self,
        span: &HybridSpan<Wide>,
        (): (),
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        let q = self.operand().quadratic(observer, "denominator", &span.denominator, i);
        let (view, eye) = match (&span.view, &span.eye) {
            (_, Some(eye)) => {
                let (view, root) = self.ways.eye(observer, eye, i);
                (view, Some(root))
            }
            (Some(view), None) => (self.ways.linear(observer, "view", view, i), None),
            (None, None) => (Wide::ZERO, None),
        };
        Pixel { i, q, view, eye, exponent: span.exponent }
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &HybridLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let way = light.way.as_ref();
        let arrived = way.map(|way| self.ways.light(observer, way, pixel.eye, pixel.i));
        let p = match (&light.numerator, &arrived) {
            (_, Some((cosine, arrival))) => {
                self.ways.reflected(observer, [pixel.view, *cosine], arrival.dot_view, pixel.q)
            }
            (Some(numerator), None) => {
                self.operand().quadratic(observer, "numerator", numerator, pixel.i)
            }
            // An input that is not there is 0.
            (None, None) => Wide::ZERO,
        };
        let base = quotient(observer, p, pixel.q, self.formats.base);
        let specular = self.power.raise(observer, base, pixel.exponent);
        Intensities {
            // What a spot leaves of the diffuse light is part of the vertices' intensities.
            diffuse: self.diffuse(light, pixel.i, observer),
            specular: arrived.map_or(specular, |(_, arrival)| {
                share_of(arrival.share, specular, self.power.format())
            }),
        }
    }
}

impl Hybrid {
    fn operand(&self) -> Accumulator {
        Accumulator { exact: self.formats.accumulator, rounded: self.formats.operand }
    }

    /// Gouraud's intensity, kept within 0 to 1.
    fn diffuse(&self, light: &HybridLight<Wide>, i: u32, observer: &mut impl Observer) -> Wide {
        let accumulated = light.intensity_start + Wide::from_num(i) * light.intensity_step;
        observer.see(
            format_args!("intensity_accumulator"),
            accumulated,
            self.formats.diffuse_accumulator,
        );
        let rounded = round_to(accumulated, self.formats.diffuse.fraction_bits);
        let diffuse = rounded.clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("diffuse"), diffuse, self.formats.diffuse);
        diffuse
    }
}
