//! Figures of the papers, as numbers.

/// A figure: curves over two linear axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The name of its file, without an ending.
    pub name: &'static str,
    /// What it shows.
    pub title: String,
    /// The axis from left to right, with its unit.
    pub x: &'static str,
    /// The axis from bottom to top, with its unit.
    pub y: &'static str,
    /// What is drawn.
    pub curves: Vec<Curve>,
    /// Lines of words below it.
    pub notes: Vec<String>,
}

/// A curve of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What it is, in ASCII.
    pub name: String,
    /// The number of its colour; curves that belong together share one.
    pub colour: usize,
    /// Its points, from left to right.
    pub points: Vec<(f64, f64)>,
    /// The point beside which its name stands; none where it has no name beside it.
    pub label: Option<usize>,
    /// What it stands for.
    pub kind: CurveKind,
}

/// What a curve stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// A formula in f64: drawn as a line.
    Formula,
    /// What a core gives: drawn as dots.
    Core,
}

impl Curve {
    /// A formula at `steps` + 1 places from `low` to `high`, with its name beside the place that is
    /// `label` of the way, 0 to 1.
    pub fn formula(
        name: &str,
        colour: usize,
        (low, high): (f64, f64),
        label: f64,
        f: impl Fn(f64) -> f64,
    ) -> Curve {
        const STEPS: u32 = 200;
        let point = |k: u32| {
            let x = low + (high - low) * f64::from(k) / f64::from(STEPS);
            (x, f(x))
        };
        let points = (0..=STEPS).map(point).collect();
        let label = Some((label * f64::from(STEPS)) as usize);
        Curve { name: name.to_owned(), colour, points, label, kind: CurveKind::Formula }
    }

    /// What a core gives, at single places.
    pub fn of_core(name: &str, colour: usize, points: Vec<(f64, f64)>) -> Curve {
        Curve { name: name.to_owned(), colour, points, label: None, kind: CurveKind::Core }
    }
}
