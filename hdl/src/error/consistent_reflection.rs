//! How far reflections are off that never point into the surface.
use specula_datapath::bound::{Angular, Bound, VectorBound, VectorError};
use specula_spec::Format;
use specula_spec::consistent::ConsistentFormats;

/// What r = (g + ρb)n - ρI is made of, b = n·I and g = 1 + q(b - 1), as it comes.
#[derive(Clone, Copy, Debug)]
pub struct Reflection {
    /// n and I.
    pub vectors: [VectorBound; 2],
    /// q.
    pub q: Bound,
    /// b and g.
    pub cosines: [Bound; 2],
    /// q(1 + g) and 1 + b, of which ρ² is the quotient.
    pub operands: [Bound; 2],
    /// The smallest 1 + b for which the reflection counts.
    pub least_divisor: f64,
}

impl Reflection {
    /// How far r is off as a whole, and each component, before it is rounded; fixed r is no longer
    /// than `longest`.
    pub fn error(self, formats: &ConsistentFormats, longest: f64) -> (VectorError, f64) {
        let [normal, incoming] = self.vectors;
        let known = Consistency { least_q: self.q.real.low, least_divisor: self.least_divisor };
        let error = |bound: Bound| bound.error;
        let of_components = Components {
            vectors: [normal.component_error, incoming.component_error],
            cosines: self.cosines.map(error),
            operands: self.operands.map(error),
            longest: normal.longest,
        };
        let of_whole = Operands { normal: normal.error, incoming: incoming.error, q: self.q.error };
        reflection(of_components.error(formats, known), of_whole.off(formats, known), longest)
    }
}

/// What is known of the real values, for error bounds alone.
#[derive(Clone, Copy, Debug)]
struct Consistency {
    /// The smallest q there is.
    least_q: f64,
    /// The smallest 1 + N·I for which the reflection counts.
    least_divisor: f64,
}

/// Bounds on the errors of what each component of r = (g + ρb)n - ρI is made of.
#[derive(Clone, Copy, Debug)]
struct Components {
    /// e_n and e_I, of each component of n and I.
    vectors: [f64; 2],
    /// e_b and e_g, of b = n·I and g = 1 + q(b - 1).
    cosines: [f64; 2],
    /// Of the operands q(1 + g) and w = 1 + b of ρ².
    operands: [f64; 2],
    /// How long n is at most.
    longest: f64,
}

impl Components {
    /// Bound on the error of a component, the last rounding apart.
    ///
    /// ```text
    /// r        = g n + ρ (b n - I)
    /// g n      off by e_n + e_g
    /// b n - I  off by e_n + e_b + e_I   with the true ρ
    /// g + ρb   rounded by u/2, times |n|
    /// ```
    ///
    /// and what ρ is off by counts as often as bN - I is long: see `of_sine_ratio`.
    fn error(self, formats: &ConsistentFormats, known: Consistency) -> f64 {
        let [dividend, divisor] = self.operands;
        let e_rho = of_sine_ratio(dividend + divisor, divisor, formats, known);
        let ([e_n, e_i], [e_b, e_g]) = (self.vectors, self.cosines);
        let roundings = 0.5 * formats.cosine.ulp() * self.longest;
        2.0 * e_n + e_g + e_b + e_i + e_rho + roundings
    }
}

/// What the error of ρ adds to a component of ρ(bN - I), with E for the errors of q(1 + g) and of
/// w = 1 + b together and u for half a unit of the last place of ρ².
///
/// ```text
/// |bN - I|   ≤ √(1 - b²) ≤ √(2w)
/// |ρ'² - ρ²| ≤ δ = E/(w - e_w) + u
/// |ρ' - ρ|   ≤ √δ
/// |ρ' - ρ|   ≤ δ/ρ ≤ δ/q                    since 1 + g ≥ q(1 + b)
/// ```
///
/// - Where w ≥ 2 e_w, w - e_w ≥ w/2 and √(2w) √δ ≤ √(4E + 4u); where w is smaller, √(2w) ≤ √(4E)
///   and ρ is off by 1 at most.
/// - Where w is no less than some w_0 > e_w, √(2w) δ/q ≤ (√(2/w_0) E/(1 - e_w/w_0) + 2u)/q.
fn of_sine_ratio(operands: f64, e_w: f64, formats: &ConsistentFormats, known: Consistency) -> f64 {
    let Consistency { least_q: q, least_divisor: w } = known;
    let half_unit = 0.5 * formats.sine_ratio_squared.ulp();
    let anywhere = (4.0 * operands + 4.0 * half_unit).sqrt();
    let far = ((2.0 / w).sqrt() * operands / (1.0 - e_w / w) + 2.0 * half_unit) / q;
    let error = if q > 0.0 && w > 2.0 * e_w { anywhere.min(far) } else { anywhere };
    error + 0.5 * formats.sine_ratio.ulp()
}

