//! How far cosines to a normal between unit ends are off, which is made of t alone.
use specula_spec::Format;
use specula_spec::direct::DirectFormats;
use specula_spec::format::power_of_two;

use super::host::HOST_ERROR;
use super::interpolate::chord;
use super::newton_root::followed_root;
use super::vector::shortest;
use specula_datapath::bound::{Angular, Bound};

/// What comes of t and κ = |B - A|².
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// e_t, how far t is off.
    pub off: f64,
    /// o, what t reaches past 1.
    pub past: f64,
    /// The largest κ there is.
    pub spread: f64,
}

impl Parameter {
    /// Of t and κ as they come.
    pub fn new(t: Bound, spread: Bound) -> Parameter {
        Parameter { off: t.error, past: past(t), spread: spread.fixed.high }
    }
}

/// o, what t reaches past 1.
pub fn past(t: Bound) -> f64 {
    (t.fixed.high - 1.0).max(0.0)
}

/// How far 0 and 1 are exceeded by q = 1 - κ t (1 - t), with t up to 1 + `past`.
///
/// ```text
/// -o (1 + o) ≤ t (1 - t) ≤ 1/4
/// κ          ≤ 4
/// q          ≥ -4 u_p
/// q          ≤ 1 + 4 o (1 + o) + 4 u_p
/// ```
///
/// with u_p for what t (1 - t) is rounded by, four times, and q itself.
#[derive(Clone, Copy, Debug)]
pub struct Square {
    /// -t (1 - t) is no larger.
    pub below: f64,
    /// q lies from minus this to what it exceeds 1 by.
    pub slack: f64,
}

impl Square {
    /// For t up to 1 + `past`.
    pub fn new(past: f64, formats: &DirectFormats) -> Square {
        Square { below: past * (1.0 + past), slack: 4.0 * formats.product.ulp() }
    }

    /// The largest q.
    pub fn most(self) -> f64 {
        1.0 + 4.0 * self.below + self.slack
    }
}

/// Bound on the error of N·X = A·X + t (B·X - A·X), with t off by e_t and up to 1 + o, and A·X off
/// by `half_unit` as B·X is, whose difference comes no larger than `apart`.
///
/// The host sends B·X - A·X of rounded scalars. Primes are for what comes:
///
/// ```text
/// p' - p   = (1 - t') (a' - a) + t' (b' - b) + (t' - t) (b - a)
/// |p' - p| ≤ (|1 - t'| + t') e + e_t |b - a|
///          ≤ (1 + 2o) e + e_t (|b' - a'| + 2e)
/// ```
fn scalar_between((e_t, past): (f64, f64), half_unit: f64, apart: f64) -> f64 {
    (1.0 + 2.0 * past) * half_unit + (apart + 2.0 * half_unit) * e_t
}

/// Bound on the error of N·X = A·X + t (B·X - A·X), of t, A·X and the difference as they come.
pub fn scalar(t: Bound, start: Bound, delta: Bound) -> f64 {
    scalar_between((t.error, past(t)), start.error, delta.magnitude())
}

/// |N·X| is no larger: both ends are rounded, and t ≤ 1 + o.
pub fn largest_scalar(t: Bound) -> f64 {
    1.0 + 2.0 * past(t)
}

/// Whether fixed and real q are both above 0 for sure.
pub fn is_positive(q: Bound) -> bool {
    q.real.low - q.error > 0.0
}

/// What rounding leaves of N between unit ends: t turns it, and q is that of another.
///
/// ```text
/// N' - N  = (t' - t) (B - A)
/// |B - A| ≤ 2 √(1 - s²)        a chord that comes no nearer than s to the centre
/// ```
#[derive(Clone, Copy, Debug)]
struct Moved {
    /// |B - A| e_t, by how much N is moved along its line.
    by: f64,
    /// m, the length of the shortest N as it is.
    least: f64,
    /// By how much its direction is turned: an angle whose chord is |B - A| e_t/√(s m), s for the
    /// shortest N as it should be and m as it is.
    angle: f64,
    /// o, what t reaches past 1.
    past: f64,
    /// ε, by how much q is off from that of N as it is.
    of_square: f64,
}

