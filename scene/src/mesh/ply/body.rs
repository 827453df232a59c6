//! The elements after the header, in text or binary.
use super::header::{Element, Encoding, Property, Scalar};
use crate::mesh::error::{Located, MeshProblem};
use crate::mesh::lines::{Lines, Words, words};
use crate::mesh::number::{number, single, whole};
use crate::mesh::warning::{Notices, quoted};

/// Reads the numbers of elements in the order in which they are written.
pub trait Body {
    /// Advances to the next element, the `index`-th of `element`, counted from 0.
    ///
    /// # Errors
    /// There are no more elements.
    fn start(&mut self, element: &Element<'_>, index: usize) -> Result<(), Located>;

    /// The next number, of type `scalar`; it may not be finite.
    ///
    /// # Errors
    /// The element or the file ends, or the word is not a number.
    fn number(&mut self, property: &Property<'_>, scalar: Scalar) -> Result<f64, Located>;

    /// The next number, which must be an integer.
    ///
    /// # Errors
    /// The element or the file ends, or the word is not an integer.
    fn whole(&mut self, property: &Property<'_>, scalar: Scalar) -> Result<i64, Located>;

    /// Skips `count` numbers, whatever is written there.
    ///
    /// # Errors
    /// The element or the file ends.
    fn skip(
        &mut self,
        property: &Property<'_>,
        scalar: Scalar,
        count: usize,
    ) -> Result<(), Located>;

    /// Leaves the element; adds a note if it has more than its properties.
    fn finish(&mut self, notices: &mut Notices);

    /// Adds a note if anything follows the last element.
    fn finish_all(&mut self, notices: &mut Notices);

    /// The current line, counted from 1, if the file has lines.
    fn line(&self) -> Option<usize>;

    /// A problem at the current place.
    fn wrong(&self, text: String) -> Located;
}

/// Elements in text, one a line; blank lines are skipped.
pub struct Text<'a> {
    lines: Lines<'a>,
    rest: Words<'a>,
}

impl<'a> Text<'a> {
    /// Elements in `lines`.
    pub fn new(lines: Lines<'a>) -> Text<'a> {
        Text { lines, rest: Words::default() }
    }

    fn next_full_line(&mut self) -> Option<&'a [u8]> {
        self.lines.by_ref().find(|line| words(line).next().is_some())
    }

    fn word(&mut self, property: &Property<'_>) -> Result<&'a [u8], Located> {
        self.rest.next().ok_or_else(|| {
            self.wrong(format!("the line ends where property {} is needed", quoted(property.name)))
        })
    }
}

impl Body for Text<'_> {
    fn start(&mut self, element: &Element<'_>, index: usize) -> Result<(), Located> {
        let Some(line) = self.next_full_line() else {
            let (count, name) = (element.count, quoted(element.name));
            let text = format!("its header states {count} of {name}; {index} are there");
            return Err(MeshProblem::Truncated(text).at_line(self.lines.number()));
        };
        self.rest = words(line);
        Ok(())
    }

    fn number(&mut self, property: &Property<'_>, scalar: Scalar) -> Result<f64, Located> {
        let word = self.word(property)?;
        let value = if scalar == Scalar::F32 { single(word) } else { number(word) };
        value.ok_or_else(|| {
            self.wrong(format!(
                "{} is no number (property {})",
                quoted(word),
                quoted(property.name)
            ))
        })
    }

    fn whole(&mut self, property: &Property<'_>, _scalar: Scalar) -> Result<i64, Located> {
        let word = self.word(property)?;
        whole(word).ok_or_else(|| {
            self.wrong(format!(
                "{} is no whole number (property {})",
                quoted(word),
                quoted(property.name)
            ))
        })
    }

    fn skip(
        &mut self,
        property: &Property<'_>,
        _scalar: Scalar,
        count: usize,
    ) -> Result<(), Located> {
        for _ in 0..count {
            self.word(property)?;
        }
        Ok(())
    }

    fn finish(&mut self, notices: &mut Notices) {
        if let Some(word) = self.rest.next() {
            let text = || {
                format!("what stands behind the last property, {}, is passed over", quoted(word))
            };
            notices.add("behind the last property", self.line(), text);
        }
    }

    fn finish_all(&mut self, notices: &mut Notices) {
        if let Some(line) = self.next_full_line() {
            let text =
                || format!("what follows the last element, {}, is passed over", quoted(line));
            notices.add("behind the last element", self.line(), text);
        }
    }

    fn line(&self) -> Option<usize> {
        Some(self.lines.number())
    }

    fn wrong(&self, text: String) -> Located {
        MeshProblem::Syntax(text).at_line(self.lines.number())
    }
}

/// Elements in binary.
pub struct Binary<'a> {
    rest: &'a [u8],
    encoding: Encoding,
    /// The name of the current element, for errors.
    element: String,
    index: usize,
}

impl<'a> Binary<'a> {
    /// Elements in `data`, in the byte order of `encoding`.
    pub fn new(data: &'a [u8], encoding: Encoding) -> Binary<'a> {
        Binary { rest: data, encoding, element: String::new(), index: 0 }
    }

    fn take(&mut self, property: &Property<'_>, bytes: Option<usize>) -> Result<&'a [u8], Located> {
        match bytes.and_then(|bytes| self.rest.split_at_checked(bytes)) {
            Some((taken, rest)) => {
                self.rest = rest;
                Ok(taken)
            }
            None => {
                let text = format!(
                    "the file ends in property {} of {}",
                    quoted(property.name),
                    self.place()
                );
                Err(MeshProblem::Truncated(text).into())
            }
        }
    }

    fn place(&self) -> String {
        format!("{} {} (counted from 0)", self.element, self.index)
    }
}

impl Body for Binary<'_> {
    fn start(&mut self, element: &Element<'_>, index: usize) -> Result<(), Located> {
        if index == 0 {
            self.element = quoted(element.name);
        }
        self.index = index;
        Ok(())
    }

    fn number(&mut self, property: &Property<'_>, scalar: Scalar) -> Result<f64, Located> {
        let bytes = self.take(property, Some(scalar.size()))?;
        Ok(value(bytes, scalar, self.encoding))
    }

    fn whole(&mut self, property: &Property<'_>, scalar: Scalar) -> Result<i64, Located> {
        // Integers of at most 32 bits are exact in f64; the header is checked for fractional types.
        self.number(property, scalar).map(|value| value as i64)
    }

    fn skip(
        &mut self,
        property: &Property<'_>,
        scalar: Scalar,
        count: usize,
    ) -> Result<(), Located> {
        self.take(property, count.checked_mul(scalar.size())).map(drop)
    }

    fn finish(&mut self, _notices: &mut Notices) {}

    fn finish_all(&mut self, notices: &mut Notices) {
        if !self.rest.is_empty() {
            let text =
                || format!("{} bytes behind the last element are passed over", self.rest.len());
            notices.add("behind the last element", None, text);
        }
    }

    fn line(&self) -> Option<usize> {
        None
    }

    fn wrong(&self, text: String) -> Located {
        MeshProblem::Syntax(format!("{}: {text}", self.place())).into()
    }
}

/// The number in `bytes`, which are as many as `scalar` has.
fn value(bytes: &[u8], scalar: Scalar, encoding: Encoding) -> f64 {
    let mut low_first = [0; 8];
    low_first[..bytes.len()].copy_from_slice(bytes);
    if encoding == Encoding::BigEndian {
        low_first[..bytes.len()].reverse();
    }
    let bits = u64::from_le_bytes(low_first);
    match scalar {
        Scalar::I8 => f64::from(bits as i8),
        Scalar::U8 => f64::from(bits as u8),
        Scalar::I16 => f64::from(bits as i16),
        Scalar::U16 => f64::from(bits as u16),
        Scalar::I32 => f64::from(bits as i32),
        Scalar::U32 => f64::from(bits as u32),
        Scalar::F32 => f64::from(f32::from_bits(bits as u32)),
        Scalar::F64 => f64::from_bits(bits),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_type_are_read_in_both_byte_orders() {
        for (bytes, scalar, expected) in [
            (&[0xfe][..], Scalar::I8, -2.0),
            (&[0xfe], Scalar::U8, 254.0),
            (&[0xfe, 0xff], Scalar::I16, -2.0),
            (&[0xfe, 0xff], Scalar::U16, 65534.0),
            (&[0xfe, 0xff, 0xff, 0xff], Scalar::I32, -2.0),
            (&[0xfe, 0xff, 0xff, 0xff], Scalar::U32, 4294967294.0),
            (&[0, 0, 0xc0, 0x3f], Scalar::F32, 1.5),
            (&[0, 0, 0, 0, 0, 0, 0xf8, 0x3f], Scalar::F64, 1.5),
        ] {
            assert_eq!(value(bytes, scalar, Encoding::LittleEndian), expected);
            let reversed: Vec<u8> = bytes.iter().rev().copied().collect();
            assert_eq!(value(&reversed, scalar, Encoding::BigEndian), expected);
        }
    }
}
