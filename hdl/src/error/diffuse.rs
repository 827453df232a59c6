//! How far diffuse intensities are off.
use specula_datapath::bound::VectorBound;

use super::host::HOST_ERROR;

/// Bound on the error of x·y for real vectors no longer than 1.
pub fn cosine(x: VectorBound, y: VectorBound) -> f64 {
    cosine_of(x.error.length, y.error.length)
}

/// The same of vectors off by `e_x` and `e_y` as a whole.
///
/// ```text
/// |x'·y' - x·y| = |(x' - x)·y + x·(y' - y) + (x' - x)·(y' - y)|
///               ≤ e_x + e_y + e_x e_y
/// ```
fn cosine_of(e_x: f64, e_y: f64) -> f64 {
    e_x + e_y + e_x * e_y
}

/// By how much an intensity from 0 to 1 comes outside after `steps` steps at most.
///
/// Start and step are each off by half a unit u of the accumulator's last place:
///
/// ```text
/// |I'(i) - I(i)| ≤ (1 + S) u/2
/// ```
///
/// and half as much again is left to the host, as little as that is.
pub fn overshoot(steps: u32, ulp: f64) -> f64 {
    f64::from(steps + 1) * ulp + HOST_ERROR
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// 90 % of the bound is reached.
    #[test]
    fn cosines_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (e_x, e_y) in [(1e-3, 0.0), (1e-2, 1e-2), (1e-4, 1e-3)] {
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let x = draw.direction();
                let other = draw.direction();
                let y = draw.one_of(&[x, -x, other]);
                let moved_x = x + draw.error(e_x) * y;
                let moved_y = y + draw.error(e_y) * x;
                reached =
                    reached.max((moved_x.dot(moved_y) - x.dot(y)).abs() / cosine_of(e_x, e_y));
            }
            println!("{e_x}, {e_y}: {reached}");
            assert!(reached <= 1.0 + 1e-9 && reached > 0.9, "{e_x}, {e_y}: {reached}");
        }
    }
}