impl Moved {
    /// q is off from that of N as it is by
    ///
    /// ```text
    /// (1/4 + o (1 + o)) u_κ/2   the rounding of κ, times t (1 - t)
    /// κ u_p/2                   that of t (1 - t), times κ
    /// u_q/2                     its own
    /// ```
    fn new(t: Parameter, formats: &DirectFormats, shortest: f64) -> Moved {
        let by = chord(shortest) * t.off;
        let least = shortest - by;
        let chord_turned = by / (shortest * least).sqrt();
        let kappa = t.spread.min(chord(shortest).powi(2) + half(formats.spread));
        let t_by_rest = 0.25 + t.past * (1.0 + t.past);
        let of_square = t_by_rest * half(formats.spread)
            + kappa * half(formats.product)
            + half(formats.length_squared);
        let angle = 2.0 * (chord_turned / 2.0).min(1.0).asin();
        Moved { by, least, angle, past: t.past, of_square }
    }

    /// q as it comes is no less, if it is known to be above what 1/√q ends at: m² - ε.
    fn least_square(&self, formats: &DirectFormats) -> Option<f64> {
        let least = self.least * self.least - self.of_square;
        let sure = self.least > 0.0
            && least >= power_of_two(-2 * i64::from(formats.reciprocal.integer_bits));
        (sure && least > self.of_square).then_some(least)
    }

    /// By how much N·X of N as it is is off: the host sends the difference of rounded ends, and it
    /// is rounded itself.
    ///
    /// ```text
    /// (1 + 2o) u_X/2 + u_c/2
    /// ```
    fn of_scalar(&self, formats: &DirectFormats) -> f64 {
        let half = |format: Format| half(format) + HOST_ERROR;
        (1.0 + 2.0 * self.past) * half(formats.component) + half(formats.cosine)
    }
}

fn half(format: Format) -> f64 {
    0.5 * format.ulp()
}

/// What is known of n·X of the unit normal n = N/√q, whatever X, before it is rounded, of t and q as
/// they come; see `unit_normal_from`.
pub fn unit_normal(t: Parameter, q: Bound, formats: &DirectFormats) -> Angular {
    unit_normal_from(t, formats, shortest(q))
}

/// As [`unit_normal`], with 1/d for 1/√q: d by Newton's method with so many steps at each pixel; see
/// `normal_by_newton_from`.
pub fn normal_by_newton(t: Parameter, q: Bound, formats: &DirectFormats, steps: u32) -> Angular {
    normal_by_newton_from(t, formats, shortest(q), followed_root(steps, q, formats))
}

/// What is known of n·X of the unit normal n = N/√q, whatever X, before it is rounded: of N no
/// shorter than `shortest`, with a rounded 1/√q.
///
/// With ε for what q is off from that of N as it is
///
/// ```text
/// x                 = ε/(m² - ε)
/// |√(q/q') - 1|     ≤ x/(2 - x)
/// σ                 = x/(2 - x) + (1 + 2o) u_r/2   with half a unit of 1/√q, times |N·X|
/// |c' - n'·X|       ≤ σ + e_p (1 + σ)/m            with e_p for what N·X is off
/// ```
///
/// where n' is n turned by `Moved`'s angle.
fn unit_normal_from(t: Parameter, formats: &DirectFormats, shortest: f64) -> Angular {
    let moved = Moved::new(t, formats, shortest);
    let Some(least_square) = moved.least_square(formats) else { return Angular::UNKNOWN };
    let x = moved.of_square / least_square;
    let stretch = x / (2.0 - x) + (1.0 + 2.0 * moved.past) * 0.5 * formats.reciprocal.ulp();
    Angular {
        angle: moved.angle,
        rest: stretch + moved.of_scalar(formats) * (1.0 + stretch) / moved.least,
    }
}

