//! How far scalars along an arc are off, and the base of the highlight made of them.
//!
//! N = c A + s T for orthonormal A and T, with (c, s) = (cos t, sin t) from a rotation; N' is the same
//! of the weights as they come. [lecture, eq. 4.5, 4.7; methods A10]
use specula_spec::Format;
use specula_spec::slerp::SlerpFormats;

use super::host::HOST_ERROR;
use super::rotation::{drift, drift_across, sum_of_components};
use specula_datapath::bound::Angular;

/// e: how far (c, s) is off once it is rounded to weights, as a distance in the plane, after `steps`
/// steps at most; so |N' - N| ≤ e and |N'| ≤ 1 + e.
pub fn weights(formats: &SlerpFormats, steps: u32) -> f64 {
    drift(formats, steps) + 0.5f64.sqrt() * formats.weight.ulp()
}

/// N'·X = c A·X + s T·X of a unit vector X is no larger. A·X and T·X are off by half a unit u of
/// their last place each:
///
/// ```text
/// |N'·X| ≤ |N'||X|
///        ≤ (1 + e)(1 + 2u)
/// ```
pub fn largest_scalar(formats: &SlerpFormats, steps: u32) -> f64 {
    (1.0 + weights(formats, steps)) * (1.0 + 2.0 * formats.component.ulp())
}

/// c² + s² is no larger: (1 + e)².
pub fn largest_square(formats: &SlerpFormats, steps: u32) -> f64 {
    let longest = 1.0 + weights(formats, steps);
    longest * longest
}

/// What is known of the base 2 J K (2 - N'·N') - L·V with J = N'·L and K = N'·V, of spans of `steps`
/// + 1 pixels with normals no shorter than `shortest_normal`.
///
/// 1. The angle. Spans turn by f at most, cos(f/2) ≥ `shortest_normal`, and |cos t| + |sin t| ≤ κ up
///    to f. Of N' - N no more than x lies across N: what the rotation drifts across, and κ half
///    units of the weights. n = N'/|N'| and N are apart by
///
///    ```text
///    angle(n, N) ≤ atan(x/(1 - e))
///                ≤ asin e
///    ```
///
///    and R turns by twice that.
///
/// 2. What N' is too long or too short by. With z = N'·N' = |N'|², |z - 1| ≤ q = 2e + e²:
///
///    ```text
///    z (2 - z) = 1 - (1 - z)²
///    |2 J K (2 - z) - 2 n·L n·V| ≤ 2q²
///    ```
///
/// 3. Roundings, u_x of scalars, u_c of cosines and u_b of the base, half units each with what the
///    host adds:
///
///    ```text
///    |c| + |s| ≤ κ + √2 e
///    e_J = e_K ≤ (κ + √2 e) u_x + u_c                   N'·X of rounded scalars
///    e_K'      ≤ e_K (1 + q) + (1 + e + e_K) u_c + u_c  K' = K (2 - z)
///    e_JK'     ≤ (1 + e) e_K' + (1 + e)(1 + q) e_J + e_J e_K'
///    rest      ≤ 2q² + 2 e_JK' + u_x + u_b              L·V is a scalar, too
///    ```
pub fn base(formats: &SlerpFormats, steps: u32, shortest_normal: f64) -> Angular {
    let e = weights(formats, steps);
    let widest = 2.0 * shortest_normal.clamp(0.0, 1.0).acos();
    let kappa = sum_of_components(widest);
    let across = drift_across(formats, steps, widest) + 0.5 * kappa * formats.weight.ulp();
    let half = |format: Format| 0.5 * format.ulp() + HOST_ERROR;
    let (scalar, own) = (half(formats.component), half(formats.cosine));
    let (length, stretch) = (1.0 + e, 2.0 * e + e * e);
    let e_j = (kappa + 2f64.sqrt() * e) * scalar + own;
    let e_k = e_j * (1.0 + stretch) + (length + e_j) * own + own;
    let product = length * e_k + length * (1.0 + stretch) * e_j + e_j * e_k;
    let least_along = (1.0 - e).max(0.0);
    Angular {
        angle: 2.0 * across.atan2(least_along).min(e.min(1.0).asin()),
        rest: 2.0 * stretch * stretch + 2.0 * product + scalar + half(formats.base),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_fixtures::Draw;

    use super::*;

    /// The least significant bits of rotation and weights, of scalars, and of cosines and base.
    fn formats(turned: u32, component: u32, cosine: u32) -> SlerpFormats {
        let [turned, component, cosine] =
            [turned, component, cosine].map(|bits| Format::signed(1, bits));
        SlerpFormats {
            turn: turned,
            state: turned,
            scaled_state: turned,
            weight: turned,
            vector: turned,
            component,
            cosine,
            way_accumulator: cosine,
            way_root: cosine,
            diffuse: cosine,
            base: cosine,
            shape: cosine,
        }
    }

    /// How much is reached of the angle and of the rest, for weights as far off as they come, each
    /// rounding at one of its ends, and vectors mostly near N.
    fn reached(formats: &SlerpFormats, steps: u32, shortest_normal: f64) -> [f64; 2] {
        let proven = base(formats, steps, shortest_normal);
        let e = weights(formats, steps);
        let widest = 2.0 * shortest_normal.acos();
        let across = drift_across(formats, steps, widest)
            + 0.5 * sum_of_components(widest) * formats.weight.ulp();
        let [scalar, own, last] =
            [formats.component, formats.cosine, formats.base].map(|format| 0.5 * format.ulp());
        let mut draw = Draw::new(1);
        let mut reached = [0.0_f64; 2];
        for _ in 0..100_000 {
            let (a, t) = (DVec3::X, DVec3::Y);
            let angle = draw.within(0.0, widest);
            let n = angle.cos() * a + angle.sin() * t;
            let x = draw.error(across.min(e));
            let along = draw.error((e * e - x * x).max(0.0).sqrt());
            let turned = n * (1.0 + along) + x * DVec3::Z.cross(n);
            let [l, v] = [0; 2].map(|_| (n + draw.within(0.0, 1.5) * draw.direction()).normalize());

            let mut dot = |x: DVec3| {
                let [at_start, across] = [a, t].map(|axis| axis.dot(x) + draw.error(scalar));
                turned.x * at_start + turned.y * across + draw.error(own)
            };
            let (j, k) = (dot(l), dot(v));
            let correction = 2.0 - turned.length_squared() + draw.error(own);
            let k = k * correction + draw.error(own);
            let fixed = 2.0 * j * k - l.dot(v) + draw.error(scalar) + draw.error(last);

            let reflection = |n: DVec3| (2.0 * n.dot(v) * n - v).normalize();
            let r = reflection(turned.normalize());
            reached[0] = reached[0].max(r.angle_between(reflection(n)) / proven.angle);
            reached[1] = reached[1].max((fixed - r.dot(l)).abs() / proven.rest);
        }
        reached
    }

    /// 99 % of the angle is reached, and 88 % of the rest.
    #[test]
    fn bases_stay_within_the_bound_and_reach_it() {
        for (turned, component, cosine, shortest) in
            [(12, 12, 12, 0.9), (16, 10, 20, 0.99), (20, 20, 12, 0.5)]
        {
            let [angle, rest] = reached(&formats(turned, component, cosine), 20, shortest);
            println!("{turned}, {component}, {cosine}: {angle} and {rest}");
            assert!(angle <= 1.0 + 1e-6 && rest <= 1.0);
            assert!(angle > 0.99 && rest > 0.88, "{turned}, {component}, {cosine}");
        }
    }
}
