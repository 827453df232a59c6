//! The declarations in a VCD file's header.
use super::super::variables::{Kind, ValueNames, split_name};
use super::super::warnings::{decoded, quoted};

/// Types of variables in IEEE 1364 and 1800, and those that GTKWave also knows.
const TYPES: [&str; 35] = [
    "event",
    "integer",
    "parameter",
    "real",
    "real_parameter",
    "realtime",
    "string",
    "reg",
    "supply0",
    "supply1",
    "time",
    "tri",
    "triand",
    "trior",
    "trireg",
    "tri0",
    "tri1",
    "wand",
    "wire",
    "wor",
    "port",
    "in",
    "out",
    "inout",
    "bit",
    "logic",
    "int",
    "shortint",
    "longint",
    "byte",
    "enum",
    "shortreal",
    "sparray",
    "uwire",
    "realparameter",
];
/// Types whose values are text or real numbers.
const OTHERS: [&str; 6] =
    ["real", "real_parameter", "realparameter", "realtime", "shortreal", "string"];
const PORTS: [&str; 4] = ["port", "in", "out", "inout"];

/// Types of scopes in IEEE 1364 and 1800, and those that GTKWave and simulators of VHDL also write.
const SCOPES: [&str; 14] = [
    "module",
    "task",
    "function",
    "begin",
    "fork",
    "generate",
    "struct",
    "union",
    "class",
    "interface",
    "package",
    "program",
    "block",
    "root",
];
const SCOPE_FAMILIES: [&str; 2] = ["vhdl_", "sv_"];

/// Largest width of a variable in bits.
pub const WIDEST: u32 = 1 << 20;

/// A variable as its section declares it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declaration {
    /// Its identifier in the file's values.
    pub id: Vec<u8>,
    /// Its name.
    pub name: String,
    /// The range of its bits.
    pub range: Option<String>,
    /// The kind of its values.
    pub kind: Kind,
    /// Its width in bits; `None` for values other than bits, and where the file does not state it.
    pub width: Option<u32>,
    /// Whether it is a port.
    pub port: bool,
}

