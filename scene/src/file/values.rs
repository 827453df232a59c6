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

/// A value, or an array of such values.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct OneOrMore<T>(pub Vec<T>);

impl<'de> Deserialize<'de> for OneOrMore<Number> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<OneOrMore<Number>, D::Error> {
        deserializer.deserialize_any(NumbersVisitor).map(OneOrMore)
    }
}

impl<'de> Deserialize<'de> for OneOrMore<Vector> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<OneOrMore<Vector>, D::Error> {
        deserializer.deserialize_any(VectorsVisitor).map(OneOrMore)
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

struct NumbersVisitor;

impl<'de> Visitor<'de> for NumbersVisitor {
    type Value = Vec<Number>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an array of numbers")
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Vec<Number>, E> {
        Ok(vec![Number(number as f64)])
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Vec<Number>, E> {
        Ok(vec![Number(number)])
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Vec<Number>, A::Error> {
        std::iter::from_fn(|| numbers.next_element::<Number>().transpose()).collect()
    }
}

struct VectorsVisitor;

impl<'de> Visitor<'de> for VectorsVisitor {
    type Value = Vec<Vector>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an array of three numbers or an array of such arrays")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut parts: A) -> Result<Vec<Vector>, A::Error> {
        let parts: Vec<Part> = std::iter::from_fn(|| parts.next_element::<Part>().transpose())
            .collect::<Result<_, _>>()?;
        let numbers: Option<Vec<f64>> = parts.iter().map(Part::number).collect();
        match numbers.as_deref() {
            Some(&[x, y, z]) => Ok(vec![Vector([x, y, z])]),
            _ => parts
                .iter()
                .map(|part| part.vector().ok_or_else(|| Error::invalid_length(parts.len(), &self)))
                .collect(),
        }
    }
}

/// A component of a vector, or a vector among several.
enum Part {
    Number(f64),
    Vector([f64; 3]),
}

impl Part {
    fn number(&self) -> Option<f64> {
        match self {
            Part::Number(number) => Some(*number),
            Part::Vector(_) => None,
        }
    }

    fn vector(&self) -> Option<Vector> {
        match self {
            Part::Number(_) => None,
            Part::Vector(vector) => Some(Vector(*vector)),
        }
    }
}

impl<'de> Deserialize<'de> for Part {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Part, D::Error> {
        deserializer.deserialize_any(PartVisitor)
    }
}

struct PartVisitor;

impl<'de> Visitor<'de> for PartVisitor {
    type Value = Part;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an array of three numbers")
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Part, E> {
        Ok(Part::Number(number as f64))
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Part, E> {
        Ok(Part::Number(number))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<Part, A::Error> {
        three(numbers, &self).map(Part::Vector)
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