/// What the reflection is made of, and how far each of it is off.
#[derive(Clone, Copy, Debug)]
struct Operands {
    /// n.
    normal: VectorError,
    /// I.
    incoming: VectorError,
    /// q.
    q: f64,
}

impl Operands {
    /// How far the reflection is off as a whole where it is known to turn with the normal; the last
    /// rounding apart.
    ///
    /// Let m and J be the directions of n and I as they come, turned by a and a_I, and σ, σ_I what
    /// their lengths are off. r is compared with the reflection of J about m with q as it comes,
    /// and that with the real one.
    ///
    /// Roundings: `Rounded` bounds how far this moves r as a whole, and along r.
    ///
    /// Turns: r turns by 2a and a_I at most, and with q, since
    ///
    /// ```text
    /// sin(γ/2) = √q sin(β/2)
    /// γ'       ≤ √q
    /// dγ/dq    = sin(β/2)/(√q cos(γ/2)) ≤ 1/√(q w_0/2)
    /// ```
    ///
    /// Where ρ is clamped, β is beyond a right angle and g + b ≤ 0. With -b_0 the least b
    ///
    /// ```text
    /// r    = (g + b)N - I
    /// |r|² = 1 + g² - b² ≥ 1 - b_0²
    /// ```
    ///
    /// moves by (2 + 2b_0) a + 3 a_I + 2 e_q at most, of which 2 b_0 (a + a_I + e_q) over |r| makes
    /// it longer or shorter. What roundings move along the one reflection is along the other but
    /// for the angle between them.
    fn off(self, formats: &ConsistentFormats, known: Consistency) -> Option<VectorError> {
        let (a, a_i) = (self.normal.angle(), self.incoming.angle());
        let e_q = self.q;
        let half_units = [formats.cosine, formats.sine_ratio_squared, formats.sine_ratio]
            .map(|format| 0.5 * format.ulp());
        let least = [known.least_divisor - a - a_i, known.least_q - e_q];
        let stretches = [self.normal, self.incoming].map(VectorError::stretch);
        let rounded = Rounded::new(stretches, half_units, least)?;
        let Rounded { w, q: least_q, b_0, shortest, .. } = rounded;
        let clamped = 2.0 * b_0 * (a + a_i + e_q) / shortest;
        let rest = rounded.length() + clamped;
        let turned =
            (2.0 + 2.0 * b_0) * a + 3.0 * a_i + e_q * (least_q * w / 2.0).sqrt().recip().max(2.0);
        let along = rounded.along() + clamped + rest * turned / shortest + turned * turned / 2.0;
        Some(VectorError {
            length: turned + rest,
            transverse: (turned + rest) / shortest,
            radial: along.min(rest + turned * turned / 2.0),
            isotropic: 0.0,
        })
    }
}

/// How far the reflection is off, in all and in each component.
///
/// Whatever both are, components are no further apart than the longest of both are long: the real
/// one 1, the fixed one `longest`.
fn reflection(component: f64, whole: Option<VectorError>, longest: f64) -> (VectorError, f64) {
    let component = component.min(1.0 + longest);
    let off = whole.unwrap_or(VectorError::ball(3f64.sqrt() * component));
    (off, component.min(off.length))
}

