//! The header of a `.ply` file: the elements that follow, and their properties.
use crate::mesh::error::{Located, MeshProblem};
use crate::mesh::lines::{LineEnd, Lines, Words, words};
use crate::mesh::warning::quoted;

/// The encoding of the elements after the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Text, with an element on each line.
    Text,
    /// Binary, the least significant byte first.
    LittleEndian,
    /// Binary, the most significant byte first.
    BigEndian,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// `char` or `int8`.
    I8,
    /// `uchar` or `uint8`.
    U8,
    /// `short` or `int16`.
    I16,
    /// `ushort` or `uint16`.
    U16,
    /// `int` or `int32`.
    I32,
    /// `uint` or `uint32`.
    U32,
    /// `float` or `float32`.
    F32,
    /// `double` or `float64`.
    F64,
}

impl Scalar {
    fn named(name: &[u8]) -> Option<Scalar> {
        Some(match name {
            b"char" | b"int8" => Scalar::I8,
            b"uchar" | b"uint8" => Scalar::U8,
            b"short" | b"int16" => Scalar::I16,
            b"ushort" | b"uint16" => Scalar::U16,
            b"int" | b"int32" => Scalar::I32,
            b"uint" | b"uint32" => Scalar::U32,
            b"float" | b"float32" => Scalar::F32,
            b"double" | b"float64" => Scalar::F64,
            _ => return None,
        })
    }

    /// Bytes that a number of this type takes in a binary file.
    pub fn size(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }

    /// The largest number of this type if it is unsigned, which -1 becomes in it.
    pub fn largest_unsigned(self) -> Option<i64> {
        match self {
            Scalar::U8 => Some(i64::from(u8::MAX)),
            Scalar::U16 => Some(i64::from(u16::MAX)),
            Scalar::U32 => Some(i64::from(u32::MAX)),
            _ => None,
        }
    }

    /// Whether numbers of this type are integers.
    pub fn is_whole(self) -> bool {
        !matches!(self, Scalar::F32 | Scalar::F64)
    }
}

/// A number, or a list of numbers with its length before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One number.
    Number(Scalar),
    /// A list.
    List {
        /// Type of the length.
        length: Scalar,
        /// Type of its items.
        item: Scalar,
    },
}

/// A property of an element; its name is in the file's own encoding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Property<'a> {
    /// Its name.
    pub name: &'a [u8],
    /// Its kind.
    pub kind: Kind,
}

/// A kind of element, and the number of elements; its name is in the file's own encoding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element<'a> {
    /// Its name.
    pub name: &'a [u8],
    /// Its line in the header, counted from 1.
    pub line: usize,
    /// Number of elements after the header.
    pub count: usize,
    /// The properties of each element, in this order.
    pub properties: Vec<Property<'a>>,
}

impl<'a> Element<'a> {
    /// The property of this name.
    pub fn property(&self, name: &str) -> Option<&Property<'a>> {
        self.properties.iter().find(|property| property.name == name.as_bytes())
    }
}

/// The contents of the header, and what follows it.
#[derive(Clone, Debug)]
pub struct Header<'a> {
    /// The encoding of the elements.
    pub encoding: Encoding,
    /// All elements in their order.
    pub elements: Vec<Element<'a>>,
    /// The lines after the header.
    pub lines: Lines<'a>,
    /// The bytes after the header, in a binary file.
    pub data: &'a [u8],
}

impl<'a> Header<'a> {
    /// Reads the header. Comments, names and `obj_info` may be in any encoding, lines may end in
    /// LF, CR LF or CR.
    ///
    /// # Errors
    /// A line that no header has, with its number; a header without an end.
    pub fn read(bytes: &'a [u8]) -> Result<Header<'a>, Located> {
        let mut lines = Lines::new(bytes);
        let first = lines.next().unwrap_or_default();
        if first.trim_ascii_end() != b"ply" {
            return Err(syntax(format!(
                "it does not start with `ply`, but with {}",
                quoted(first)
            ))
            .at_line(1));
        }
        let end = lines.end();
        let mut draft = Draft::default();
        while let Some(line) = lines.next() {
            let number = lines.number();
            if draft.line(line, number).map_err(|problem| problem.at_line(number))? {
                return draft.finished(lines, end);
            }
        }
        let text = "the header has no `end_header`".to_owned();
        Err(MeshProblem::Truncated(text).at_line(lines.number()))
    }
}

/// The part of a header read so far.
#[derive(Default)]
struct Draft<'a> {
    encoding: Option<Encoding>,
    elements: Vec<Element<'a>>,
}

impl<'a> Draft<'a> {
    /// Reads a line; the result is true for the last.
    fn line(&mut self, line: &'a [u8], number: usize) -> Result<bool, MeshProblem> {
        let mut rest = words(line);
        match rest.next() {
            None | Some(b"comment" | b"obj_info") => {}
            Some(b"format") => self.encoding = Some(encoding(&mut rest)?),
            Some(b"element") => self.elements.push(element(&mut rest, number)?),
            Some(b"property") => {
                let property = property(&mut rest)?;
                let last = self.elements.last_mut();
                last.ok_or_else(|| syntax("a property stands before the first element".into()))?
                    .properties
                    .push(property);
            }
            Some(b"end_header") => return Ok(true),
            Some(word) => {
                return Err(syntax(format!(
                    "{} is no word that a line of the header starts with",
                    quoted(word)
                )));
            }
        }
        Ok(false)
    }

