//! What the papers claim of the speed of their algorithms.
use super::super::Paper;
use super::Timed;
use crate::tradeoff::software::Software;

/// A claim about the run time of two algorithms.
#[derive(Clone, Copy, Debug)]
pub struct SpeedClaim {
    /// The paper.
    pub paper: Paper,
    /// The claim as text.
    pub what: &'static str,
    /// The ratio that decides it, as text.
    pub quantity: &'static str,
    /// The ratio; `None` if one of the loops was not timed.
    pub ratio: fn(&Timed) -> Option<f64>,
    /// Decides from the ratio.
    pub judge: fn(f64) -> Outcome,
}

/// Whether a claim about speed holds in a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It holds.
    Holds,
    /// Both take the same time, within 5 %.
    Equal,
    /// It does not hold.
    Fails,
}

impl Outcome {
    /// The outcome as a word.
    pub const fn name(self) -> &'static str {
        match self {
            Outcome::Holds => "holds",
            Outcome::Equal => "as fast",
            Outcome::Fails => "does not hold",
        }
    }
}

/// Medians of interleaved rounds on a shared machine are told apart from this share on.
const SAME: f64 = 0.05;

fn faster(ratio: f64) -> Outcome {
    match ratio {
        ratio if ratio < 1.0 - SAME => Outcome::Holds,
        ratio if ratio <= 1.0 + SAME => Outcome::Equal,
        _ => Outcome::Fails,
    }
}

fn slower(ratio: f64) -> Outcome {
    faster(1.0 / ratio)
}

/// At most 1 % slower, or 5 % with the tracing of reflections: told apart no better than by
/// [`SAME`].
fn hardly_slower(ratio: f64) -> Outcome {
    if ratio <= 1.0 + SAME { Outcome::Holds } else { Outcome::Fails }
}

/// Half as slow again or more.
fn considerably_slower(ratio: f64) -> Outcome {
    if ratio >= 1.5 { Outcome::Holds } else { Outcome::Fails }
}

fn quotient(timed: &Timed, names: [&str; 2], part: fn(&Software) -> f64) -> Option<f64> {
    let [a, b] = names.map(|name| timed.of(name).map(part));
    Some(a? / b?)
}

fn against_naive(timed: &Timed, name: &str, part: fn(&Software) -> f64) -> Option<f64> {
    Some(part(timed.of(name)?) / part(timed.naive()?))
}

fn pixel(row: &Software) -> f64 {
    row.pixel_ns
}

fn set_up(row: &Software) -> f64 {
    row.set_up_ns
}

fn total(row: &Software) -> f64 {
    row.total_ns
}

/// The time of the fastest algorithm but Gouraud's, as a multiple of Gouraud's.
fn fastest_of_others(timed: &Timed) -> Option<f64> {
    let gouraud = timed.of("gouraud")?;
    let others = timed.rows.iter().map(|(_, row)| row).filter(|row| row.name != gouraud.name);
    Some(others.map(total).fold(f64::INFINITY, f64::min) / gouraud.total_ns)
}

/// The claims, in the papers' order.
pub const CLAIMS: [SpeedClaim; 16] = [
    SpeedClaim {
        paper: Paper::Lecture,
        what: "Gouraud shading is the fastest of all",
        quantity: "fastest other/Gouraud, all",
        ratio: fastest_of_others,
        judge: slower,
    },
    SpeedClaim {
        paper: Paper::Lecture,
        what: "naive Phong shading is considerably slower than Gouraud shading (half as slow again)",
        quantity: "naive/Gouraud, all",
        ratio: |timed| Some(1.0 / against_naive(timed, "gouraud", total)?),
        judge: considerably_slower,
    },
    SpeedClaim {
        paper: Paper::Lecture,
        what: "fast Phong shading is faster than naive Phong shading",
        quantity: "fast/naive, a pixel",
        ratio: |timed| against_naive(timed, "fast-phong", pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Lecture,
        what: "slerp by increments is faster than naive Phong shading",
        quantity: "slerp/naive, a pixel",
        ratio: |timed| against_naive(timed, "slerp", pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "Duff's scheme is fast Phong shading",
        quantity: "Duff/naive, a pixel",
        ratio: |timed| against_naive(timed, "duff", pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "the hybrid is very fast: faster than Duff's scheme",
        quantity: "hybrid/Duff, a pixel",
        ratio: |timed| quotient(timed, ["hybrid", "duff"], pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "reflection shading avoids normalisation and is faster than Phong shading",
        quantity: "reflection/naive, a pixel",
        ratio: |timed| against_naive(timed, "reflection", pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "an addition for a root: reflection shading is faster than Duff's scheme in the inner loop",
        quantity: "reflection/Duff, a pixel",
        ratio: |timed| quotient(timed, ["reflection", "duff"], pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "but takes more set-up",
        quantity: "reflection/Duff, a span",
        ratio: |timed| quotient(timed, ["reflection", "duff"], set_up),
        judge: slower,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "faster with its set-up too (our question, not a claim)",
        quantity: "reflection/naive, all",
        ratio: |timed| against_naive(timed, "reflection", total),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "a root and its division for two divisions and a root: (34) is probably faster than (33)",
        quantity: "(34)/(33), a pixel",
        ratio: |timed| quotient(timed, ["duff", "duff-quotient"], pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Hast,
        what: "wrapped directions to a lamp and an eye (36 to 38) are faster than normalised ones",
        quantity: "wrapped/naive, a pixel",
        ratio: |timed| against_naive(timed, "phong-wrapped-places", pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Lyon,
        what: "the reformulation may be faster in software",
        quantity: "R - L with f_2/naive, a pixel",
        ratio: |timed| against_naive(timed, "lyon-reflection", pixel),
        judge: faster,
    },
    SpeedClaim {
        paper: Paper::Reshetov,
        what: "consistent normals cost about 1 % of the time (5 % on a CPU)",
        quantity: "consistent/naive, all",
        ratio: |timed| against_naive(timed, "consistent", total),
        judge: hardly_slower,
    },
    SpeedClaim {
        paper: Paper::Reshetov,
        what: "so they do with the trigonometric q",
        quantity: "trigonometric/naive, all",
        ratio: |timed| against_naive(timed, "consistent-trigonometric", total),
        judge: hardly_slower,
    },
    SpeedClaim {
        paper: Paper::Reshetov,
        what: "and in Blinn-Phong shading, of which table 1 is, where each light has normals of its own",
        quantity: "consistent for L and H/Blinn, all",
        ratio: |timed| quotient(timed, ["consistent-normal", "phong-blinn"], total),
        judge: hardly_slower,
    },
];