/// What lengths and roundings move the reflection r of J about m by, two unit vectors whose b = m·J
/// is -b_0 or more, with q as it comes.
///
/// Let n and I be longer than m and J by the factors 1 + σ and 1 + σ_I, τ = (1 + σ)(1 + σ_I) - 1,
/// and u half a unit of cosines' last place. What is computed, with primes, is
///
/// ```text
/// b' = b + δ_b            |δ_b| ≤ |b| τ + u
/// g' = g + q δ_b + η      |η| ≤ u
/// s' = g' + ρ'b' + ε      |ε| ≤ u            the share of n
/// r' = s'n - ρ'I
/// ```
///
/// So with δ_g = q δ_b + η and δ_ρ = ρ' - ρ
///
/// ```text
/// r' - r = (δ_g + ρ'δ_b + ε + σ s') m + δ_ρ (b m - J) - ρ' σ_I J.
/// ```
///
/// ρ² = q(1 + g)/w with w = 1 + b, whose rounding is v, half a unit of its last place, is off by
///
/// ```text
/// ((q² - ρ²) δ_b + q η)/(w + δ_b) + v
/// ≤ (|δ_b| + u)/(w - |δ_b|) + v      since q² and q are ρ² at most, and ρ² 1
/// ≤ x ρ²                             x = (|δ_b| + u)/(w - |δ_b|) + v/q
/// ```
///
/// Clamping both squares to 1 brings them no further apart, and for a ρ² beyond 1 the same holds
/// with 1 in its place. The root moves by what its square does over ρ + ρ' ≥ ρ/κ, κ = 1/(1 + √(1 -
/// x)); and by its own rounding.
#[derive(Clone, Copy, Debug)]
struct Rounded {
    /// σ, σ_I and τ.
    sigma: f64,
    sigma_i: f64,
    tau: f64,
    /// u.
    half_unit: f64,
    /// Half a unit of the last place of ρ² and of ρ.
    of_squared: f64,
    of_root: f64,
    /// The smallest w and q there are.
    w: f64,
    q: f64,
    /// -b_0 is the smallest b there is, if that is negative.
    b_0: f64,
    /// √(1 - b_0²), as short as r is at most.
    shortest: f64,
    /// x and κ.
    x: f64,
    kappa: f64,
}

impl Rounded {
    /// None where too little is known of w or q; half units are those of cosines, ρ² and ρ.
    fn new(
        [sigma, sigma_i]: [f64; 2],
        [half_unit, of_squared, of_root]: [f64; 3],
        [w, q]: [f64; 2],
    ) -> Option<Rounded> {
        let tau = (1.0 + sigma) * (1.0 + sigma_i) - 1.0;
        let (e_b, b_0) = (tau + half_unit, (1.0 - w).max(0.0));
        let x = (e_b + half_unit) / (w - e_b) + of_squared / q;
        if !(w > 2.0 * e_b && q > 0.0 && b_0 < 0.9 && x < 1.0) {
            return None;
        }
        let (shortest, kappa) = ((1.0 - b_0 * b_0).sqrt(), 1.0 / (1.0 + (1.0 - x).sqrt()));
        Some(Rounded {
            sigma,
            sigma_i,
            tau,
            half_unit,
            of_squared,
            of_root,
            w,
            q,
            b_0,
            shortest,
            x,
            kappa,
        })
    }

    /// What r is off by as a whole.
    ///
    /// |bm - J| ≤ √(2w) ≤ 2 and ρ ≥ √q: what ρ is off by moves r by
    ///
    /// ```text
    /// κ (√(2/w) (|δ_b| + u)/(1 - |δ_b|/w) + 2v/√q)
    /// ```
    ///
    /// and by 2 times its rounding.
    fn length(self) -> f64 {
        let Rounded { sigma, sigma_i, tau, half_unit: u, w, q, kappa, .. } = self;
        let e_b = tau + u;
        let of_rho = kappa
            * ((2.0 / w).sqrt() * (e_b + u) / (1.0 - e_b / w) + 2.0 * self.of_squared / q.sqrt())
            + 2.0 * self.of_root;
        (e_b + u) + e_b + u + sigma * (2.0 + self.second_order()) + sigma_i + of_rho
    }

    /// |s'| is no larger than 1 + |b| and this.
    fn second_order(self) -> f64 {
        2.0 * (self.tau + self.half_unit) + 2.0 * self.half_unit + self.x + self.of_root
    }

