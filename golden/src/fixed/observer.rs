//! Watching the values of one pixel as they are worked out.
use std::fmt;

use specula_spec::Format;

use super::number::{Wide, round_to, to_raw};
use super::vector::{AXES, Vector};

/// A named value of one pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// Its name, such as `light0_difference_x`; [`Model::trace`](super::Model::trace) lists them.
    pub name: String,
    /// Its raw value: value · 2^`fraction_bits` of the format.
    pub raw: i64,
    /// The format the spec gives it. Integer bits are nominal: the model rounds and never
    /// saturates.
    pub format: Format,
}

impl Observation {
    /// The value of that name among those of a pixel, if there is one.
    pub fn named<'a>(trace: &'a [Observation], name: &str) -> Option<&'a Observation> {
        trace.iter().find(|observation| observation.name == name)
    }

    /// What the raw value stands for.
    pub fn value(&self) -> f64 {
        self.format.value(self.raw)
    }
}

/// Is shown each value, and the sums of light before they become codes; an implementation that
/// keeps none costs nothing.
pub(super) trait Observer {
    fn see(&mut self, name: fmt::Arguments<'_>, value: Wide, format: Format);

    fn see_sums(&mut self, _sums: &[Wide; 3]) {}
}

/// Looks away.
pub(super) struct Nobody;

impl Observer for Nobody {
    #[inline(always)]
    fn see(&mut self, _: fmt::Arguments<'_>, _: Wide, _: Format) {}
}

/// Keeps the sums of light of one pixel, in LSBs.
#[derive(Default)]
pub(super) struct Sums(pub [f64; 3]);

impl Observer for Sums {
    #[inline(always)]
    fn see(&mut self, _: fmt::Arguments<'_>, _: Wide, _: Format) {}

    fn see_sums(&mut self, sums: &[Wide; 3]) {
        self.0 = sums.map(|sum| sum.to_num());
    }
}

/// Keeps everything.
#[derive(Default)]
pub(super) struct Notebook(pub Vec<Observation>);

impl Observer for Notebook {
    fn see(&mut self, name: fmt::Arguments<'_>, value: Wide, format: Format) {
        self.0.push(Observation {
            name: name.to_string(),
            raw: to_raw(value, format.fraction_bits),
            format,
        });
    }
}

/// Puts `light<index>_` before names.
pub(super) struct OfLight<'a, O> {
    pub observer: &'a mut O,
    pub index: usize,
}

impl<O: Observer> Observer for OfLight<'_, O> {
    #[inline(always)]
    fn see(&mut self, name: fmt::Arguments<'_>, value: Wide, format: Format) {
        self.observer.see(format_args!("light{}_{name}", self.index), value, format);
    }
}

/// A narrowing point: rounds to its format's fraction bits, before the observer's eyes.
#[inline(always)]
pub(super) fn narrow(
    observer: &mut impl Observer,
    name: fmt::Arguments<'_>,
    value: Wide,
    format: Format,
) -> Wide {
    let rounded = round_to(value, format.fraction_bits);
    observer.see(name, rounded, format);
    rounded
}

/// A narrowing point of three components.
#[inline(always)]
pub(super) fn narrow_vector(
    observer: &mut impl Observer,
    name: impl fmt::Display,
    vector: Vector,
    format: Format,
) -> Vector {
    std::array::from_fn(|c| narrow(observer, format_args!("{name}_{}", AXES[c]), vector[c], format))
}
