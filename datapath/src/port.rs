//! A core's inputs.
use crate::bound::Interval;
use crate::format::Format;

/// For how long an input stands still.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Hold {
    /// While the pixels of a span go in.
    Span,
    /// While any pixel is under way: it is *quasi-static*, and written between frames. It changes
    /// only after the last pixel has left, and is then what the next pixel sees if that enters
    /// [`settling`](crate::Design::settling) clocks later or more. So it is read without any delay
    /// register.
    Frame,
}

/// One data input of a core.
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
    /// For how long it stands still.
    pub hold: Hold,
    /// An earlier input of the same format whose value it always has, if there is one: then it is
    /// no input of the hardware.
    pub same_as: Option<String>,
}

impl InputPort {
    /// A port that takes every value of its format, held for a span.
    pub fn whole(name: impl Into<String>, format: Format) -> InputPort {
        InputPort {
            name: name.into(),
            format,
            range: (format.min_raw(), format.max_raw()),
            real: Interval::ANY,
            hold: Hold::Span,
            same_as: None,
        }
    }

    /// A port that takes values from `low` to `high`, real ones as well as rounded ones, held for a
    /// span.
    pub fn between(name: impl Into<String>, format: Format, low: f64, high: f64) -> InputPort {
        InputPort {
            range: (format.quantise(low), format.quantise(high)),
            real: Interval::new(low, high),
            ..InputPort::whole(name, format)
        }
    }

    /// Ports of a vector's components, each from -`limit` to `limit`, held for a span.
    pub fn vector(name: &str, format: Format, limit: f64) -> [InputPort; 3] {
        ["x", "y", "z"]
            .map(|axis| InputPort::between(format!("{name}_{axis}"), format, -limit, limit))
    }
}
