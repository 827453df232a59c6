//! Unit vectors along the span.
use specula_spec::phong::Way;

use super::super::common::unit_vector;
use super::Pixel;
use super::lamp::Lamp;
use crate::error;
use crate::units::{
    self, ExactNormalisation, Interpolation, ReciprocalRoot, ToPlace, WrapFormats, WrappedPlace,
};
use specula_datapath::builder::{Sig, Vector};

/// A unit vector, and whether there is one.
pub(super) struct Direction {
    pub vector: Vector,
    pub exists: Sig,
    /// Of one that is wrapped.
    pub wrap: Option<Wrap>,
}

/// What a wrap around the axis of a spot says of the spot.
pub(super) struct Wrap {
    /// The cosine between the axis and the way from the spot.
    pub cosine: Sig,
    /// How strong the spot may be where rounding decides whether it is seen.
    pub most_at_edge: f64,
}

impl Direction {
    pub fn new(vector: Vector, exists: Sig) -> Direction {
        Direction { vector, exists, wrap: None }
    }
}

impl Pixel<'_> {
    /// L.
    pub(super) fn direction(&self, index: usize, lamp: &Lamp) -> Direction {
        let name = format!("light{index}");
        match (&lamp.light.way, &lamp.light.direction) {
            (Some(way), None) => self.to_place(&name, way, &lamp.spot),
            (None, Some(direction)) => self.at_infinity(direction),
            (Some(way), Some(direction)) => {
                let (near, far) =
                    (self.to_place(&name, way, &lamp.spot), self.at_infinity(direction));
                Direction {
                    vector: Vector::choose(&lamp.local, &near.vector, &far.vector),
                    exists: lamp.local.choose(&near.exists, &far.exists),
                    wrap: near.wrap,
                }
            }
            (None, None) => unreachable!("`PhongSpec::light_inputs` gives each light one of both"),
        }
    }

    fn at_infinity(&self, direction: &[Sig; 3]) -> Direction {
        let unit = 1.0 + self.phong.formats.vector.ulp();
        Direction::new(Vector::new(direction.clone()).no_longer_than(unit), self.b.integer(1))
    }

    /// A vector along the span, brought to unit length.
    pub(super) fn along(&self, name: &str, way: &Way<Sig>, shortest: f64) -> Direction {
        let (b, f) = (self.b, &self.phong.formats);
        let vector = self
            .interpolated(name, way, self.interpolation)
            .no_shorter_than(shortest, "no vector between two ends is shorter than in any span");
        let to = ExactNormalisation {
            length_squared_fraction_bits: f.length_squared.fraction_bits,
            reciprocal: self.reciprocal(),
            vector_fraction_bits: f.vector.fraction_bits,
        };
        let (vector, exists) =
            b.instance(&format!("{name}_normalise"), || units::normalise_exactly(b, &vector, to));
        Direction::new(vector, exists)
    }

    /// The direction to a place; `spot` says whether that of a spot.
    pub(super) fn to_place(&self, name: &str, way: &Way<Sig>, spot: &Sig) -> Direction {
        match &way.axis {
            Some(axis) => self.wrapped(name, way, axis, spot),
            None => self.along(name, way, self.parameters.shortest_way),
        }
    }

    fn wrapped(&self, name: &str, way: &Way<Sig>, axis: &[Sig; 3], spot: &Sig) -> Direction {
        let (b, f, shortest) = (self.b, &self.phong.formats, self.parameters.shortest_unit_way);
        let interpolation = Interpolation {
            longest: 2.0,
            apart: error::interpolate::chord(shortest),
            ..self.interpolation
        };
        let h = self.interpolated(name, way, interpolation);
        let axis = unit_vector(axis, f.vector);
        let formats =
            WrapFormats { operand: f.wrap_operand, ratio: f.wrap_ratio, vector: f.vector };
        let to = ToPlace { formats, cosine_bits: f.base.fraction_bits, shortest_way: shortest };
        let place =
            b.instance(&format!("{name}_wrapped"), || units::wrapped_place(b, &h, &axis, spot, to));
        let WrappedPlace { direction: vector, cosine, exists, most_at_edge } = place;
        Direction { vector, exists, wrap: Some(Wrap { cosine, most_at_edge }) }
    }

    fn interpolated(&self, name: &str, way: &Way<Sig>, to: Interpolation) -> Vector {
        let (b, along) = (self.b, format!("{name}_along"));
        let Some(weight) = &self.weight else {
            return self.forward.vector(&along, [&way.start, &way.delta], to.longest, to.vector);
        };
        let (start, delta) = (Vector::new(way.start.clone()), Vector::new(way.delta.clone()));
        b.instance(&along, || units::vector_between(b, &start, &delta, weight, to))
    }

    pub(super) fn reciprocal(&self) -> ReciprocalRoot {
        self.phong.formats.gain.into()
    }
}
