//! A core's inputs.
use crate::bound::Interval;
use crate::format::Format;

/// One data input of a core, held while its span goes in.
#[derive(Clone, Debug, PartialEq)]
pub struct InputPort {
    /// Its name in the hardware, such as `normal_start_x`.
    pub name: String,
    /// Its format.
    pub format: Format,
    /// Smallest and largest raw value it is given; ranges inside the core are proven from these.
    pub range: (i64, i64),
    /// Where the real values lie that are rounded to these, as far as that is known.
    pub real: Interval,
    /// An earlier input of the same format whose value it always has, if there is one: then it is
    /// no input of the hardware.
    pub same_as: Option<String>,
}

impl InputPort {
    /// A port that takes every value of its format.
    pub fn whole(name: impl Into<String>, format: Format) -> InputPort {
        InputPort {
            name: name.into(),
            format,
            range: (format.min_raw(), format.max_raw()),
            real: Interval::ANY,
            same_as: None,
        }
    }

    /// A port that takes values from `low` to `high`, real ones as well as rounded ones.
    pub fn between(name: impl Into<String>, format: Format, low: f64, high: f64) -> InputPort {
        InputPort {
            name: name.into(),
            format,
            range: (format.quantise(low), format.quantise(high)),
            real: Interval::new(low, high),
            same_as: None,
        }
    }

    /// Ports of a vector's components, each from -`limit` to `limit`.
    pub fn vector(name: &str, format: Format, limit: f64) -> [InputPort; 3] {
        ["x", "y", "z"]
            .map(|axis| InputPort::between(format!("{name}_{axis}"), format, -limit, limit))
    }
}
