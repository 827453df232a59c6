//! Limits of a core's difference from exact shading: the rounding of its formats, and its method's
//! documented error.
//!
//! Each law is the paper's, or docs/numerics.md's, and applies to a pixel of a span: it is geometry
//! alone, not the method's own arithmetic. `docs/extremes.md` describes the laws
//! ([`Reason::text`]).
mod directions;
mod highlight;
mod lobe;
mod normal;
mod reason;

use glam::DVec3;
use specula_golden::exact::formula::reflection::reflect;
use specula_golden::exact::formula::shape::{f_k, power};
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};
use specula_spec::consistent::{Diffuse, LARGEST_GAIN_BITS};
use specula_spec::direct::Root;
use specula_spec::gouraud::{GouraudSpec, Highlight, Interpolation};
use specula_spec::lyon::Difference;
use specula_spec::phong::Places;
use specula_spec::{
    CoreSpec, FULL_SCALE, LyonSpec, MethodSpec, Viewpoint, consistent, duff, phong, reflection,
};

use directions::{Direction, Directions};
use highlight::Lobe;
use lobe::{chord, power_change, power_turn_change, shape_change, shape_error};
use normal::{Normal, Pixel};
pub use reason::Reason;

/// Errors up to this many LSBs need no reason: half an LSB is the rounding to 8 bits.
pub const EXACT: f64 = 1.0;

/// A normal shorter than this has no direction.
const NO_LENGTH: f64 = 1e-6;
/// Nothing is promised about normals shorter than this unless there is a proven bound: they occur
/// in spans of more than 120 degrees.
const SHORT: f64 = 0.5;

/// The error with recommended formats where there is no proven bound: 1 LSB before the rounding to
/// 8 bits [numerics N5].
const UNPROVEN: f64 = 1.5;
/// The same error for exponents above [`TYPICAL_EXPONENT`], which are outside the range that
/// docs/numerics.md calls typical: formats have at most 22 fraction bits.
const UNPROVEN_SHARP: f64 = 2.0;
const TYPICAL_EXPONENT: u32 = 256;

/// The error that one pixel may have.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The limit in LSBs, for each channel.
    pub lsb: [f64; 3],
    /// The reasons why it is more than [`EXACT`].
    pub reasons: Vec<Reason>,
}

/// The error that the formats of a core may cause.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rounding {
    /// The proven bound in LSBs; 255 or more means that there is none.
    pub bound: f64,
    /// The row's limit for a core without a bound.
    pub figure: Option<f64>,
}

/// Limits along a span.
pub struct Limits<'a> {
    spec: &'a CoreSpec,
    frame: &'a Frame,
    span: &'a Span,
    rounding: Rounding,
    /// Largest difference between f_k and the power, if the method has f_k.
    shape: f64,
    /// Accumulated quantities at each pixel, for methods that depend on the previous pixel:
    /// [`normal::lags`] of chained normals, [`normal::roots`] of Newton's.
    accumulated: Vec<f64>,
}

/// Errors of a light's share, each 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct ShareErrors {
    diffuse: f64,
    specular: f64,
}

const ALL: ShareErrors = ShareErrors { diffuse: 1.0, specular: 1.0 };

