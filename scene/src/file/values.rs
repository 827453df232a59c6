//! Values that scene files write in more than one way.
use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

/// Three numbers, written as one array, or as one number for all three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Triple(pub [f64; 3]);

/// Three numbers, written as one array.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Vector(pub [f64; 3]);

impl<'de> Deserialize<'de> for Triple {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Triple, D::Error> {
        deserializer.deserialize_any(TripleVisitor).map(Triple)
    }
}

impl<'de> Deserialize<'de> for Vector {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Vector, D::Error> {
        deserializer.deserialize_any(VectorVisitor).map(Vector)
    }
}

/// An integer; out of range is for the caller to say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Integer(pub i64);

/// A number, with or without a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Number(pub f64);

impl<'de> Deserialize<'de> for Integer {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Integer, D::Error> {
        deserializer.deserialize_any(IntegerVisitor).map(Integer)
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Number, D::Error> {
        deserializer.deserialize_any(NumberVisitor).map(Number)
    }
}

struct IntegerVisitor;

impl Visitor<'_> for IntegerVisitor {
    type Value = i64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an integer")
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<i64, E> {
        Ok(number)
    }
}

struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<f64, E> {
        Ok(number as f64)
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<f64, E> {
        Ok(number)
    }
}

struct TripleVisitor;

impl<'de> Visitor<'de> for TripleVisitor {
    type Value = [f64; 3];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an array of three numbers")
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<[f64; 3], E> {
        Ok([number as f64; 3])
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<[f64; 3], E> {
        Ok([number; 3])
    }

    fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<[f64; 3], A::Error> {
        three(numbers, &self)
    }
}

struct VectorVisitor;

impl<'de> Visitor<'de> for VectorVisitor {
    type Value = [f64; 3];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of three numbers")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<[f64; 3], A::Error> {
        three(numbers, &self)
    }
}

/// Exactly three numbers.
fn three<'de, A: SeqAccess<'de>>(
    mut numbers: A,
    expected: &dyn serde::de::Expected,
) -> Result<[f64; 3], A::Error> {
    let mut vector = [0.0; 3];
    for (k, number) in vector.iter_mut().enumerate() {
        *number = numbers
            .next_element::<Number>()?
            .map(|n| n.0)
            .ok_or_else(|| Error::invalid_length(k, expected))?;
    }
    match numbers.next_element::<Number>()? {
        None => Ok(vector),
        Some(_) => Err(Error::invalid_length(4, expected)),
    }
}
