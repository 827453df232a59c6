//! A number that counts the operations on it.
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Sub};

use super::Number;
use super::operation_counts::Operations;

thread_local! {
    static DONE: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

/// An f64 whose operations are counted, for [`count`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counted(pub f64);

/// The operations on [`Counted`] numbers that `work` does on this thread.
pub fn count(work: impl FnOnce()) -> Operations {
    let before = DONE.replace(Operations::NONE);
    work();
    DONE.replace(before)
}

fn done(operation: Operations) {
    DONE.with(|total| total.set(total.get() + operation));
}

impl Add for Counted {
    type Output = Counted;
    fn add(self, other: Counted) -> Counted {
        done(Operations { adds: 1, ..Operations::NONE });
        Counted(self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Counted;
    fn sub(self, other: Counted) -> Counted {
        done(Operations { subtractions: 1, ..Operations::NONE });
        Counted(self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Counted;
    fn mul(self, other: Counted) -> Counted {
        done(Operations { multiplies: 1, ..Operations::NONE });
        Counted(self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Counted;
    fn div(self, other: Counted) -> Counted {
        done(Operations { divisions: 1, ..Operations::NONE });
        Counted(self.0 / other.0)
    }
}

impl Number for Counted {
    const LEAST: f64 = f64::LEAST;

    fn of(value: f64) -> Self {
        Counted(value)
    }

    fn square_root(self) -> Self {
        done(Operations { square_roots: 1, ..Operations::NONE });
        Counted(self.0.sqrt())
    }

    fn halved(self) -> Self {
        Counted(self.0.halved())
    }

    fn floored(self) -> Self {
        Counted(self.0.floored())
    }

    fn positive(self) -> Self {
        Counted(self.0.positive())
    }

    fn at_most_one(self) -> Self {
        Counted(self.0.at_most_one())
    }

    fn where_positive(self, sign: Self) -> Self {
        Counted(self.0.where_positive(sign.0))
    }

    fn sine(self) -> Self {
        Counted(self.0.sine())
    }

    fn arc_cosine(self) -> Self {
        Counted(self.0.arc_cosine())
    }

    fn exponential(self) -> Self {
        Counted(self.0.exponential())
    }
}
