//! Lyon's figure 9 drawn by hardware: the balls, and a core for each of the twelve formulas [Lyon,
//! TR 43, appendix].
use glam::DVec3;
use specula_golden::exact::figure9::{self, BACKGROUND, DIFFUSE};
use specula_golden::exact::formula::distributions::Formulation;
use specula_scene::{DirectionalLight, Facet, Frame, Material, Needs, Span, Triangle, VertexCone};
use specula_spec::{CoreOptions, CoreSpec, FULL_SCALE, Method, SpecError};

use specula_testbench::statistics::Sums;
use specula_testbench::{ErrorFigures, Image};

pub use specula_golden::exact::figure9::{Balls, EXPONENTS};

/// A row of the figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FigureRow {
    /// The figure's title of the row, without its number.
    pub title: &'static str,
    /// The formula.
    pub formulation: Formulation,
    /// The method whose core has the formula.
    pub method: Method,
    /// The method's options, as lines of its table in a scene file.
    pub options: &'static [&'static str],
}

/// The rows in the appendix's order. Normals are unit vectors and given at every pixel, as in the
/// appendix, so that nothing is interpolated.
pub const ROWS: [FigureRow; 12] = [
    phong("Phong", Formulation::Phong, &["highlight = \"reflection\""]),
    lyon(
        "D = R - L, k = 0",
        Formulation::Lyon0,
        &[FLAT, "difference = \"reflection-minus-light\"", "squarings = 0"],
    ),
    lyon(
        "D = R - L, k = 1",
        Formulation::Lyon1,
        &[FLAT, "difference = \"reflection-minus-light\"", "squarings = 1"],
    ),
    lyon(
        "D = R - L, k = 2",
        Formulation::Lyon2,
        &[FLAT, "difference = \"reflection-minus-light\"", "squarings = 2"],
    ),
    phong("Blinn D1", Formulation::Blinn, &["highlight = \"blinn\""]),
    lyon(
        "D = H* - N, k = 2",
        Formulation::UnitHalfway,
        &[FLAT, TO_NORMAL, "halfway = \"unit\"", "squarings = 2"],
    ),
    lyon(
        "D = H - projection, k = 2",
        Formulation::Projected,
        &[FLAT, PROJECTED, "halfway = \"half\"", "squarings = 2"],
    ),
    lyon(
        "D = H g2(z) - projection, k = 2",
        Formulation::NearlyUnitProjected2,
        &[FLAT, PROJECTED, "halfway = \"half-g2\"", "squarings = 2"],
    ),
    lyon(
        "D = H g2(z) - projection, k = 1",
        Formulation::NearlyUnitProjected1,
        &[FLAT, PROJECTED, "halfway = \"half-g2\"", "squarings = 1"],
    ),
    lyon(
        "D = H g2(z) - N, k = 2",
        Formulation::NearlyUnit,
        &[FLAT, TO_NORMAL, "halfway = \"half-g2\"", "squarings = 2"],
    ),
    phong(
        "Torrance & Sparrow, Blinn D2",
        Formulation::TorranceSparrow,
        &["highlight = \"torrance-sparrow\""],
    ),
    phong(
        "Trowbridge & Reitz, Blinn D3",
        Formulation::TrowbridgeReitz,
        &["highlight = \"trowbridge-reitz\""],
    ),
];

const FLAT: &str = "normals = \"flat\"";
const TO_NORMAL: &str = "difference = \"unit-halfway-minus-normal\"";
const PROJECTED: &str = "difference = \"unit-halfway-projection\"";

const fn lyon(
    title: &'static str,
    formulation: Formulation,
    options: &'static [&'static str],
) -> FigureRow {
    FigureRow { title, formulation, method: Method::Lyon, options }
}

const fn phong(
    title: &'static str,
    formulation: Formulation,
    options: &'static [&'static str],
) -> FigureRow {
    FigureRow { title, formulation, method: Method::Phong, options }
}

impl FigureRow {
    /// The core for the balls in `frame`.
    ///
    /// # Errors
    /// [`SpecError`] if there is none, which would be a fault of this table.
    pub fn core(&self, frame: &Frame) -> Result<CoreSpec, SpecError> {
        let table: CoreOptions =
            format!("[{}]\n{}", self.method.name(), self.options.join("\n")).parse()?;
        Ok(CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(self.method))?
            .specialised(frame))
    }
}

/// Errors of a row's codes against its formula in f64, clamped to full scale, over all pixels of
/// the balls.
pub fn errors(row: &FigureRow, balls: Balls, simulated: &Image) -> ErrorFigures {
    let mut sums = Sums::default();
    for (x, y, normal, ball) in pixels(balls) {
        let exact = figure9::colour(row.formulation, normal, ball).min(FULL_SCALE);
        let codes = simulated.pixels[(y * simulated.width + x) as usize];
        codes.iter().for_each(|&code| sums.add(f64::from(code) - exact));
    }
    sums.figures()
}

/// The figure in f64: LSBs from the top left, not clamped, [`Balls::width`] times
/// [`Balls::height_of_all`] values.
pub fn exact(balls: Balls) -> Vec<f64> {
    let row = |row: &FigureRow| {
        let mut values = vec![BACKGROUND; balls.width() as usize * balls.height() as usize];
        for (x, y, normal, ball) in pixels(balls) {
            let value = figure9::colour(row.formulation, normal, ball);
            values[(y * balls.width() + x) as usize] = value;
        }
        values
    };
    stacked(balls, BACKGROUND, &ROWS.each_ref().map(row))
}

