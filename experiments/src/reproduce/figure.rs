//! Figures of the papers as numbers.

/// A figure: curves over two linear axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The name of its file, without an extension.
    pub name: &'static str,
    /// Its title.
    pub title: String,
    /// The axis from left to right, with its unit.
    pub x: &'static str,
    /// The axis from bottom to top, with its unit.
    pub y: &'static str,
    /// The curves.
    pub curves: Vec<FigureCurve>,
    /// Lines of text below the figure.
    pub notes: Vec<String>,
}

/// A curve of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureCurve {
    /// Its name, in ASCII.
    pub name: String,
    /// The number of its colour; curves that belong together share one.
    pub colour: usize,
    /// Its points, from left to right.
    pub points: Vec<(f64, f64)>,
    /// The index of the point next to which its name stands; `None` if the name is not shown there.
    pub label: Option<usize>,
    /// The origin of the curve.
    pub kind: CurveKind,
}

/// The origin of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// A formula in f64: drawn as a line.
    Formula,
    /// Values of a core, drawn as dots.
    Core,
}

impl FigureCurve {
    /// A formula at `steps` + 1 positions from `low` to `high`, with its name next to the position
    /// that is `label` of the way, 0 to 1.
    pub fn formula(
        name: &str,
        colour: usize,
        (low, high): (f64, f64),
        label: f64,
        f: impl Fn(f64) -> f64,
    ) -> FigureCurve {
        const STEPS: u32 = 200;
        let point = |k: u32| {
            let x = low + (high - low) * f64::from(k) / f64::from(STEPS);
            (x, f(x))
        };
        let points = (0..=STEPS).map(point).collect();
        let label = Some((label * f64::from(STEPS)) as usize);
        FigureCurve { name: name.to_owned(), colour, points, label, kind: CurveKind::Formula }
    }

    /// Values of a core at single positions.
    pub fn core(name: &str, colour: usize, points: Vec<(f64, f64)>) -> FigureCurve {
        FigureCurve { name: name.to_owned(), colour, points, label: None, kind: CurveKind::Core }
    }
}
