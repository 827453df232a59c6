//! Lyon's figure 9: shiny black balls [Lyon, TR 43, appendix, `specular.m`; methods B].
use glam::DVec3;
use specula_spec::FULL_SCALE;

use super::formula::diffuse::lambert;
use super::formula::distributions::{Formulation, formulation};

/// The exponent n of each ball, from the left.
pub const EXPONENTS: [u32; 5] = [1, 4, 16, 64, 256];
/// Diffuse reflectance of every ball, in LSBs.
pub const DIFFUSE: f64 = 35.0;
/// Colour between the balls, in LSBs.
pub const BACKGROUND: f64 = FULL_SCALE;
/// Reflectance of the last ball's highlight, in LSBs.
const BRIGHTEST_SPECULAR: f64 = 400.0;

/// Reflectance of a ball's highlight, in LSBs; for the last two balls it exceeds full scale.
pub fn specular(ball: usize) -> f64 {
    BRIGHTEST_SPECULAR * (f64::from(EXPONENTS[ball]) / 256.0).powf(0.25)
}

/// The lights: one from the right, high and behind; one from the right, low and in front.
pub fn lights() -> [DVec3; 2] {
    [DVec3::new(1.0, 1.0, -1.0), DVec3::new(1.0, -1.0, 1.0)].map(|l| l / 3.0_f64.sqrt())
}

/// The colour of a pixel of a ball with a formula, in LSBs, not clamped to full scale.
pub fn colour(row: Formulation, normal: DVec3, ball: usize) -> f64 {
    let (n, specular) = (EXPONENTS[ball], specular(ball));
    let of_light =
        |l: DVec3| specular * formulation(row, n, normal, l) + DIFFUSE * lambert(normal, l);
    lights().map(of_light).iter().sum()
}

/// The balls in one row of the figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Balls {
    /// Radius of a ball in pixels, Lyon's m: 64 in the report.
    pub radius: u32,
}

impl Balls {
    /// The largest balls of which a row is no larger than `width` times `height` pixels, if there
    /// are any.
    pub fn within(width: u32, height: u32) -> Option<Balls> {
        let across = width.saturating_sub(1) / (1 + EXPONENTS.len() as u32);
        let radius = across.min(height.saturating_sub(1) / 2);
        (radius > 0).then_some(Balls { radius })
    }

    /// Width of a row in pixels: balls are one radius apart.
    pub fn width(self) -> u32 {
        (1 + EXPONENTS.len() as u32) * self.radius + 1
    }

    /// Height of a row in pixels.
    pub fn height(self) -> u32 {
        2 * self.radius + 1
    }

    /// Distance of the figure's rows in pixels, one and a half radii: the upper part of each row
    /// covers the lower part of the next.
    pub fn apart(self) -> u32 {
        2 * self.radius - self.radius / 2
    }

    /// Height of the figure in pixels, from the bottom of its first row to the top of its last.
    pub fn height_of_all(self) -> u32 {
        self.height() + (Formulation::ALL.len() as u32 - 1) * self.apart()
    }

    /// The normal at a pixel, counted from the left and from below, and the number of its ball,
    /// which is the first from the left that covers the pixel.
    pub fn at(self, column: u32, row: u32) -> Option<(DVec3, usize)> {
        let radius = f64::from(self.radius);
        let place = |pixel: u32| (0.5 + f64::from(pixel) - radius) / radius;
        let y = place(row);
        (0..EXPONENTS.len()).find_map(|ball| {
            let x = place(column) - ball as f64;
            let z_squared = 1.0 - x * x - y * y;
            (z_squared >= 0.0).then(|| (DVec3::new(x, y, z_squared.sqrt()), ball))
        })
    }
}
