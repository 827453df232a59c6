//! Phong's core.
use specula_scene::CoreSpec;
use specula_scene::spec::phong::{Highlight, PhongInputs, PhongLight, PhongSpec, Way};

use super::{eye, finish};
use crate::builder::{Builder, Sig, TooWide, Vector};
use crate::design::Design;
use crate::units::{self, ExactNormalisation, Interpolation, Light, ReciprocalRoot};

/// Interpolated vectors, true normalisation, and for each light N·L and a power or a distribution. [lecture, eq. 2.1, 4.1, 4.2]
pub(super) fn core(b: Builder, spec: &CoreSpec, phong: &PhongSpec) -> Result<Design, TooWide> {
    let control = b.control();
    let inputs = phong.inputs(spec).map(|port| b.input(port));
    let f = &phong.formats;
    let interpolation = Interpolation {
        accumulator: f.weight_accumulator,
        weight: f.weight,
        vector: f.vector,
        longest: 1.0,
        apart: units::chord(spec.shortest_normal.min(spec.shortest_way)),
        steps: spec.longest_span - 1,
    };
    let weight = units::weight(&b, &control.start, &inputs.weight_step, interpolation);
    let pixel = Pixel { b: &b, spec, phong, interpolation, weight: &weight, shininess: &inputs.shininess };
    let lights = pixel.lights(&inputs);
    finish(&b, &control, &inputs.ambient, &lights)
}

/// What the vectors of a pixel have in common.
struct Pixel<'a> {
    b: &'a Builder,
    spec: &'a CoreSpec,
    phong: &'a PhongSpec,
    interpolation: Interpolation,
    weight: &'a Sig,
    shininess: &'a Sig,
}

/// A unit vector, and whether there is one.
struct Direction {
    vector: Vector,
    exists: Sig,
}

/// A light at the pixel.
struct Arrival<'a> {
    index: usize,
    light: &'a PhongLight<Sig>,
    direction: &'a Direction,
    view: &'a Direction,
    n_dot_v: &'a Sig,
    n_dot_l: Sig,
}