/// A name for the kind of a fault in a section, and a message about it.
pub type Fault = (&'static str, String);

/// The reason why a variable is left out, and its identifier if it has one.
pub type LeftOut = (Fault, Option<Vec<u8>>);

/// Reads `$var TYPE SIZE ID NAME [RANGE] $end`, given the words between the keywords. The second
/// result is an oddity of a variable that can still be drawn.
///
/// # Errors
/// The reason why the variable cannot be drawn.
pub fn variable(words: &[Vec<u8>]) -> Result<(Declaration, Option<Fault>), LeftOut> {
    let comment = words.iter().position(|word| word == b"$comment").unwrap_or(words.len());
    let (kind_of, size, rest) = split_size(&words[..comment]);
    let [id, name @ ..] = rest else {
        return Err((
            ("variable", "a variable without an identifier is left out".to_owned()),
            None,
        ));
    };
    if name.is_empty() {
        return Err((
            ("variable", "a variable without a name is left out".to_owned()),
            Some(id.clone()),
        ));
    }
    let (name, range) =
        split_name(&name.iter().map(|word| decoded(word)).collect::<Vec<_>>().join(" "));
    let stated = kind_of.map(|word| decoded(word).to_ascii_lowercase());
    let known = stated.as_deref().filter(|stated| TYPES.contains(stated));
    let kind = match known {
        Some("event") => Kind::Event,
        Some(stated) if OTHERS.contains(&stated) => Kind::Other,
        _ => Kind::Bits,
    };
    let width = width(&size);
    if kind == Kind::Bits && width.is_some_and(|width| width > u64::from(WIDEST)) {
        let fault =
            format!("`{name}` is left out: {} bits are more than can be drawn", decoded(&size));
        return Err((("too wide", fault), Some(id.clone())));
    }
    let odd = match (kind_of, known, width) {
        (None, _, _) => Some(("type", format!("`{name}` has no type, and is drawn as a wire"))),
        (Some(word), None, _) => Some((
            "type",
            format!("{} is no type of a variable: `{name}` is drawn as a wire", quoted(word)),
        )),
        (_, _, None) if kind == Kind::Bits => Some((
            "size",
            format!("{} is no size: `{name}` is drawn as wide as its values", quoted(&size)),
        )),
        _ => None,
    };
    let port = known.is_some_and(|known| PORTS.contains(&known));
    // A width that exceeds a u32 has been refused above.
    let width = width
        .and_then(|width| u32::try_from(width).ok())
        .filter(|&width| kind == Kind::Bits && width > 0);
    Ok((Declaration { id: id.clone(), name, range, kind, width, port }, odd))
}

/// Splits the words into the type, the size, which may contain blanks between its brackets, and the
/// rest.
fn split_size(words: &[Vec<u8>]) -> (Option<&Vec<u8>>, Vec<u8>, &[Vec<u8>]) {
    let is_number = |word: &Vec<u8>| !word.is_empty() && word.iter().all(u8::is_ascii_digit);
    let (kind, sized) = match words {
        [first, _, _, ..] if is_number(first) && !words.get(1).is_some_and(is_number) => {
            (None, words)
        }
        [first, rest @ ..] => (Some(first), rest),
        [] => (None, words),
    };
    let Some(first) = sized.first() else { return (kind, vec![], sized) };
    let closed =
        sized.iter().position(|word| word.ends_with(b"]")).filter(|_| first.starts_with(b"["));
    let end = closed.unwrap_or(0) + 1;
    (kind, sized[..end].concat(), &sized[end..])
}

/// The width that a size states, as a number or, in extended dumps, as a range.
fn width(size: &[u8]) -> Option<u64> {
    let text = std::str::from_utf8(size).ok()?;
    let Some(range) = text.strip_prefix('[').and_then(|text| text.strip_suffix(']')) else {
        // Numbers that are too large to be read are widths that are too large.
        return text
            .bytes()
            .all(|byte| byte.is_ascii_digit())
            .then(|| text.parse().unwrap_or(u64::MAX))
            .filter(|_| !text.is_empty());
    };
    let Some((high, low)) = range.split_once(':') else {
        return range.parse::<i64>().ok().map(|_| 1);
    };
    let (high, low) = (high.trim().parse::<i64>().ok()?, low.trim().parse::<i64>().ok()?);
    high.abs_diff(low).checked_add(1)
}

/// Reads `$scope TYPE NAME $end`: the name, and an oddity.
///
/// # Errors
/// The fault that there is no name.
pub fn scope(words: &[Vec<u8>]) -> Result<(String, Option<Fault>), Fault> {
    let known = |word: &[u8]| {
        let word = decoded(word).to_ascii_lowercase();
        SCOPES.contains(&word.as_str())
            || SCOPE_FAMILIES.iter().any(|family| word.starts_with(family))
    };
    match words {
        [] => Err(("scope", "a scope without a name is passed over".to_owned())),
        [name] => {
            let name = decoded(name);
            let odd = format!("the scope `{name}` has no type");
            Ok((name, Some(("scope type", odd))))
        }
        [kind, name @ ..] => {
            let name = name.iter().map(|word| decoded(word)).collect::<Vec<_>>().join(" ");
            let odd = || ("scope type", format!("{} is no type of a scope", quoted(kind)));
            let odd = (!known(kind)).then(odd);
            Ok((name, odd))
        }
    }
}

/// Attributes of enumerations, as `fst2vcd` and GTKWave write them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Attribute {
    /// An enumeration and its number.
    Enumeration(u64, ValueNames),
    /// The number of the enumeration that the next variable has.
    Next(u64),
}

/// Reads `$attrbegin misc 07 NAME COUNT NAMES.. VALUES.. NUMBER $end`, or if the name is `""`, the
/// number alone. The result is `None` for other attributes.
pub fn attribute(words: &[Vec<u8>]) -> Option<Attribute> {
    let [misc, kind, name, about @ .., number] = words else { return None };
    if misc != b"misc" || kind != b"07" {
        return None;
    }
    let number: u64 = decoded(number).parse().ok()?;
    let Some((count, pairs)) = about.split_first().filter(|_| name != b"\"\"") else {
        return Some(Attribute::Next(number));
    };
    let count: usize = decoded(count).parse().ok()?;
    let (names, values) =
        pairs.split_at_checked(count).filter(|(_, values)| values.len() == count)?;
    let pairs = values.iter().zip(names).map(|(value, name)| (decoded(value), decoded(name)));
    Some(Attribute::Enumeration(number, ValueNames::new(pairs)))
}

