//! What goes along a span by additions: linear and quadratic values at pixel i, rounded.
use std::fmt;

use specula_spec::{Format, Linear, Quadratic};

use super::number::Wide;
use super::observer::{Observer, narrow};
use super::span_extent::quadratic_at;
use super::vector::{AXES, Vector};

/// Formats of an accumulator and of what is rounded from it.
#[derive(Clone, Copy)]
pub(super) struct Accumulator {
    pub exact: Format,
    pub rounded: Format,
}

impl Accumulator {
    /// start + step · i, rounded.
    pub fn linear(
        self,
        observer: &mut impl Observer,
        name: impl fmt::Display,
        linear: &Linear<Wide>,
        i: u32,
    ) -> Wide {
        self.narrow(
            observer,
            format_args!("{name}"),
            linear.start + linear.step * Wide::from_num(i),
        )
    }

    /// start + step · i of each component, rounded.
    pub fn vector(
        self,
        observer: &mut impl Observer,
        name: impl fmt::Display,
        [start, step]: [&Vector; 2],
        i: u32,
    ) -> Vector {
        std::array::from_fn(|c| {
            let component = Linear { start: start[c], step: step[c] };
            self.linear(observer, format_args!("{name}_{}", AXES[c]), &component, i)
        })
    }

    /// start + first · i + second · i(i - 1)/2, rounded.
    pub fn quadratic(
        self,
        observer: &mut impl Observer,
        name: impl fmt::Display,
        quadratic: &Quadratic<Wide>,
        i: u32,
    ) -> Wide {
        self.narrow(observer, format_args!("{name}"), quadratic_at(quadratic, i))
    }

    fn narrow(
        self,
        observer: &mut impl Observer,
        name: fmt::Arguments<'_>,
        accumulated: Wide,
    ) -> Wide {
        observer.see(format_args!("{name}_accumulator"), accumulated, self.exact);
        narrow(observer, name, accumulated, self.rounded)
    }
}