/// As `unit_normal_from`, with 1/d for 1/√q: d by Newton's method, off by `root` if anything is known
/// of it, is √q or more.
///
/// The real scalar is r N·X/√q with r = √q/d ≤ 1. r cos x is itself the cosine of an angle, which
/// turns no faster than x:
///
/// ```text
/// r² sin² x ≤ 1 - r² cos² x
/// ```
///
/// What is left is by how much r is off: with d off by e_d and so s - e_d or more
///
/// ```text
/// |√q'/d' - √q/d| ≤ (||N'| - |N|| + e_d)/(s - e_d)
/// ```
///
/// and half a unit of 1/d.
fn normal_by_newton_from(
    t: Parameter,
    formats: &DirectFormats,
    shortest: f64,
    root: Option<f64>,
) -> Angular {
    let moved = Moved::new(t, formats, shortest);
    let Some(error) = root.filter(|_| moved.least > 0.0) else { return Angular::UNKNOWN };
    let least_length = shortest - error;
    let half_unit = (1.0 + 2.0 * moved.past) * 0.5 * formats.reciprocal.ulp();
    let stretch = (moved.by + error) / least_length + half_unit;
    Angular {
        angle: moved.angle,
        rest: stretch + moved.of_scalar(formats) * (1.0 / least_length + half_unit),
    }
}

/// The cosine of a normal, once it is rounded; None where nothing is known of it.
pub fn cosine(normal: Angular, formats: &DirectFormats) -> Option<Angular> {
    let rest = normal.rest + 0.5 * formats.cosine.ulp() + HOST_ERROR;
    Angular { rest, ..normal }.known()
}

/// Bound on the error of a cosine kept within -1 to 1 of which nothing is known: where N may vanish,
/// its real length does not end at 2^-m as 1/√q does, so that rules say nothing of it.
pub const fn any_cosine() -> f64 {
    2.0
}

/// What is known of a product that stands for J K of the unit normal.
#[derive(Clone, Copy, Debug)]
pub struct Product {
    /// By how much the normal is turned.
    angle: f64,
    /// By how much twice the product is off beside that.
    rest: f64,
}

impl Product {
    /// Of J and K as they come, if both are known as cosines.
    pub fn of_bounds(factors: [Bound; 2]) -> Option<Product> {
        let [j, k] = factors.map(Bound::angular);
        Some(Product::of_cosines([j?, k?]))
    }

    /// Of J and K themselves.
    ///
    /// ```text
    /// |J'K' - JK| ≤ r_J + r_K + r_J r_K
    /// ```
    pub fn of_cosines([j, k]: [Angular; 2]) -> Product {
        Product { angle: j.angle, rest: 2.0 * (j.rest + k.rest + j.rest * k.rest) }
    }

    /// Of p_L and p_V/q, of t and q as they come; see `Product::with_quotient_from`.
    pub fn with_quotient(t: Parameter, q: Bound, formats: &DirectFormats) -> Option<Product> {
        Product::with_quotient_from(t, formats, shortest(q))
    }

    /// Of p_L and p_V/q, if N is known to be no shorter than what 1/q ends at.
    ///
    /// For N as it is, no shorter than m, and with p off by e_p
    ///
    /// ```text
    /// |1/q' - 1/q|     ≤ ε/(m² - ε) 1/q + u_r/2
    /// e_k              = e_p max 1/q + ε/(m² - ε)/m + (1 + 2o) u_r/2 + u_c/2   for p_V/q
    /// |p'k' - p k|     ≤ |N| e_k + e_p (1/m + e_k)                             |p_L| ≤ |N|
    /// ```
    fn with_quotient_from(t: Parameter, formats: &DirectFormats, shortest: f64) -> Option<Product> {
        let moved = Moved::new(t, formats, shortest);
        let least_square = moved.least_square(formats)?;
        let longest = 1.0 + 2.0 * moved.past;
        let e_p = moved.of_scalar(formats);
        let largest = 1.0 / least_square + half(formats.reciprocal);
        let of_reciprocal =
            moved.of_square / least_square / moved.least + longest * half(formats.reciprocal);
        let e_k = e_p * largest + of_reciprocal + half(formats.cosine);
        Some(Product {
            angle: moved.angle,
            rest: 2.0 * (longest * e_k + e_p * (1.0 / moved.least + e_k)),
        })
    }