/// Reads `$timescale 10 ns $end`: the result is `10 ns`, or `ns` for a scale of one.
pub fn time_unit(words: &[Vec<u8>]) -> Option<String> {
    const UNITS: [&str; 8] = ["s", "ms", "us", "ns", "ps", "fs", "as", "zs"];
    let text = decoded(&words.concat()).to_ascii_lowercase().replace(['\u{b5}', '\u{3bc}'], "u");
    let (number, unit) =
        text.split_at(text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len()));
    let unit = UNITS.iter().find(|known| unit == **known)?;
    match number {
        "" | "1" => Some((*unit).to_owned()),
        // The unit of time must be a power of ten.
        number => Some(format!("{number} {unit}")).filter(|_| number.trim_end_matches('0') == "1"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<Vec<u8>> {
        text.split_whitespace().map(|word| word.as_bytes().to_vec()).collect()
    }

    fn declared(text: &str) -> (String, Option<u32>, Kind, Option<&'static str>) {
        let (declaration, odd) = variable(&words(text)).expect("it can be drawn");
        (declaration.name, declaration.width, declaration.kind, odd.map(|(kind, _)| kind))
    }

    #[test]
    fn variables_are_declared_in_many_ways() {
        let bits = |name: &str, width| (name.to_owned(), Some(width), Kind::Bits, None);
        assert_eq!(declared("wire 8 ! d [7:0]"), bits("d", 8));
        assert_eq!(declared("port [7:0] <1 bus"), bits("bus", 8));
        assert_eq!(declared("port [ 7 : 0 ] <1 bus"), bits("bus", 8));
        assert_eq!(declared("REG 1 $end q"), bits("q", 1));
        assert_eq!(declared("wire 1 0 digit"), bits("digit", 1));
        assert_eq!(declared("wire 1 ! a $comment of nobody"), bits("a", 1));
        assert_eq!(declared("8 ! d [7:0]"), ("d".to_owned(), Some(8), Kind::Bits, Some("type")));
        assert_eq!(declared("unknown 8 ! d"), ("d".to_owned(), Some(8), Kind::Bits, Some("type")));
        assert_eq!(declared("wire x ! d"), ("d".to_owned(), None, Kind::Bits, Some("size")));
        assert_eq!(declared("wire 0 ! d"), ("d".to_owned(), None, Kind::Bits, None));
        assert_eq!(declared("real 64 ! r"), ("r".to_owned(), None, Kind::Other, None));
        assert_eq!(declared("string 0 ! s"), ("s".to_owned(), None, Kind::Other, None));
        assert_eq!(declared("event 1 ! e"), ("e".to_owned(), None, Kind::Event, None));
    }

    #[test]
    fn variables_that_cannot_be_drawn_are_told() {
        let refused = |text| variable(&words(text)).expect_err("it cannot be drawn").0.0;
        assert_eq!(["", "wire", "wire 1", "wire 1 !"].map(refused), ["variable"; 4]);
        assert_eq!(
            ["wire 4000000000 ! w", "wire 99999999999999999999 ! w"].map(refused),
            ["too wide"; 2]
        );
    }

    #[test]
    fn enumerations_are_attributes() {
        let names =
            [("00", "IDLE"), ("01", "RUN")].map(|(bits, name)| (bits.to_owned(), name.to_owned()));
        let read = |text| attribute(&words(text));
        assert_eq!(
            read("misc 07 st 2 IDLE RUN 00 01 1"),
            Some(Attribute::Enumeration(1, ValueNames::new(names)))
        );
        assert_eq!(read("misc 07 \"\" 1"), Some(Attribute::Next(1)));
        for other in [
            "misc 02 st 1024",
            "misc 07 st 3 IDLE RUN 00 01 1",
            "misc 07 st 18446744073709551615 a 1",
            "misc",
            "",
        ] {
            assert_eq!(read(other), None, "{other}");
        }
    }

    #[test]
    fn scopes_may_lack_their_type() {
        let read = |text| scope(&words(text)).map(|(name, odd)| (name, odd.is_some()));
        assert_eq!(read("module top"), Ok(("top".to_owned(), false)));
        assert_eq!(read("vhdl_process p"), Ok(("p".to_owned(), false)));
        assert_eq!(read("dump"), Ok(("dump".to_owned(), true)));
        assert_eq!(read("room top"), Ok(("top".to_owned(), true)));
        assert!(read("").is_err());
    }

    #[test]
    fn units_of_time_are_powers_of_ten() {
        let cases = [
            ("1ns", Some("ns")),
            ("1 ns", Some("ns")),
            ("ps", Some("ps")),
            ("10ps", Some("10 ps")),
            ("100 us", Some("100 us")),
            ("100 \u{b5}s", Some("100 us")),
            ("1 S", Some("s")),
            ("3 ns", None),
            ("1 hour", None),
            ("", None),
        ];
        for (text, unit) in cases {
            assert_eq!(time_unit(&words(text)).as_deref(), unit, "{text}");
        }
    }
}
