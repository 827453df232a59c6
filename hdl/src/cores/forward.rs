//! What goes along a span by additions.
use specula_spec::{Format, Linear, Quadratic};

use crate::error;
use crate::units::{self, Differences, Steps};
use specula_datapath::builder::{Builder, Sig, Vector};

/// A core's spans.
#[derive(Clone, Copy)]
pub(super) struct Forward<'a> {
    pub b: &'a Builder,
    /// 1 at the first pixel of a span.
    pub first: &'a Sig,
    /// Steps of the longest span.
    pub steps: u32,
}

impl Forward<'_> {
    /// What is linear along a span, from -1 to 1, rounded.
    pub fn linear(&self, instance: &str, linear: &Linear<Sig>, fraction_bits: u32) -> Sig {
        let of = Steps { start: &linear.start, step: &linear.step, limit: 1.0 };
        self.accumulated(instance, of).rounded(fraction_bits)
    }

    fn accumulated(&self, instance: &str, of: Steps) -> Sig {
        self.b.instance(instance, || units::linear(self.b, self.first, of, self.steps))
    }

    /// A vector that is linear along a span, rounded, by its start and step: no longer than
    /// `longest` but for what its components are off by. [methods B12, C15]
    pub fn vector(
        &self,
        name: &str,
        [start, step]: [&[Sig; 3]; 2],
        longest: f64,
        rounded: Format,
    ) -> Vector {
        let component = |(c, axis): (usize, &str)| {
            let of = Steps { start: &start[c], step: &step[c], limit: longest };
            self.accumulated(&format!("{name}_{axis}"), of).rounded(rounded.fraction_bits)
        };
        let off = error::linear::bound(self.steps, start[0].ulp()) + rounded.ulp();
        Vector::new([(0, "x"), (1, "y"), (2, "z")].map(component))
            .no_longer_than(longest + 3f64.sqrt() * off)
    }

    /// What is quadratic along a span and stays within `limits`, rounded.
    pub fn quadratic(
        &self,
        instance: &str,
        quadratic: &Quadratic<Sig>,
        limits: (f64, f64),
        fraction_bits: u32,
    ) -> Sig {
        let of = Differences {
            start: &quadratic.start,
            first_difference: &quadratic.first_difference,
            second_difference: &quadratic.second_difference,
        };
        self.b
            .instance(instance, || units::quadratic(self.b, self.first, of, limits, self.steps))
            .rounded(fraction_bits)
    }
}
