//! Figure 5: a square whose shading depends on how it stands to the scan lines.
use glam::{DVec2, DVec3};
use specula_golden::exact::formula::diffuse::lambert;
use specula_golden::exact::formula::scan_line::along_scan_line;
use specula_spec::FULL_SCALE;
use specula_testbench::Image;

use super::super::claim::{Claim, Ruling, exact};
use crate::stress::draw::tilted;

/// The square's corners, one above, then clockwise. It stands on a corner: a square that stands on
/// a side is shaded the same after a quarter turn.
const CORNERS: [DVec2; 4] = [DVec2::Y, DVec2::X, DVec2::NEG_Y, DVec2::NEG_X];
/// The corner that is grey: its normal is 60 degrees from the light, the others' are along it.
const GREY: usize = 2;
const LIGHT: DVec3 = DVec3::Z;

fn normals() -> [DVec3; 4] {
    std::array::from_fn(|corner| if corner == GREY { tilted(60.0) } else { LIGHT })
}

/// What is interpolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Intensities.
    Gouraud,
    /// Normals.
    Phong,
}

impl Shading {
    /// The intensity of a polygon at a point, 0 to 1.
    fn at(self, corners: &[DVec2], normals: &[DVec3], point: DVec2) -> Option<f64> {
        match self {
            Shading::Gouraud => {
                let intensities: Vec<f64> = normals.iter().map(|n| lambert(*n, LIGHT)).collect();
                along_scan_line(corners, &intensities, point)
            }
            Shading::Phong => along_scan_line(corners, normals, point)
                .map(|normal| lambert(normal.normalize_or_zero(), LIGHT)),
        }
    }
}

/// Whether the square is turned to the scan lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stand {
    /// The grey corner is below.
    Upright,
    /// A quarter turn, with which the grey corner is at the right.
    Turned,
}

impl Stand {
    fn place(self, point: DVec2) -> DVec2 {
        match self {
            Stand::Upright => point,
            Stand::Turned => point.perp(),
        }
    }
}

/// The intensity at a point of the square, given in the square's own coordinates.
fn square(shading: Shading, stand: Stand, point: DVec2) -> Option<f64> {
    let corners = CORNERS.map(|corner| stand.place(corner));
    shading.at(&corners, &normals(), stand.place(point))
}

/// The same of the square cut in two triangles, from the corner above to the grey one or across.
fn halves(shading: Shading, cut: usize, stand: Stand, point: DVec2) -> Option<f64> {
    let normals = normals();
    let half = |corners: [usize; 3]| {
        let places = corners.map(|corner| stand.place(CORNERS[corner]));
        shading.at(&places, &corners.map(|corner| normals[corner]), stand.place(point))
    };
    let corner = |k: usize| (cut + k) % 4;
    half([corner(0), corner(1), corner(2)]).or_else(|| half([corner(2), corner(3), corner(0)]))
}

/// Points in a row of the grid on which differences are sought.
const GRID: i32 = 100;

/// The largest difference in LSBs between two shadings over the square.
fn difference(one: impl Fn(DVec2) -> Option<f64>, other: impl Fn(DVec2) -> Option<f64>) -> f64 {
    let points = (-GRID..=GRID).flat_map(|x| (-GRID..=GRID).map(move |y| (x, y)));
    let places = points.map(|(x, y)| DVec2::new(x.into(), y.into()) / f64::from(GRID));
    places
        .filter_map(|point| Some((one(point)? - other(point)?).abs()))
        .fold(0.0, |a, b| f64::max(a, FULL_SCALE * b))
}

fn turned(shading: Shading) -> f64 {
    difference(
        |point| square(shading, Stand::Upright, point),
        |point| square(shading, Stand::Turned, point),
    )
}

const DEPENDS: &str = "figure 5: a quadrilateral's shading depends on its orientation";
const TRIANGLES: &str = "that of a triangle does not";
const CUTS: &str = "but which triangles it is cut in matters";

const fn more(what: &'static str, quantity: &'static str, lsb: f64, measure: fn() -> f64) -> Claim {
    exact(what, quantity, (lsb, 5e-3), measure, |lsb| Ruling::of(lsb > 0.5, "it is the same"))
}

const fn none(quantity: &'static str, measure: fn() -> f64) -> Claim {
    exact(TRIANGLES, quantity, (0.0, 1e-9), measure, |lsb| Ruling::of(lsb < 1e-9, "it does too"))
}

/// Claims about figure 5. The numbers are those of a scan converter of its own, in Python, on the
/// same grid.
pub(in crate::reproduce) const CLAIMS: [Claim; 5] = [
    more(DEPENDS, "largest difference in LSB, Gouraud", 63.75, || turned(Shading::Gouraud)),
    more(DEPENDS, "largest difference in LSB, Phong", 48.189, || turned(Shading::Phong)),
    none("largest difference in LSB, the square's halves, Gouraud", || {
        halved_and_turned(Shading::Gouraud)
    }),
    none("largest difference in LSB, the square's halves, Phong", || {
        halved_and_turned(Shading::Phong)
    }),
    more(CUTS, "largest difference in LSB between both cuts, Gouraud", 63.75, || {
        difference(
            |point| halves(Shading::Gouraud, 0, Stand::Upright, point),
            |point| halves(Shading::Gouraud, 1, Stand::Upright, point),
        )
    }),
];

fn halved_and_turned(shading: Shading) -> f64 {
    difference(
        |point| halves(shading, 0, Stand::Upright, point),
        |point| halves(shading, 0, Stand::Turned, point),
    )
}

/// Pixels from the square's middle to its corners in pictures.
const RADIUS: i32 = 80;

/// The square in both stands, each turned back so that its grey corner is below, with their titles.
pub fn pictures(shading: Shading) -> [(&'static str, Image); 2] {
    let picture = |stand| {
        let size = 2 * RADIUS as u32 + 1;
        let mut image = Image::filled(size, size, [0; 3]);
        let places = (-RADIUS..=RADIUS).flat_map(|y| (-RADIUS..=RADIUS).map(move |x| (x, -y)));
        for (pixel, (x, y)) in image.pixels.iter_mut().zip(places) {
            let point = DVec2::new(x.into(), y.into()) / f64::from(RADIUS);
            if let Some(intensity) = square(shading, stand, point) {
                *pixel = [(FULL_SCALE * intensity).round() as u8; 3];
            }
        }
        image
    };
    match shading {
        Shading::Gouraud => [
            ("Gouraud", picture(Stand::Upright)),
            ("Gouraud, a quarter turn", picture(Stand::Turned)),
        ],
        Shading::Phong => {
            [("Phong", picture(Stand::Upright)), ("Phong, a quarter turn", picture(Stand::Turned))]
        }
    }
}
