//! How far wrapped normals that follow one another are off.
use specula_datapath::bound::{Bound, VectorBound};
use specula_spec::lyon::LyonFormats;

/// What n = N + u H is made of, H = N + b and u = (1 - N·N)/(H·H), with b the n of the pixel before
/// or some w.
#[derive(Clone, Copy, Debug)]
pub struct Followed {
    /// e_N, how far N is off.
    normal: f64,
    /// e_w, how far w is off.
    axis: f64,
    /// e_y, how far y = 1 - N·N is off.
    residue: f64,
    /// s, the length of N where it is shortest.
    shortest: f64,
}

/// What one pixel adds.
struct Step {
    /// u, how much of b's error goes on.
    kept: f64,
    /// What is added to that.
    added: f64,
}

impl Followed {
    /// Of N, of the w that the first normal is wrapped around, and of y = 1 - N·N.
    pub fn new(normal: VectorBound, axis: VectorBound, residue: Bound) -> Followed {
        Followed {
            normal: normal.error.length,
            axis: axis.error.length,
            residue: residue.error,
            shortest: normal.shortest,
        }
    }

    /// Bound on the error of n, in any direction.
    ///
    /// As a function of b, N and y, n has the derivatives
    ///
    /// ```text
    /// ∂n/∂b = u (1 - 2ĤĤᵀ)       an isometry times u
    /// ∂n/∂N = 1 + u (1 - 2ĤĤᵀ)
    /// ∂n/∂y = H/|H|²
    /// ```
    ///
    /// so with b off by e
    ///
    /// ```text
    /// |n' - n| ≤ u e + (1 + u) e_N + e_y/|H| + roundings
    /// ```
    ///
    /// Around a fixed w within 90 degrees of N, |H|² ≥ 1 + s². Spans that follow turn by 120
    /// degrees at most, so s ≥ 1/2, and N stays within 30 degrees of b: in narrow ones all do; in
    /// others N turns by 12.5 degrees a step at most, of which a wrap leaves a third, 19 degrees in
    /// all.
    ///
    /// ```text
    /// |H|² ≥ 1 + s² + √3 s
    /// u    ≤ .36
    /// e    ≤ added/(1 - u)      where all errors end
    /// ```
    ///
    /// The first pixel of a span that follows has the error of w, no more than what following ends
    /// at. Where the bound is too coarse for `Followed::step`, two unit vectors are no further
    /// apart than 2.
    pub fn error(self, formats: &LyonFormats) -> f64 {
        let around_fixed = self.step(self.shortest, 1.0 + self.shortest * self.shortest, formats);
        let s = self.shortest.max(0.5);
        let following = self.step(s, 1.0 + s * s + 3f64.sqrt() * s, formats);
        let ends_at = self.axis.max(following.added / (1.0 - following.kept));
        let error = (around_fixed.kept * self.axis + around_fixed.added).max(ends_at);
        if error + self.normal <= SHORTER_BY { error } else { 2.0 }
    }

    /// One pixel, with N no shorter than `s` and H·H no less than `h_squared`.
    ///
    /// As long as e + e_N ≤ 1/16, H as it comes is shorter by no more. Roundings add
    ///
    /// ```text
    /// u_o u/(2|H|)           half a unit of H·H, over |H|² and times u |H|
    /// u_r |H|/2 ≤ 1.1 u_r    half a unit of u
    /// √3/2 u_v               half a unit of each component of n
    /// ```
    fn step(self, s: f64, h_squared: f64, formats: &LyonFormats) -> Step {
        let (e_n, e_y) = (self.normal, self.residue);
        let h = h_squared.sqrt() - SHORTER_BY;
        let u = (1.0 - s * s + e_y) / (h * h);
        let rounding = formats.wrap_operand.ulp() * u / (2.0 * h)
            + 1.1 * formats.wrap_ratio.ulp()
            + 0.75f64.sqrt() * formats.vector.ulp();
        Step { kept: u, added: (1.0 + u) * e_n + e_y / h + rounding }
    }
}

/// By how much H as it comes may be shorter.
const SHORTER_BY: f64 = 0.0625;

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_fixtures::Draw;
    use specula_spec::Format;

    use super::*;

    const OPERAND: f64 = 1.0 / 4096.0;
    const RATIO: f64 = 1.0 / 8192.0;
    const VECTOR: f64 = 1.0 / 4096.0;

    /// Errors of one pixel, each drawn as large as it may be.
    fn fixed(draw: &mut Draw, of: Followed, n: DVec3, b: DVec3) -> DVec3 {
        let y = 1.0 - n.length_squared() + draw.error(of.residue);
        let n = n + draw.error(of.normal) * draw.direction();
        let h = n + b;
        let u = y / (h.length_squared() + draw.error(0.5 * OPERAND)) + draw.error(0.5 * RATIO);
        let mut rounding = || draw.error(0.5 * VECTOR);
        n + u * h + DVec3::new(rounding(), rounding(), rounding())
    }

    fn real(n: DVec3, b: DVec3) -> DVec3 {
        let h = n + b;
        n + (1.0 - n.length_squared()) / h.length_squared() * h
    }

    fn formats() -> LyonFormats {
        let any = Format::unsigned(1, 12);
        LyonFormats {
            weight_accumulator: any,
            weight: any,
            normal_accumulator: any,
            vector: any,
            wrap_operand: any,
            wrap_ratio: Format::unsigned(1, 13),
            length_squared: any,
            gain: any,
            way_accumulator: any,
            product: Format::signed(3, 24),
            diffuse: any,
            difference: any,
            root_shininess: any,
            shininess_share: any,
            scaled_difference: any,
            shape: any,
        }
    }

    /// Spans that turn by up to 120 degrees, around fixed vectors and following: 70 % of the bound
    /// is reached.
    #[test]
    fn followed_normals_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        for (degrees, normal, residue) in [(20.0, 1e-3, 1e-4), (100.0, 1e-4, 1e-3)] {
            let angle = f64::to_radians(degrees);
            let of = Followed { normal, axis: 2e-4, residue, shortest: (0.5 * angle).cos() };
            let bound = of.error(&formats());
            let mut reached = 0.0_f64;
            for _ in 0..2000 {
                let start = draw.direction();
                let end = angle.cos() * start + angle.sin() * draw.across(start);
                let at = |t: f64| start + t * (end - start);
                let off_axis = draw.error(of.axis) * draw.direction();
                let (mut n, mut b) = (start, start + off_axis);
                for i in 0..=20 {
                    let (mean, axis) = (at(f64::from(i) / 20.0), (start + end).normalize());
                    let around = fixed(&mut draw, of, mean, axis + off_axis) - real(mean, axis);
                    (n, b) = (real(mean, n), fixed(&mut draw, of, mean, b));
                    reached = reached.max(around.length().max((b - n).length()) / bound);
                }
            }
            assert!(reached <= 1.0 && reached > 0.7, "{degrees} degrees: {reached}");
        }
    }

    #[test]
    fn too_coarse_ones_are_off_by_anything() {
        let of = Followed { normal: 0.05, axis: 0.05, residue: 0.0, shortest: 1.0 };
        assert_eq!(of.error(&formats()), 2.0);
    }
}