    fn finished(self, lines: Lines<'a>, end: LineEnd) -> Result<Header<'a>, Located> {
        let missing = || syntax("the header has no line `format`".into()).at_line(lines.number());
        let encoding = self.encoding.ok_or_else(missing)?;
        let data = lines.rest_after(end);
        Ok(Header { encoding, elements: self.elements, lines, data })
    }
}

/// Reads `ascii 1.0`, `binary_little_endian 1.0` or `binary_big_endian 1.0`.
fn encoding(rest: &mut Words<'_>) -> Result<Encoding, MeshProblem> {
    let encoding = match needed(rest, "an encoding")? {
        b"ascii" => Encoding::Text,
        b"binary_little_endian" => Encoding::LittleEndian,
        b"binary_big_endian" => Encoding::BigEndian,
        other => {
            let known = "`ascii`, `binary_little_endian`, `binary_big_endian`";
            return Err(syntax(format!("{} is no encoding; known are {known}", quoted(other))));
        }
    };
    match needed(rest, "the version")? {
        b"1.0" => Ok(encoding),
        other => Err(syntax(format!("the version is {}; known is `1.0`", quoted(other)))),
    }
}

/// Reads `NAME COUNT`.
fn element<'a>(rest: &mut Words<'a>, line: usize) -> Result<Element<'a>, MeshProblem> {
    let name = needed(rest, "an element's name")?;
    let word = needed(rest, "how many of it there are")?;
    let count = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok());
    let count =
        count.ok_or_else(|| syntax(format!("{} is no number of elements", quoted(word))))?;
    Ok(Element { name, line, count, properties: Vec::new() })
}

/// Reads `TYPE NAME` or `list TYPE TYPE NAME`.
fn property<'a>(rest: &mut Words<'a>) -> Result<Property<'a>, MeshProblem> {
    let kind = match needed(rest, "a property's type")? {
        b"list" => {
            let length = needed(rest, "the type of the list's length")?;
            let length = match scalar(length)? {
                whole if whole.is_whole() => whole,
                _ => {
                    return Err(syntax(format!(
                        "a list's length is a whole number, it cannot be {}",
                        quoted(length)
                    )));
                }
            };
            Kind::List { length, item: scalar(needed(rest, "the type of what is in the list")?)? }
        }
        name => Kind::Number(scalar(name)?),
    };
    Ok(Property { name: needed(rest, "a property's name")?, kind })
}

fn scalar(name: &[u8]) -> Result<Scalar, MeshProblem> {
    let known = "`char`, `uchar`, `short`, `ushort`, `int`, `uint`, `float`, `double`, and `int8` to `float64`";
    Scalar::named(name)
        .ok_or_else(|| syntax(format!("{} is no type; known are {known}", quoted(name))))
}

fn needed<'a>(rest: &mut Words<'a>, what: &str) -> Result<&'a [u8], MeshProblem> {
    rest.next().ok_or_else(|| syntax(format!("the line ends where {what} is needed")))
}

fn syntax(text: String) -> MeshProblem {
    MeshProblem::Syntax(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_may_have_any_line_end_and_any_encoding_in_comments() {
        for end in ["\n", "\r\n", "\r"] {
            let text = "ply|format binary_big_endian 1.0|comment ?|obj_info ?|element ? 3|property list uint8 int32 a|\
                        property float64 ?|end_header|\nx";
            let bytes: Vec<u8> = text
                .replace('|', end)
                .bytes()
                .map(|byte| if byte == b'?' { 0xe9 } else { byte })
                .collect();
            let header = Header::read(&bytes).expect("it is right");
            assert_eq!(header.encoding, Encoding::BigEndian);
            let list =
                Property { name: b"a", kind: Kind::List { length: Scalar::U8, item: Scalar::I32 } };
            let number = Property { name: b"\xe9", kind: Kind::Number(Scalar::F64) };
            let element =
                Element { name: b"\xe9", line: 5, count: 3, properties: vec![list, number] };
            assert_eq!(header.elements, [element]);
            assert_eq!(header.data, b"\nx", "{end:?}");
        }
    }

    #[test]
    fn wrong_words_are_named_with_their_lines() {
        let said = |line: &str| {
            let text = format!("ply\nformat ascii 1.0\nelement vertex 1\n{line}\nend_header\n");
            let wrong = Header::read(text.as_bytes()).expect_err("it is wrong");
            (wrong.line, wrong.problem.to_string())
        };
        for (line, text) in [
            ("property floaty x", "`floaty` is no type; known are"),
            (
                "property list float int x",
                "a list's length is a whole number, it cannot be `float`",
            ),
            ("property float", "the line ends where a property's name is needed"),
            ("element face many", "`many` is no number of elements"),
            ("element face -1", "`-1` is no number of elements"),
            ("elements face 1", "`elements` is no word that a line of the header starts with"),
            ("format binary 1.0", "`binary` is no encoding"),
            ("format ascii 2.0", "the version is `2.0`; known is `1.0`"),
        ] {
            let (number, problem) = said(line);
            assert_eq!(number, Some(4), "{line}");
            assert!(problem.starts_with(text), "{line}: {problem}");
        }
    }
}