    /// Of 2 J K - L·V = R·L: R turns twice as far as n. The whole is rounded by
    /// `rounding`.
    pub fn base(self, light_dot_view: Bound, rounding: f64) -> Angular {
        Angular { angle: 2.0 * self.angle, rest: self.rest + light_dot_view.error + rounding }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_datapath::bound::Interval;
    use specula_fixtures::Draw;
    use specula_fixtures::formats::direct_formats;

    use super::*;

    fn formats(bits: u32) -> DirectFormats {
        DirectFormats {
            spread: Format::unsigned(3, bits),
            component: Format::signed(1, bits),
            reciprocal: Format::unsigned(3, bits),
            cosine: Format::signed(1, bits),
            ..direct_formats(Format::unsigned(1, bits))
        }
    }

    /// One pixel of a span: what is real, and what comes, each rounding as large as it may be.
    struct Pixel {
        /// N.
        normal: DVec3,
        fixed_t: f64,
        ends: [DVec3; 2],
        /// q as it comes.
        square: f64,
    }

    impl Pixel {
        fn new(draw: &mut Draw, t_off: f64, formats: &DirectFormats, shortest: f64) -> Pixel {
            let angle = 2.0 * shortest.acos();
            let a = draw.direction();
            let b = angle.cos() * a + angle.sin() * draw.across(a);
            let anywhere = draw.within(0.0, 1.0);
            let t = draw.one_of(&[0.5, anywhere]);
            let fixed_t = (t + draw.error(t_off)).clamp(0.0, 1.0);
            let kappa = (b - a).length_squared() + draw.error(half(formats.spread));
            let product = fixed_t * (1.0 - fixed_t) + draw.error(half(formats.product));
            let square = 1.0 - kappa * product + draw.error(half(formats.length_squared));
            Pixel { normal: a + t * (b - a), fixed_t, ends: [a, b], square }
        }

        /// N·X as it comes.
        fn scalar(&self, draw: &mut Draw, x: DVec3, formats: &DirectFormats) -> f64 {
            let [a, b] = self.ends.map(|end| end.dot(x) + draw.error(half(formats.component)));
            a + self.fixed_t * (b - a) + draw.error(half(formats.cosine))
        }

        /// A direction near the normal, or any.
        fn direction(&self, draw: &mut Draw) -> DVec3 {
            let n = self.normal.normalize();
            let slope = draw.one_of(&[0.0, 0.1, 2.0]);
            let [a, b] = self.ends;
            let along = (b - a).reject_from(n).normalize();
            (n + slope * draw.one_of(&[along, -along, n])).normalize()
        }
    }

    /// How far `fixed` is from the cosines of the angles that are no further than `angle` from that
    /// of `real`.
    fn beside(real: f64, fixed: f64, angle: f64) -> f64 {
        let x = real.clamp(-1.0, 1.0).acos();
        let ends = [(x + angle).min(std::f64::consts::PI).cos(), (x - angle).max(0.0).cos()];
        (ends[0] - fixed).max(fixed - ends[1]).max(0.0)
    }

    fn parameter(off: f64, formats: &DirectFormats, shortest: f64) -> Parameter {
        Parameter { off, past: 0.0, spread: chord(shortest).powi(2) + half(formats.spread) }
    }

    /// Largest share of both parts, and of what is beside the angle.
    #[derive(Debug, Default)]
    struct Reached {
        whole: f64,
        rest: f64,
    }

    impl Reached {
        fn take(&mut self, known: Angular, real: f64, fixed: f64) {
            self.whole = self.whole.max((fixed - real).abs() / (known.angle + known.rest));
            self.rest = self.rest.max(beside(real, fixed, known.angle) / known.rest);
        }

        fn within(&self) -> bool {
            self.whole <= 1.0 && self.rest <= 1.0
        }
    }

    const SPANS: [(f64, u32, f64); 3] = [(0.9, 12, 1e-3), (0.5, 16, 1e-6), (0.99, 10, 1e-4)];

    /// Of spans narrow and wide: 90 % of what the bound allows beside the angle is reached.
    #[test]
    fn cosines_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        for (shortest, bits, off) in SPANS {
            let formats = formats(bits);
            let known = unit_normal_from(parameter(off, &formats, shortest), &formats, shortest);
            let mut reached = Reached::default();
            for _ in 0..60_000 {
                let pixel = Pixel::new(&mut draw, off, &formats, shortest);
                let x = pixel.direction(&mut draw);
                let root = 1.0 / pixel.square.sqrt() + draw.error(half(formats.reciprocal));
                let fixed = pixel.scalar(&mut draw, x, &formats) * root;
                reached.take(known, pixel.normal.normalize().dot(x), fixed);
            }
            assert!(reached.within() && reached.rest > 0.9, "{shortest}: {reached:?} {known:?}");
        }
    }

