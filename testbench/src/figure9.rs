//! Lyon's figure 9 from hardware: the balls, and a core for each of the twelve formulas [Lyon, TR 43, appendix].
use glam::DVec3;
use specula_golden::exact::distributions::Formulation;
use specula_golden::exact::figure9::{self, BACKGROUND, DIFFUSE};
use specula_scene::spec::{CoreOptions, FULL_SCALE, SpecError};
use specula_scene::{CoreSpec, DirectionalLight, Facet, Frame, Material, Method, Needs, Span, Triangle, VertexCone};

use crate::statistics::Sums;
use crate::{ErrorFigures, Image};

pub use specula_golden::exact::figure9::{Balls, EXPONENTS};

/// A row of the figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// What the figure calls it, number apart.
    pub title: &'static str,
    /// The formula.
    pub formulation: Formulation,
    /// The method that has it.
    pub method: Method,
    /// The method's options, as its table in a scene file has them.
    pub options: &'static [&'static str],
}

/// The rows in the appendix's order. Normals are unit vectors and given at every pixel, as in the appendix, so that nothing is interpolated.
pub const ROWS: [Row; 12] = [
    phong("Phong", Formulation::Phong, &["highlight = \"reflection\""]),
    lyon("D = R - L, k = 0", Formulation::Lyon0, &[FLAT, "difference = \"reflection-minus-light\"", "squarings = 0"]),
    lyon("D = R - L, k = 1", Formulation::Lyon1, &[FLAT, "difference = \"reflection-minus-light\"", "squarings = 1"]),
    lyon("D = R - L, k = 2", Formulation::Lyon2, &[FLAT, "difference = \"reflection-minus-light\"", "squarings = 2"]),
    phong("Blinn D1", Formulation::Blinn, &["highlight = \"blinn\""]),
    lyon("D = H* - N, k = 2", Formulation::UnitHalfway, &[FLAT, TO_NORMAL, "halfway = \"unit\"", "squarings = 2"]),
    lyon("D = H - projection, k = 2", Formulation::Projected, &[FLAT, PROJECTED, "halfway = \"half\"", "squarings = 2"]),
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
    lyon("D = H g2(z) - N, k = 2", Formulation::NearlyUnit, &[FLAT, TO_NORMAL, "halfway = \"half-g2\"", "squarings = 2"]),
    phong("Torrance & Sparrow, Blinn D2", Formulation::TorranceSparrow, &["highlight = \"torrance-sparrow\""]),
    phong("Trowbridge & Reitz, Blinn D3", Formulation::TrowbridgeReitz, &["highlight = \"trowbridge-reitz\""]),
];

const FLAT: &str = "normals = \"flat\"";
const TO_NORMAL: &str = "difference = \"unit-halfway-minus-normal\"";
const PROJECTED: &str = "difference = \"unit-halfway-projection\"";

const fn lyon(title: &'static str, formulation: Formulation, options: &'static [&'static str]) -> Row {
    Row { title, formulation, method: Method::Lyon, options }
}

const fn phong(title: &'static str, formulation: Formulation, options: &'static [&'static str]) -> Row {
    Row { title, formulation, method: Method::Phong, options }
}

impl Row {
    /// The core for the balls in `frame`.
    ///
    /// # Errors
    /// [`SpecError`] if there is none, which would be a fault of this table.
    pub fn core(&self, frame: &Frame) -> Result<CoreSpec, SpecError> {
        let table: CoreOptions = format!("[{}]\n{}", self.method.name(), self.options.join("\n")).parse()?;
        Ok(CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(self.method))?.specialised(frame))
    }
}

/// A row's pixels in f64, up to full scale.
pub struct Formula {
    /// Rounded to 8 bits.
    pub picture: Image,
    /// What a picture is off by, over all pixels of balls.
    pub error: ErrorFigures,
}

impl Formula {
    /// What a row should be, and how far `simulated` is off.
    pub fn of(row: &Row, balls: Balls, simulated: &Image) -> Formula {
        let mut picture = background(balls);
        let mut sums = Sums::default();
        for (x, y, normal, ball) in pixels(balls) {
            let exact = figure9::colour(row.formulation, normal, ball).min(FULL_SCALE);
            let place = (y * picture.width + x) as usize;
            picture.pixels[place] = [exact.round() as u8; 3];
            simulated.pixels[place].iter().for_each(|&code| sums.add(f64::from(code) - exact));
        }
        Formula { picture, error: sums.figures() }
    }
}

/// The balls as a frame: every pixel is a span of its own, with the ball's normal there.
pub fn frame(balls: Balls) -> Frame {
    let (mut triangles, mut spans) = (Vec::new(), Vec::new());
    for (x, y, normal, ball) in pixels(balls) {
        let normals = [normal; 3];
        let cones = normals.map(VertexCone::flat);
        spans.push(Span { x, y, length: 1, triangle: triangles.len(), start: [1.0, 0.0, 0.0], end: [1.0, 0.0, 0.0] });
        let (positions, facet) = ([DVec3::ZERO; 3], Facet { normal, middle: DVec3::ZERO });
        triangles.push(Triangle { normals, facet, positions, cones, material: ball });
    }
    Frame {
        width: balls.width(),
        height: balls.height(),
        background: [BACKGROUND as u8; 3],
        ambient: [0.0; 3],
        lights: figure9::lights().map(|direction| DirectionalLight { direction, colour: [1.0; 3] }).to_vec(),
        local_lights: Vec::new(),
        eye: None,
        materials: (0..EXPONENTS.len()).map(material).collect(),
        triangles,
        spans,
    }
}

fn material(ball: usize) -> Material {
    let grey = |lsb: f64| [lsb / FULL_SCALE; 3];
    Material { ambient: [0.0; 3], diffuse: grey(DIFFUSE), specular: grey(figure9::specular(ball)), shininess: EXPONENTS[ball] }
}

fn background(balls: Balls) -> Image {
    Image::filled(balls.width(), balls.height(), [BACKGROUND as u8; 3])
}

/// Column and row from the top, normal and ball of each pixel, from top to bottom and left to right.
fn pixels(balls: Balls) -> impl Iterator<Item = (u32, u32, DVec3, usize)> {
    let row = move |y: u32| (0..balls.width()).map(move |x| (x, y));
    let shown = move |(x, y): (u32, u32)| balls.at(x, balls.height() - 1 - y).map(|(normal, ball)| (x, y, normal, ball));
    (0..balls.height()).flat_map(row).filter_map(shown)
}

/// Pictures of the rows laid over each other as the figure has them, the first at the bottom.
pub fn stacked(balls: Balls, rows: &[Image]) -> Image {
    let height = balls.height_of_all();
    let mut figure = Image::filled(balls.width(), height, [BACKGROUND as u8; 3]);
    for (number, row) in (0..).zip(rows) {
        let top = height - balls.height() - number * balls.apart();
        for (x, y, ..) in pixels(balls) {
            figure.pixels[((top + y) * figure.width + x) as usize] = row.pixels[(y * row.width + x) as usize];
        }
    }
    figure
}