impl Pixel<'_> {
    fn lights(&self, inputs: &PhongInputs<Sig>) -> Vec<Light> {
        let b = self.b;
        let normal = self.along("normal", &inputs.normal, self.spec.shortest_normal);
        let view = match &inputs.eye {
            Some(way) => self.along("eye", way, self.spec.shortest_way),
            None => Direction { vector: eye(b), exists: b.integer(1) },
        };
        let n_dot_v = self.cosine("n_dot_v", &normal, &view);
        let shade = |(index, light): (usize, &PhongLight<Sig>)| {
            let direction = self.direction(index, light);
            let n_dot_l = self.cosine(&format!("light{index}_n_dot_l"), &normal, &direction);
            let arrival = Arrival { index, light, direction: &direction, view: &view, n_dot_v: &n_dot_v, n_dot_l };
            self.shade(&arrival, &normal.exists.and(&direction.exists))
        };
        inputs.lights.iter().enumerate().map(shade).collect()
    }

    /// A vector along the span, brought to unit length.
    fn along(&self, name: &str, way: &Way<Sig>, shortest: f64) -> Direction {
        let (b, f) = (self.b, &self.phong.formats);
        let (start, delta) = (Vector::new(way.start.clone()), Vector::new(way.delta.clone()));
        let interpolated = || units::along(b, &start, &delta, self.weight, self.interpolation);
        let vector = b.instance(&format!("{name}_along"), interpolated);
        let to = ExactNormalisation {
            length_squared_fraction_bits: f.length_squared.fraction_bits,
            reciprocal: self.reciprocal(),
            vector_fraction_bits: f.vector.fraction_bits,
        };
        let (vector, exists) = b.instance(&format!("{name}_normalise"), || units::normalise_exactly(b, &vector, to, shortest));
        Direction { vector, exists }
    }

    fn reciprocal(&self) -> ReciprocalRoot {
        self.phong.formats.gain.into()
    }

    fn direction(&self, index: usize, light: &PhongLight<Sig>) -> Direction {
        match (&light.way, &light.direction) {
            (Some(way), _) => self.along(&format!("light{index}"), way, self.spec.shortest_way),
            (None, Some(direction)) => {
                let unit = 1.0 + self.phong.formats.vector.ulp();
                Direction { vector: Vector::new(direction.clone()).no_longer_than(unit), exists: self.b.integer(1) }
            }
            (None, None) => unreachable!("`PhongSpec::inputs` gives each light one of both"),
        }
    }

    fn cosine(&self, name: &str, x: &Direction, y: &Direction) -> Sig {
        let fraction_bits = self.phong.formats.cosine.fraction_bits;
        self.b.instance(name, || units::cosine_between(self.b, &x.vector, &y.vector, fraction_bits))
    }

    fn shade(&self, at: &Arrival, lit: &Sig) -> Light {
        let zero = self.b.integer(0);
        let diffuse = at.n_dot_l.at_least_zero();
        let specular = at.view.exists.choose(&self.highlight(at), &zero);
        let [diffuse, specular] = self.spotted(at, [diffuse, specular]).map(|amount| lit.choose(&amount, &zero));
        Light {
            diffuse,
            specular,
            diffuse_coefficients: at.light.diffuse.clone(),
            specular_coefficients: at.light.specular.clone(),
        }
    }

    fn highlight(&self, at: &Arrival) -> Sig {
        let (b, f) = (self.b, &self.phong.formats);
        let called = |unit: &str| format!("light{}_{unit}", at.index);
        let base_bits = f.base.fraction_bits;
        let gain = || at.light.halfway_gain.clone().unwrap_or_else(|| self.halfway_gain(at));
        let base = match self.phong.highlight {
            Highlight::Reflection => {
                let l_dot_v = at.light.light_dot_view.clone().unwrap_or_else(|| self.l_dot_v(at));
                let base = || units::reflected_cosine(b, at.n_dot_v, &at.n_dot_l, &l_dot_v, base_bits);
                b.instance(&called("reflected_cosine"), base)
            }
            Highlight::Blinn | Highlight::TrowbridgeReitz => {
                let base = || units::halfway_cosine(b, at.n_dot_v, &at.n_dot_l, &gain(), base_bits);
                b.instance(&called("halfway_cosine"), base)
            }
            Highlight::TorranceSparrow => {
                let base = || units::halfway_versine(b, at.n_dot_v, &at.n_dot_l, &gain(), base_bits);
                b.instance(&called("halfway_versine"), base)
            }
        };
        let shape_bits = f.shape.fraction_bits;
        match self.phong.highlight {
            Highlight::Reflection | Highlight::Blinn => {
                b.instance(&called("power"), || units::any_power(b, &base, self.shininess, shape_bits))
            }
            Highlight::TorranceSparrow => {
                b.instance(&called("distribution"), || units::gaussian(b, &base, self.shininess, shape_bits))
            }
            Highlight::TrowbridgeReitz => {
                let distribution = || units::trowbridge_reitz(b, &base, self.shininess, base_bits, shape_bits);
                b.instance(&called("distribution"), distribution)
            }
        }
    }

    fn l_dot_v(&self, at: &Arrival) -> Sig {
        self.cosine(&format!("light{}_l_dot_v", at.index), at.direction, at.view)
    }

    fn halfway_gain(&self, at: &Arrival) -> Sig {
        let l_dot_v = self.l_dot_v(at);
        let bits = self.phong.formats.length_squared.fraction_bits;
        let gain = || units::halfway_gain(self.b, &l_dot_v, bits, self.reciprocal());
        self.b.instance(&format!("light{}_halfway_gain", at.index), gain)
    }

    /// What a spot leaves of a light.
    fn spotted(&self, at: &Arrival, amounts: [Sig; 2]) -> [Sig; 2] {
        let (b, f) = (self.b, &self.phong.formats);
        let called = |unit: &str| format!("light{}_{unit}", at.index);
        match (&at.light.axis, &at.light.exponent) {
            (Some(axis), Some(exponent)) => {
                let axis = Vector::new(axis.clone()).no_longer_than(1.0 + f.vector.ulp());
                let cosine = || units::spot_cosine(b, &at.direction.vector, &axis, f.base.fraction_bits);
                let cosine = b.instance(&called("spot_cosine"), cosine);
                let shape_bits = f.shape.fraction_bits;
                let share = b.instance(&called("spot"), || units::any_power(b, &cosine, exponent, shape_bits));
                amounts.map(|amount| (amount * &share).rounded(shape_bits))
            }
            _ => amounts,
        }
    }
}