/// The figure composed from the rows' simulated pictures.
pub fn simulated(balls: Balls, rows: &[Image]) -> Image {
    let rows: Vec<Vec<[u8; 3]>> = rows.iter().map(|row| row.pixels.clone()).collect();
    image(balls, stacked(balls, [BACKGROUND as u8; 3], &rows))
}

/// Values in LSBs, rounded to 8 bits and clamped to full scale.
pub fn rounded(balls: Balls, values: &[f64]) -> Image {
    image(balls, values.iter().map(|value| [value.min(FULL_SCALE).round() as u8; 3]).collect())
}

fn image(balls: Balls, pixels: Vec<[u8; 3]>) -> Image {
    Image { width: balls.width(), height: balls.height_of_all(), pixels }
}

/// The balls as a frame: every pixel is a span of its own with the ball's normal there.
pub fn frame(balls: Balls) -> Frame {
    let (mut triangles, mut spans) = (Vec::new(), Vec::new());
    for (x, y, normal, ball) in pixels(balls) {
        let normals = [normal; 3];
        let cones = normals.map(VertexCone::flat);
        spans.push(Span {
            x,
            y,
            length: 1,
            triangle: triangles.len(),
            start: [1.0, 0.0, 0.0],
            end: [1.0, 0.0, 0.0],
        });
        let (positions, facet) = ([DVec3::ZERO; 3], Facet { normal, middle: DVec3::ZERO });
        triangles.push(Triangle {
            normals,
            facet,
            positions,
            outline: None,
            perspective: None,
            cones,
            material: ball,
        });
    }
    Frame {
        width: balls.width(),
        height: balls.height(),
        background: [BACKGROUND as u8; 3],
        ambient: [0.0; 3],
        lights: figure9::lights()
            .map(|direction| DirectionalLight { direction, colour: [1.0; 3] })
            .to_vec(),
        local_lights: Vec::new(),
        eye: None,
        materials: (0..EXPONENTS.len()).map(material).collect(),
        triangles,
        spans,
    }
}

fn material(ball: usize) -> Material {
    let grey = |lsb: f64| [lsb / FULL_SCALE; 3];
    Material {
        ambient: [0.0; 3],
        diffuse: grey(DIFFUSE),
        specular: grey(figure9::specular(ball)),
        shininess: EXPONENTS[ball],
    }
}

/// Column, row from the top, normal and ball of each pixel, from top to bottom and left to right.
fn pixels(balls: Balls) -> impl Iterator<Item = (u32, u32, DVec3, usize)> {
    let row = move |y: u32| (0..balls.width()).map(move |x| (x, y));
    let shown = move |(x, y): (u32, u32)| {
        balls.at(x, balls.height() - 1 - y).map(|(normal, ball)| (x, y, normal, ball))
    };
    (0..balls.height()).flat_map(row).filter_map(shown)
}

/// Composes rows that overlap. The first one is at the bottom of the figure and covers the next.
///
/// The appendix's program goes through the pixels of a ball from below and writes each into all
/// rows, `pic(ii,jj+dj) = totals`. So of two rows the one wins whose ball is higher there: the
/// upper part of a row covers the lower part of the next.
fn stacked<T: Copy>(balls: Balls, background: T, rows: &[Vec<T>]) -> Vec<T> {
    let (width, height) = (balls.width(), balls.height_of_all());
    let mut figure = vec![background; width as usize * height as usize];
    for (number, row) in rows.iter().enumerate().rev() {
        // There are twelve rows.
        let top = height - balls.height() - number as u32 * balls.apart();
        for (x, y, ..) in pixels(balls) {
            figure[((top + y) * width + x) as usize] = row[(y * width + x) as usize];
        }
    }
    figure
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sums that the appendix's program computes, with its pictures not clamped (methods B).
    #[test]
    fn the_figure_adds_up_to_what_the_program_does() {
        for (radius, sum) in [(16, 1_853_799.137856), (64, 28_579_116.464381)] {
            let got: f64 = exact(Balls { radius }).iter().sum();
            assert!((got - sum).abs() < 1e-5, "radius {radius}: {got} instead of {sum}");
        }
    }

    /// Columns, and rows from below, in which two rows of balls overlap.
    #[test]
    fn the_upper_part_of_a_row_lies_over_the_next() {
        let balls = Balls { radius: 16 };
        let (values, height) = (exact(balls), balls.height_of_all());
        for (x, y, wanted) in [(36, 100, 105.17), (70, 150, 24.16), (25, 25, 122.14)] {
            let got = values[((height - 1 - y) * balls.width() + x) as usize];
            assert!((got - wanted).abs() < 0.005, "column {x}, row {y}: {got}");
        }
    }

    /// Simulated rows are composed as the formulas are: each row has a colour of its own.
    #[test]
    fn simulated_rows_are_laid_in_the_same_order() {
        let balls = Balls { radius: 16 };
        let row = |number: u8| Image::filled(balls.width(), balls.height(), [number; 3]);
        let figure = simulated(balls, &(0..ROWS.len() as u8).map(row).collect::<Vec<_>>());
        let at = |x: u32, y: u32| {
            figure.pixels[((figure.height - 1 - y) * figure.width + x) as usize][0]
        };
        // Rows are 24 pixels apart and 33 high: row 25 is in rows 0 and 1 of balls, 100 in 3 and 4.
        assert_eq!([at(25, 25), at(36, 100), at(25, 40), at(0, 0)], [0, 3, 1, 255]);
    }
}