    /// The same of a d that is √q or more: 60 % of what is allowed beside the angle is reached.
    #[test]
    fn cosines_by_newton_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        for (shortest, bits, off) in SPANS {
            let formats = formats(bits);
            let of_root = 2.0 * formats.length.ulp();
            let t = parameter(off, &formats, shortest);
            let known = normal_by_newton_from(t, &formats, shortest, Some(of_root));
            let mut reached = Reached::default();
            for _ in 0..60_000 {
                let pixel = Pixel::new(&mut draw, off, &formats, shortest);
                let x = pixel.direction(&mut draw);
                let d = pixel.normal.length() * draw.one_of(&[1.0, 1.01]);
                let fixed_d = d + draw.error(of_root);
                let root = 1.0 / fixed_d + draw.error(half(formats.reciprocal));
                let fixed = pixel.scalar(&mut draw, x, &formats) * root;
                reached.take(known, pixel.normal.dot(x) / d, fixed);
            }
            assert!(reached.within() && reached.rest > 0.6, "{shortest}: {reached:?} {known:?}");
        }
    }

    /// Twice the product of p_L and p_V/q: half of the bound is reached.
    #[test]
    fn bases_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        for (shortest, bits, off) in SPANS {
            let formats = formats(bits);
            let t = parameter(off, &formats, shortest);
            let known = Product::with_quotient_from(t, &formats, shortest)
                .unwrap()
                .base(Bound::near(Interval::ANY, 0.0), 0.0);
            let mut reached = Reached::default();
            for _ in 0..60_000 {
                let pixel = Pixel::new(&mut draw, off, &formats, shortest);
                let [l, v] = [0; 2].map(|_| pixel.direction(&mut draw));
                let [p_l, p_v] = [l, v].map(|x| pixel.scalar(&mut draw, x, &formats));
                let reciprocal = 1.0 / pixel.square + draw.error(half(formats.reciprocal));
                let k = p_v * reciprocal + draw.error(half(formats.cosine));
                let n = pixel.normal.normalize();
                let base = |product: f64| 2.0 * product - l.dot(v);
                reached.take(known, base(n.dot(l) * n.dot(v)), base(p_l * k));
            }
            assert!(reached.within() && reached.whole > 0.5, "{shortest}: {reached:?} {known:?}");
        }
    }

    /// 95 % of the bound is reached.
    #[test]
    fn scalars_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        let formats = formats(12);
        let half_unit = half(formats.component);
        for (off, past) in [(1e-3, 0.0), (1e-5, 0.01)] {
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let ends = [0; 2].map(|_| draw.within(-1.0, 1.0));
                let anywhere = draw.within(0.0, 1.0);
                let t = draw.one_of(&[anywhere, 1.0]);
                let fixed_t = (t + draw.error(off)).clamp(0.0, 1.0 + past);
                let [a, b] = ends.map(|end| end + draw.error(half_unit));
                let (real, fixed) = (ends[0] + t * (ends[1] - ends[0]), a + fixed_t * (b - a));
                let bound = scalar_between((off, past), half_unit, (b - a).abs());
                reached = reached.max((fixed - real).abs() / bound);
            }
            assert!(reached <= 1.0 && reached > 0.95, "{off}, {past}: {reached}");
        }
    }

    /// Of opposite ends, where q vanishes: half of what is allowed below 0 is reached.
    #[test]
    fn squares_leave_their_range_by_no_more_than_stated() {
        let mut draw = Draw::new(1);
        let formats = formats(8);
        for past in [0.0, 0.03] {
            let square = Square::new(past, &formats);
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let anywhere = draw.within(0.0, 1.0 + past);
                let t = draw.one_of(&[0.5, anywhere]);
                let product = t * (1.0 - t);
                assert!(-square.below <= product && product <= 0.25);
                let q = 1.0 - 4.0 * (product + draw.error(half(formats.product)));
                assert!(q <= square.most());
                reached = reached.max(-q / square.slack);
            }
            assert!((0.5..=1.0).contains(&reached), "{reached}");
        }
    }
}
