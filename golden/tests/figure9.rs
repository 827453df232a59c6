//! Lyon's figure 9, five spheres shaded by twelve formulas; its sum is known from elsewhere (METHODS.md B).
use glam::DVec3;
use specula_golden::exact::diffuse::lambert;
use specula_golden::exact::normalisation::g2;
use specula_golden::exact::reflection::{halfway, reflect, reflection_minus_light};
use specula_golden::exact::shape::{f_k, power};

const FORMULAS: usize = 12;
const EXPONENTS: [u32; 5] = [1, 4, 16, 64, 256];
const BACKGROUND: f64 = 255.0;
const DIFFUSE: f64 = 35.0;
const BRIGHTEST_SPECULAR: f64 = 400.0;

/// The twelve formulas, in the order of the paper's appendix. h = H/2 goes with 4n.
fn formulas(normal: DVec3, light: DVec3, n: u32) -> [f64; FORMULAS] {
    let exponent = f64::from(n);
    let x = exponent / 2.0 * reflection_minus_light(normal, light).length_squared();
    let half = halfway(light) / 2.0;
    let (approximate, true_unit) = (g2(half.length_squared()) * half, half / half.length());
    let x_of = |d: DVec3| 2.0 * exponent * d.length_squared();
    let projected = |h: DVec3| x_of(h - h.dot(normal) * normal);
    let cosine = true_unit.dot(normal);
    [
        power(reflect(normal).dot(light), n),
        f_k(x, 0),
        f_k(x, 1),
        f_k(x, 2),
        power(cosine, 4 * n),
        f_k(x_of(true_unit - normal), 2),
        f_k(projected(half), 2),
        f_k(projected(approximate), 2),
        f_k(projected(approximate), 1),
        f_k(x_of(approximate - normal), 2),
        (-2.0 * exponent * cosine.clamp(-1.0, 1.0).acos().powi(2)).exp(),
        trowbridge_reitz(cosine.max(0.0), exponent),
    ]
}

fn trowbridge_reitz(cosine: f64, n: f64) -> f64 {
    (1.0 + (1.0 - cosine * cosine) * n).powi(-2)
}

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
    let shaded = lights.map(|l| formulas(normal, l, n).map(|f| specular * f + DIFFUSE * lambert(normal, l)));
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
