//! Lyon's figure 9, five spheres shaded by twelve formulas; its sum is known from elsewhere (METHODS.md B).
use glam::DVec3;
use specula_golden::exact::diffuse::lambert;
use specula_golden::exact::distributions::{Formulation, formulation};

const FORMULAS: usize = Formulation::ALL.len();
const EXPONENTS: [u32; 5] = [1, 4, 16, 64, 256];
const BACKGROUND: f64 = 255.0;
const DIFFUSE: f64 = 35.0;
const BRIGHTEST_SPECULAR: f64 = 400.0;

/// The first sphere from the left that covers the point, as its normal there and its number.
fn sphere_at(x: f64, y: f64) -> Option<(DVec3, usize)> {
    (0..EXPONENTS.len()).find_map(|sphere| {
        let x = x - sphere as f64;
        let z_squared = 1.0 - x * x - y * y;
        (z_squared >= 0.0).then(|| (DVec3::new(x, y, z_squared.sqrt()), sphere))
    })
}

fn colours(normal: DVec3, sphere: usize) -> [f64; FORMULAS] {
    let lights = [DVec3::new(1.0, 1.0, -1.0), DVec3::new(1.0, -1.0, 1.0)].map(|l| l / 3.0_f64.sqrt());
    let n = EXPONENTS[sphere];
    let specular = BRIGHTEST_SPECULAR * (f64::from(n) / 256.0).powf(0.25);
    let shaded =
        lights.map(|l| Formulation::ALL.map(|row| specular * formulation(row, n, normal, l) + DIFFUSE * lambert(normal, l)));
    std::array::from_fn(|formula| shaded[0][formula] + shaded[1][formula])
}

/// Sum of the picture with spheres of `radius` pixels, pictures of the formulas 1.5 radii apart, each over those before it.
fn picture_sum(radius: i32) -> f64 {
    let apart = (2 * radius - radius / 2) as usize;
    let rows = (2 * radius + 1) as usize + (FORMULAS - 1) * apart;
    (-radius..=radius * EXPONENTS.len() as i32).map(|i| column_sum(i, radius, apart, rows)).sum()
}

/// Sum of what lies at one x, of every formula's picture.
fn column_sum(i: i32, radius: i32, apart: usize, rows: usize) -> f64 {
    let at = |pixel: i32| (0.5 + f64::from(pixel)) / f64::from(radius);
    let mut column = vec![BACKGROUND; rows];
    for (row, j) in (-radius..=radius).enumerate() {
        if let Some((normal, sphere)) = sphere_at(at(i), at(j)) {
            for (formula, colour) in colours(normal, sphere).into_iter().enumerate() {
                column[row + formula * apart] = colour;
            }
        }
    }
    column.iter().sum()
}

#[test]
fn the_picture_adds_up() {
    for (radius, sum) in [(16, 1_853_799.137856), (64, 28_579_116.464381)] {
        let got = picture_sum(radius);
        assert!((got - sum).abs() < 1e-5, "radius {radius}: {got} instead of {sum}");
    }
}