    /// What r is longer or shorter by, to first order in the turn that roundings are.
    ///
    /// m·r = g, |g| ≤ 1, and (bm - J)·r = ρ(1 - b²): what ρ is off by makes r longer or shorter by
    /// no more than
    ///
    /// ```text
    /// κ (1 - b)(|δ_b| + u)/(1 - |δ_b|/w)
    /// ```
    ///
    /// κ v and the root's rounding. With λ = κ/(1 - |δ_b|/w), all that depends on b is no more than
    ///
    /// ```text
    /// τ(1 + 3|b|) + 4u + λ(1 - b)(|b|τ + 2u).
    /// ```
    ///
    /// From b = 0 on b(1 - b) ≤ 1 - b, which leaves something linear in b, largest at 0 or 1; below
    /// 0 it grows with |b|, and r may be shorter than 1.
    fn along(self) -> f64 {
        let Rounded { tau, half_unit: u, b_0, .. } = self;
        let lambda = self.kappa / (1.0 - (tau + u) / self.w);
        let anywhere = self.sigma * self.second_order()
            + self.sigma_i
            + self.kappa * self.of_squared
            + self.of_root;
        let upright = 4.0 * tau + 4.0 * u;
        let level = tau + 4.0 * u + lambda * (tau + 2.0 * u);
        let below =
            tau * (1.0 + 3.0 * b_0) + 4.0 * u + lambda * (1.0 + b_0) * (b_0 * tau + 2.0 * u);
        (upright.max(level) + anywhere).max((below + anywhere) / self.shortest)
    }
}

/// How far it is known which side of the horizon I is on: by how much g + b is off there at most.
#[derive(Clone, Copy, Debug)]
pub struct Horizon(f64);

impl Horizon {
    /// Of n and I, and of q, with cosines in this format.
    ///
    /// With u for half a unit of cosines' last place, and fixed n no longer than ℓ
    ///
    /// ```text
    /// b = n·I            off by e_b = e_n + ℓ e_I + u
    /// g = 1 + q (b - 1)  off by q e_b + (1 - b) e_q + u
    /// g + b              off by (1 + q) e_b + (1 - b) e_q + u
    /// ```
    ///
    /// Where g + b is no further from 0 than it is off, by h,
    ///
    /// ```text
    /// 1 - b ≤ (2 + h)/(1 + q)
    /// h     ≤ (1 + q) e_b + (2 + h)/(1 + q) e_q + u
    /// ```
    ///
    /// which is convex in q, so largest for a q of 0 or 1.
    pub fn new([normal, incoming]: [VectorBound; 2], q: Bound, cosine: Format) -> Horizon {
        let half_unit = 0.5 * cosine.ulp();
        let e_b = normal.error.length + normal.longest.max(1.0) * incoming.error.length + half_unit;
        let (e_q, rest) = (q.error, half_unit);
        let of = |q: f64| {
            let of_q = e_q / (1.0 + q);
            let off = (1.0 + q) * e_b + 2.0 * of_q + rest;
            if of_q < 1.0 { off / (1.0 - of_q) } else { f64::INFINITY }
        };
        Horizon(of(0.0).max(of(1.0)))
    }

    /// The smallest 1 + b of an I above the horizon: 1 + b > 2q/(1 + q) ≥ q.
    pub fn least_divisor(self, q: Bound) -> f64 {
        (q.real.low - self.0).max(0.0)
    }

    /// What is known of |I + r|/2, of I above the horizon and r.
    ///
    /// It is the cosine of half the angle between two unit vectors. Turns of both change that angle;
    /// what they are too long or too short by, σ and σ_I, moves their sum by no more than both:
    ///
    /// ```text
    /// angle ≤ (turn of I + turn of r)/2
    /// rest  ≤ (σ_I + σ)/2 + u/2
    /// ```
    pub fn cosine([incoming, r]: [VectorBound; 2], to: Format) -> Angular {
        let errors = [incoming.error, r.error];
        let half_sum = |of: fn(VectorError) -> f64| 0.5 * (of(errors[0]) + of(errors[1]));
        Angular {
            angle: half_sum(VectorError::angle),
            rest: half_sum(VectorError::stretch) + 0.5 * to.ulp(),
        }
    }

    /// How large |I + r|/2, off by `cosine`, is at most where rounding decides which side of the
    /// horizon I is on; 1 where it may decide whether the normal has a direction.
    ///
    /// At the horizon
    ///
    /// ```text
    /// (N_c·I)² ≤ (g + b)/2
    /// ```
    ///
    /// which rounding moves by e_g + e_b at most.
    pub fn most_at_edge(self, cosine: Angular, has_direction: Bound) -> f64 {
        let most = (self.0 / 2.0).sqrt() + cosine.angle + cosine.rest;
        if has_direction.is_exact() { most.min(1.0) } else { 1.0 }
    }
}