impl<'a> Limits<'a> {
    /// The limits along a span.
    pub fn new(
        spec: &'a CoreSpec,
        frame: &'a Frame,
        span: &'a Span,
        rounding: Rounding,
    ) -> Limits<'a> {
        let n = frame.material(span).shininess;
        let (shape, accumulated) = match &spec.method {
            MethodSpec::Lyon(lyon) => {
                (shape_error(n, lyon.terms()), normal::lags(frame, span, lyon))
            }
            MethodSpec::Gouraud(gouraud) if gouraud.highlight == Highlight::FK => {
                (shape_error(n, 1 << gouraud.squarings), Vec::new())
            }
            MethodSpec::Direct(direct) if direct.root == Root::Newton => {
                (0.0, normal::roots(frame, span, direct.newton_steps))
            }
            _ => (0.0, Vec::new()),
        };
        Limits { spec, frame, span, rounding, shape, accumulated }
    }

    /// The limit at pixel `i`.
    pub fn at_pixel(&self, i: u32) -> Limit {
        let normal = self.frame.normal_at(self.span, self.span.weights(i));
        let lights = self.frame.light_colours().count();
        let mut reasons = Vec::new();
        let offs = match normal.try_normalize().filter(|_| normal.length() > NO_LENGTH) {
            Some(truth) => self.light_errors(i, truth, &mut reasons),
            None => {
                reasons.push(Reason::NoNormal);
                vec![ALL; lights]
            }
        };
        let rounding = self.rounding(i, &mut reasons);
        let material = self.frame.material(self.span);
        let of_light = |off: &ShareErrors, colour: f64, c: usize| {
            colour
                * (material.diffuse[c] * off.diffuse.min(1.0)
                    + material.specular[c] * off.specular.min(1.0))
        };
        let of_channel = |c: usize| {
            let off: f64 = offs
                .iter()
                .zip(self.frame.light_colours())
                .map(|(off, colour)| of_light(off, colour[c], c))
                .sum();
            (rounding + FULL_SCALE * off).min(FULL_SCALE)
        };
        reasons.sort_unstable();
        reasons.dedup();
        Limit { lsb: std::array::from_fn(of_channel), reasons }
    }

    /// The error that formats may cause at pixel `i`, in LSBs.
    fn rounding(&self, i: u32, reasons: &mut Vec<Reason>) -> f64 {
        let Rounding { bound, figure } = self.rounding;
        if bound < FULL_SCALE {
            reasons.extend((bound > EXACT).then_some(Reason::Rounding));
            return bound.max(EXACT);
        }
        if let Some(figure) = figure {
            reasons.push(Reason::ShortFormats);
            return figure;
        }
        let pixel = self.pixel(i, DVec3::ZERO);
        if pixel.chord().length().min(pixel.interpolated().length()) < SHORT {
            reasons.push(Reason::ShortNormal);
            return FULL_SCALE;
        }
        reasons.push(Reason::NoBound);
        if self.exponent() > TYPICAL_EXPONENT { UNPROVEN_SHARP } else { UNPROVEN }
    }

    fn pixel(&self, i: u32, truth: DVec3) -> Pixel<'_> {
        Pixel { frame: self.frame, span: self.span, i, truth, accumulated: &self.accumulated }
    }

    /// The errors of each light at a pixel that has a normal.
    fn light_errors(&self, i: u32, truth: DVec3, reasons: &mut Vec<Reason>) -> Vec<ShareErrors> {
        let pixel = self.pixel(i, truth);
        let directions = self.directions(i, reasons);
        let lobe = self.lobe(&pixel, reasons);
        let one = |(light, direction): (usize, &Direction)| {
            let Direction::Known { turn, share } = *direction else { return ALL };
            let Direction::Known { turn: turn_of_view, .. } = directions.view else { return ALL };
            let here = self.errors(&pixel, light, reasons);
            let n = self.n();
            let towards = self.frame.lights.get(light).map_or(EYE, |light| light.direction);
            let specular = lobe.difference(n, truth, towards).map_or(1.0, |off| {
                off + here.specular + power_turn_change(turn + turn_of_view, n) + share
            });
            ShareErrors { diffuse: here.diffuse + chord(turn) + share, specular }
        };
        directions.lights.iter().enumerate().map(one).collect()
    }

    /// The exponent of the highlight's base: n, or 4n for the half-way vector.
    fn exponent(&self) -> u32 {
        let is_by_halfway = match &self.spec.method {
            MethodSpec::Phong(spec) => spec.highlight != phong::Highlight::Reflection,
            MethodSpec::Duff(spec) => spec.specular == duff::Highlight::Blinn,
            MethodSpec::Reflection(spec) => spec.specular == reflection::Highlight::Blinn,
            MethodSpec::Consistent(spec) => spec.highlight == consistent::Highlight::Blinn,
            MethodSpec::Lyon(_)
            | MethodSpec::Hybrid(_)
            | MethodSpec::Gouraud(_)
            | MethodSpec::Slerp(_)
            | MethodSpec::Direct(_) => false,
        };
        if is_by_halfway { 4 * self.n() } else { self.n() }
    }

    fn n(&self) -> u32 {
        self.frame.material(self.span).shininess
    }

    /// The method's directions to lights and eye.
    fn directions(&self, i: u32, reasons: &mut Vec<Reason>) -> Directions {
        if self.frame.directions_are_constant() {
            return Directions::exact(self.frame, self.span, i);
        }
        if self.frame.local_lights.iter().any(|light| light.attenuation.is_some()) {
            reasons.push(Reason::Attenuation);
        }
        match (&self.spec.method, self.spec.places_seen_from()) {
            (MethodSpec::Phong(phong), _) if phong.places == Places::Wrapped => {
                reasons.push(Reason::WrappedPlaces);
                Directions::wrapped(self.frame, self.span, i)
            }
            (_, Viewpoint::Span) => {
                reasons.push(Reason::Middle);
                Directions::of_the_middle(self.frame, self.span, i)
            }
            // What Gouraud's vertices see is part of that method's own limits.
            (_, Viewpoint::Pixel | Viewpoint::Vertex) => {
                Directions::exact(self.frame, self.span, i)
            }
        }
    }

    /// The highlight that the method is defined to have, for some normal.
    fn lobe(&self, pixel: &Pixel, reasons: &mut Vec<Reason>) -> Lobe {
        let blinn_if = |is_blinns| if is_blinns { Lobe::BLINN } else { Lobe::Phong };
        let lobe = match &self.spec.method {
            MethodSpec::Lyon(lyon) => Lobe::of_lyon(lyon),
            MethodSpec::Phong(phong) => Lobe::of_phong(phong.highlight),
            MethodSpec::Duff(duff) => blinn_if(duff.specular == duff::Highlight::Blinn),
            MethodSpec::Reflection(spec) => blinn_if(spec.specular == reflection::Highlight::Blinn),
            MethodSpec::Consistent(_) if !self.is_flat_around(pixel) => {
                reasons.push(Reason::Consistent);
                return Lobe::Unknown;
            }
            MethodSpec::Consistent(spec) => {
                blinn_if(spec.highlight == consistent::Highlight::Blinn)
            }
            MethodSpec::Gouraud(_)
            | MethodSpec::Hybrid(_)
            | MethodSpec::Slerp(_)
            | MethodSpec::Direct(_) => Lobe::Phong,
        };
        reasons.extend((lobe != Lobe::Phong).then_some(Reason::Lobe));
        // The law of other lobes holds only for directions that are constant.
        if lobe == Lobe::Phong || self.frame.directions_are_constant() {
            lobe
        } else {
            Lobe::Unknown
        }
    }

    /// Whether consistent normals equal the plain ones: the normals of all faces around the
    /// triangle's vertices are the vertices' own.
    fn is_flat_around(&self, pixel: &Pixel) -> bool {
        self.frame.triangles[pixel.span.triangle].cones.iter().all(|cone| cone.cosine >= 1.0)
    }

    /// The error of light number `light` caused by the method's normals, or by what replaces them.
    fn errors(&self, pixel: &Pixel, light: usize, reasons: &mut Vec<Reason>) -> ShareErrors {
        match &self.spec.method {
            MethodSpec::Lyon(lyon) => self.of_lyon(lyon, &pixel.of_lyon(lyon), reasons),
            MethodSpec::Phong(_) | MethodSpec::Duff(_) => ShareErrors::default(),
            MethodSpec::Hybrid(_) => {
                ShareErrors { diffuse: self.gouraud(pixel, light, reasons), specular: 0.0 }
            }
            // There is no law for places as seen from the vertices, or from the polygon's middle.
            MethodSpec::Gouraud(_) if !self.frame.directions_are_constant() => {
                reasons.push(Reason::Vertices);
                ALL
            }
            MethodSpec::Gouraud(gouraud) if gouraud.interpolation == Interpolation::Linear => {
                ShareErrors {
                    diffuse: self.gouraud(pixel, light, reasons),
                    specular: self.highlight_of_vertices(gouraud, pixel, light, reasons),
                }
            }
            MethodSpec::Gouraud(_) => {
                let off = self.of_normal(&pixel.of_facet(), reasons);
                reasons.extend((self.shape > NO_LENGTH).then_some(Reason::Shape));
                ShareErrors { specular: off.specular + self.shape, ..off }
            }
            MethodSpec::Reflection(spec) => {
                let off = self.of_normal(&pixel.of_reflection(spec), reasons);
                // The hybrid's highlight uses the interpolated normal.
                ShareErrors {
                    specular: if spec.specular == reflection::Highlight::Hybrid {
                        0.0
                    } else {
                        off.specular
                    },
                    ..off
                }
            }
            MethodSpec::Consistent(spec) => {
                let off = self.of_normal(&self.of_consistent(pixel), reasons);
                let is_lambert = spec.diffuse == Diffuse::Lambert || self.is_flat_around(pixel);
                reasons.extend((!is_lambert).then_some(Reason::Consistent));
                ShareErrors { diffuse: if is_lambert { off.diffuse } else { 1.0 }, ..off }
            }
            MethodSpec::Slerp(slerp) => self.of_normal(&pixel.of_slerp(slerp), reasons),
            MethodSpec::Direct(direct) => {
                let off = self.of_normal(&pixel.between_unit_ends(), reasons);
                let too_long = if direct.root == Root::Newton { pixel.accumulated() } else { 0.0 };
                reasons.extend((too_long > NO_LENGTH).then_some(Reason::Newton));
                ShareErrors { diffuse: off.diffuse + too_long / (1.0 + too_long), ..off }
            }
        }
    }

    fn of_consistent(&self, pixel: &Pixel) -> Normal {
        let shortest = 0.5_f64.powi(LARGEST_GAIN_BITS.cast_signed());
        if pixel.interpolated().length() < shortest {
            Normal::unknown(Reason::Consistent)
        } else {
            pixel.between_axes()
        }
    }

    /// The errors of p/q and of the power for a normal that is turned or too short.
    fn of_normal(&self, normal: &Normal, reasons: &mut Vec<Reason>) -> ShareErrors {
        let short = 1.0 - normal.length;
        let Some(turn) = normal.turn else {
            reasons.extend(&normal.reasons);
            return ALL;
        };
        if turn > NO_LENGTH || short > 0.0 {
            reasons.extend(&normal.reasons);
        }
        let base = 2.0 * (1.0 - normal.length * normal.length);
        ShareErrors {
            diffuse: chord(turn) + short,
            specular: power_turn_change(2.0 * turn, self.n()) + power_change(base, self.n()),
        }
    }

    /// The same errors for Lyon's D, which a turn of the normal moves by at most twice as much.
    fn of_lyon(&self, lyon: &LyonSpec, normal: &Normal, reasons: &mut Vec<Reason>) -> ShareErrors {
        let is_reflected = matches!(
            lyon.difference,
            Difference::ReflectionMinusLight | Difference::LightReflection
        );
        let short = (1.0 - normal.length * normal.length).abs();
        let Some(turn) = normal.turn else {
            reasons.extend(&normal.reasons);
            return ALL;
        };
        if turn > NO_LENGTH || short > NO_LENGTH {
            reasons.extend(&normal.reasons);
        }
        let shape = if is_reflected { self.shape } else { 0.0 };
        reasons.extend((shape > NO_LENGTH).then_some(Reason::Shape));
        ShareErrors {
            diffuse: chord(turn) + (1.0 - normal.length).abs(),
            specular: shape + shape_change(2.0 * chord(turn) + 2.0 * short, self.n()),
        }
    }

    /// The difference between the vertices' interpolated Lambert cosines and that of the normal.
    fn gouraud(&self, pixel: &Pixel, light: usize, reasons: &mut Vec<Reason>) -> f64 {
        let Some(light) = self.light(light) else {
            reasons.push(Reason::Vertices);
            return 1.0;
        };
        let (normals, weights) =
            (&self.frame.triangles[self.span.triangle].normals, self.span.weights(pixel.i));
        let interpolated: DVec3 =
            normals.iter().zip(weights).map(|(normal, weight)| weight * *normal).sum();
        let dark: f64 = normals
            .iter()
            .zip(weights)
            .map(|(normal, weight)| weight.abs() * (-normal.dot(light)).max(0.0))
            .sum();
        reasons.push(Reason::GouraudDiffuse);
        (1.0 - interpolated.length()).max(0.0) + dark
    }

    /// The difference between the vertices' interpolated highlights and that of the normal, under
    /// lights at infinity.
    fn highlight_of_vertices(
        &self,
        gouraud: &GouraudSpec,
        pixel: &Pixel,
        light: usize,
        reasons: &mut Vec<Reason>,
    ) -> f64 {
        let Some(light) = self.light(light) else { return 1.0 };
        let of_power = |normal: DVec3| power(reflect(normal).dot(light).min(1.0), self.n());
        let of_shape = |normal: DVec3| {
            let square = (reflect(normal) - light).length_squared();
            f_k(f64::from(self.n()) / 2.0 * square, gouraud.squarings)
        };
        let highlight = |normal: DVec3| match (normal, gouraud.highlight) {
            (DVec3::ZERO, _) => 0.0,
            (_, Highlight::Power) => of_power(normal),
            (_, Highlight::FK) => of_shape(normal),
        };
        let (normals, weights) =
            (&self.frame.triangles[self.span.triangle].normals, self.span.weights(pixel.i));
        let of_vertices: f64 =
            normals.iter().zip(weights).map(|(&normal, weight)| weight * highlight(normal)).sum();
        reasons.push(Reason::Vertices);
        (of_vertices.clamp(0.0, 1.0) - of_power(pixel.truth)).abs()
    }

    /// The direction to a light that Gouraud's vertices use: for lights at places, that of the
    /// span's middle with `hybrid`, and none common to all vertices with `gouraud`.
    fn light(&self, light: usize) -> Option<DVec3> {
        if let Some(light) = self.frame.lights.get(light) {
            return Some(light.direction);
        }
        let position = self.frame.position_at(self.span, self.span.middle());
        let of_the_middle = self.spec.places_seen_from() == Viewpoint::Span;
        self.frame
            .lights_from(position)
            .nth(light)
            .flatten()
            .filter(|_| of_the_middle)
            .map(|light| light.direction)
    }
}