/// What is known of r·L, clamped to [0, 1] and rounded: the cosine of r's angle with L, but for what
/// r is longer or shorter by, σ, and L is off, e_L.
///
/// ```text
/// |r'·L' - r̂'·L| ≤ σ + (1 + σ) e_L + u/2
/// ```
pub fn highlight(r: VectorBound, l: VectorBound, base: Format) -> Angular {
    let stretch = r.error.stretch();
    let rest = stretch + (1.0 + stretch) * l.error.length + 0.5 * base.ulp();
    Angular { angle: r.error.angle(), rest }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_datapath::bound::Interval;
    use specula_fixtures::Draw;

    use super::*;

    /// J and its reflection in the plane of both, m along the second axis, computed with every
    /// rounding at its worst.
    fn off(b: f64, q: f64, of: Rounded, signs: [f64; 7]) -> ([f64; 2], [f64; 2]) {
        let [of_n, of_i, of_b, of_g, of_share, of_squared, of_root] = signs;
        let j = [(1.0 - b * b).sqrt(), b];
        let reflected = |b: f64, g: f64, rho: f64, [longer, longer_i]: [f64; 2], rounding: f64| {
            let share = g + rho * b + rounding;
            [-rho * longer_i * j[0], share * longer - rho * longer_i * j[1]]
        };
        let g = 1.0 + q * (b - 1.0);
        let squared = |b: f64, g: f64| (q * (1.0 + g) / (1.0 + b)).clamp(0.0, 1.0);
        let real = reflected(b, g, squared(b, g).sqrt(), [1.0, 1.0], 0.0);
        let (longer, longer_i) = (1.0 + of_n * of.sigma, 1.0 + of_i * of.sigma_i);
        let b = (b * longer * longer_i + of_b * of.half_unit).clamp(-1.0, 1.0);
        let g = 1.0 + q * (b - 1.0) + of_g * of.half_unit;
        let rho = ((squared(b, g) + of_squared * of.of_squared).clamp(0.0, 1.0).sqrt()
            + of_root * of.of_root)
            .min(1.0);
        (real, reflected(b, g, rho, [longer, longer_i], of_share * of.half_unit))
    }

    /// 40 % of what is allowed as a whole is reached, and 70 % of what is allowed along.
    #[test]
    fn roundings_move_a_reflection_by_no_more_than_stated() {
        let signs =
            |bits: u32| std::array::from_fn(|i| if bits >> i & 1 == 1 { 1.0 } else { -1.0 });
        for (w, least_q) in [(1.0, 0.8), (0.7, 0.3), (0.4, 0.1)] {
            let of = Rounded::new([1e-3, 3e-4], [2e-4, 1e-5, 1e-4], [w, least_q]).unwrap();
            let (mut length, mut along) = (0.0_f64, 0.0_f64);
            for (i, j, bits) in (0..=50)
                .flat_map(|i| (0..=10).flat_map(move |j| (0..128).map(move |bits| (i, j, bits))))
            {
                let (b, q) = (
                    w - 1.0 + (2.0 - w) * f64::from(i) / 50.0,
                    least_q + (1.0 - least_q) * f64::from(j) / 10.0,
                );
                let (real, fixed) = off(b, q, of, signs(bits));
                let moved = [fixed[0] - real[0], fixed[1] - real[1]];
                length = length.max(moved[0].hypot(moved[1]));
                along = along
                    .max((moved[0] * real[0] + moved[1] * real[1]).abs() / real[0].hypot(real[1]));
            }
            assert!(length <= of.length() && length > 0.4 * of.length());
            assert!(along <= of.along() && along > 0.7 * of.along());
        }
    }

    fn formats(bits: u32) -> ConsistentFormats {
        let (one, signed) = (Format::unsigned(1, bits), Format::signed(1, bits));
        ConsistentFormats {
            weight_accumulator: one,
            weight: one,
            vector: signed,
            length_squared: one,
            gain: one,
            angle_accumulator: signed,
            angle: one,
            tangent: one,
            contraction: one,
            cosine: signed,
            sine_ratio_squared: one,
            sine_ratio: one,
            way_accumulator: signed,
            diffuse: one,
            base: one,
            shape: one,
        }
    }

    /// ρ of q, g and b.
    fn sine_ratio(q: f64, g: f64, b: f64) -> f64 {
        (q * (1.0 + g) / (1.0 + b)).clamp(0.0, 1.0).sqrt()
    }

    /// r of real vectors.
    fn reflected(n: DVec3, incoming: DVec3, q: f64) -> DVec3 {
        let b = n.dot(incoming);
        let g = 1.0 + q * (b - 1.0);
        let rho = sine_ratio(q, g, b);
        (g + rho * b) * n - rho * incoming
    }

    /// r as it comes, with every rounding as large as it may be.
    fn rounded(
        draw: &mut Draw,
        n: DVec3,
        incoming: DVec3,
        q: f64,
        formats: &ConsistentFormats,
    ) -> DVec3 {
        let mut half = |format: Format| draw.error(0.5 * format.ulp());
        let b = (n.dot(incoming) + half(formats.cosine)).clamp(-1.0, 1.0);
        let g = 1.0 + q * (b - 1.0) + half(formats.cosine);
        let squared = sine_ratio(q, g, b).powi(2) + half(formats.sine_ratio_squared);
        let rho = (squared.clamp(0.0, 1.0).sqrt() + half(formats.sine_ratio)).min(1.0);
        let share = g + rho * b + half(formats.cosine);
        share * n - rho * incoming
    }

    /// Vectors turned and stretched as far as they may be: 40 % of what is allowed as a whole and
    /// along is reached.
    #[test]
    fn reflections_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        let formats = formats(14);
        for (w, least_q, across, along) in
            [(1.0, 0.8, 1e-3, 1e-4), (0.7, 0.3, 1e-4, 1e-3), (1.0, 0.5, 1e-5, 1e-5)]
        {
            let known = Consistency { least_q, least_divisor: w };
            let off = VectorError::components(across, along);
            let of = Operands { normal: off, incoming: off, q: 1e-5 };
            let bound = of.off(&formats, known).unwrap();
            let (mut length, mut lengthened) = (0.0_f64, 0.0_f64);
            for _ in 0..60_000 {
                let (n, beside) = {
                    let n = draw.direction();
                    (n, draw.across(n))
                };
                let b = draw.within(w - 1.0, 1.0);
                let incoming = b * n + (1.0 - b * b).sqrt() * beside;
                let q = draw.within(least_q, 1.0);
                let real = reflected(n, incoming, q);
                let mut moved =
                    |v: DVec3, aside: DVec3| v + draw.error(across) * aside + draw.error(along) * v;
                let fixed_n = moved(n, beside);
                let fixed_incoming = moved(incoming, (n - b * incoming).normalize_or(n));
                let q = (q + draw.error(of.q)).min(1.0);
                let error = rounded(&mut draw, fixed_n, fixed_incoming, q, &formats) - real;
                length = length.max(error.length() / bound.length);
                lengthened = lengthened.max(error.dot(real.normalize()).abs() / bound.radial);
            }
            assert!(length <= 1.0 && lengthened <= 1.0, "{w}: {length}, {lengthened}");
            assert!(length > 0.4 && lengthened > 0.4, "{w}: {length}, {lengthened}");
        }
    }

    /// b from anywhere, also where hardly anything is known of w: 30 % of the bound is reached. It
    /// has √(2w) for √(1 - b²), and ρ for ρ + ρ'.
    #[test]
    fn what_the_sine_ratio_is_off_stays_within_the_bound_and_comes_near() {
        let mut draw = Draw::new(1);
        let formats = formats(14);
        for (least_q, least_divisor, operand) in [(0.0, 0.0, 1e-4), (0.9, 1.0, 1e-3)] {
            let known = Consistency { least_q, least_divisor };
            let bound = of_sine_ratio(2.0 * operand, operand, &formats, known);
            let mut reached = 0.0_f64;
            for _ in 0..60_000 {
                let w = least_divisor + (2.0 - least_divisor) * draw.within(0.0, 1.0).powi(4);
                let q = least_q + (1.0 - least_q) * draw.within(0.0, 1.0).powi(4);
                let (b, dividend) = (w - 1.0, q * (2.0 + q * (w - 2.0)));
                let squared = |p: f64, w: f64| if w > 0.0 { (p / w).clamp(0.0, 1.0) } else { 0.0 };
                let real = squared(dividend, w).sqrt();
                let fixed = squared(dividend + draw.error(operand), w + draw.error(operand))
                    + draw.error(0.5 * formats.sine_ratio_squared.ulp());
                let fixed =
                    fixed.clamp(0.0, 1.0).sqrt() + draw.error(0.5 * formats.sine_ratio.ulp());
                let error = (fixed - real).abs() * (1.0 - b * b).max(0.0).sqrt();
                reached = reached.max(error / bound);
            }
            assert!(reached <= 1.0 && reached > 0.3, "{known:?}: {reached}");
        }
    }

    /// Unit vectors turned and stretched as far as they may be: 90 % of the angle is reached, and of
    /// the rest.
    #[test]
    fn half_the_angle_between_them_stays_within_the_bound_and_comes_near() {
        let mut draw = Draw::new(1);
        let format = Format::unsigned(1, 14);
        for (across, along) in [(1e-3, 1e-4), (1e-4, 1e-3)] {
            let mut vector = VectorBound::ball(1.0, 1.0, across);
            vector.error = VectorError::components(across, along);
            let bound = Horizon::cosine([vector; 2], format);
            let mut reached = [0.0_f64; 2];
            for _ in 0..40_000 {
                let x = draw.direction();
                let beside = draw.across(x);
                let angle = draw.within(0.0, 3.1);
                let y = angle.cos() * x + angle.sin() * beside;
                let beside_y = angle.cos() * beside - angle.sin() * x;
                let moved_x = x * (1.0 + draw.error(along)) + draw.error(across) * beside;
                let moved_y = y * (1.0 + draw.error(along)) + draw.error(across) * beside_y;
                let turned = 0.5 * moved_x.angle_between(moved_y);
                let fixed = 0.5 * (moved_x + moved_y).length() + draw.error(0.5 * format.ulp());
                reached[0] = reached[0].max((turned - 0.5 * angle).abs() / bound.angle);
                reached[1] = reached[1].max((fixed - turned.cos()).abs() / bound.rest);
            }
            assert!(reached.iter().all(|share| (0.9..=1.0 + 1e-6).contains(share)), "{reached:?}");
        }
    }

    /// Light about the horizon, q as small as it may be: 60 % of the bound is reached, by q = 0.
    /// The larger q, the faster the cosine vanishes there.
    #[test]
    fn cosines_at_the_horizon_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        let (off, format) = (1e-4, Format::signed(1, 13));
        let (vector, q) = (VectorBound::ball(0.0, 1.0, off), Bound::near(Interval::ANY, off));
        let horizon = Horizon::new([vector; 2], q, format);
        let of_cosine = Horizon::cosine([vector; 2], format);
        let bound = horizon.most_at_edge(of_cosine, Bound::near(Interval::ANY, 0.0));
        let cosine = |n: DVec3, incoming: DVec3, q: f64, moved: f64| {
            let b = n.dot(incoming);
            let lit = 1.0 + q * (b + moved - 1.0) + b + moved > 0.0;
            if lit { 0.5 * (incoming + reflected(n, incoming, q)).length() } else { 0.0 }
        };
        let mut reached = 0.0_f64;
        for _ in 0..40_000 {
            let (n, q) = (draw.direction(), draw.within(0.0, 1.0).powi(8));
            // g + b is 0 for b = (q - 1)/(q + 1).
            let b = (q - 1.0 + draw.within(-horizon.0, horizon.0)) / (q + 1.0);
            let b = b.clamp(-1.0, 1.0);
            let incoming = b * n + (1.0 - b * b).sqrt() * draw.across(n);
            let real = cosine(n, incoming, q, 0.0);
            let fixed_q = (q + draw.error(off)).clamp(0.0, 1.0);
            let fixed = cosine(n, incoming, fixed_q, draw.error(2.0 * off + 0.5 * format.ulp()));
            reached = reached.max((fixed - real).abs() / bound);
        }
        assert!(reached <= 1.0 && reached > 0.6, "{reached}");
    }
}
