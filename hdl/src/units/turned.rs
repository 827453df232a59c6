//! Scalars along an arc: what the normal's rotation makes of them, and the base of the highlight.
use specula_scene::spec::slerp::SlerpFormats;

use super::HOST_ERROR;
use super::rotation::{drift, drift_across, sum_of_components};
use specula_datapath::builder::{Builder, Sig};

/// N·X = c A·X + s T·X, for L and V alike. [lecture, eq. 4.7; methods A10]
///
/// |N·X| ≤ |N||X| with |N| ≤ 1 + e, and A·X, T·X are off by half a unit of their last place each.
pub fn along_arc(
    b: &Builder,
    weights: [&Sig; 2],
    [start, across]: [&Sig; 2],
    formats: &SlerpFormats,
    steps: u32,
) -> Sig {
    let inputs = (("c", weights[0]), ("s", weights[1]), ("at_start", start), ("across", across));
    b.unit(
        "along_arc",
        "N.X = c A.X + s T.X [lecture, eq. 4.7]",
        inputs,
        |_, (c, s, start, across)| {
            let longest = (1.0 + off(formats, steps)) * (1.0 + 2.0 * formats.component.ulp());
            let cosine = (c * start + s * across).assumed(-longest, longest, "|N.X| <= |N||X|");
            cosine.rounded(formats.cosine.fraction_bits).named("cosine")
        },
    )
}

/// K (2 - N·N): what N is too long or too short by leaves 2 J K but for its square, since z (2 -
/// z) = 1 - (1 - z)².
pub fn corrected(
    b: &Builder,
    n_dot_v: &Sig,
    weights: [&Sig; 2],
    formats: &SlerpFormats,
    steps: u32,
) -> Sig {
    let inputs = (("n_dot_v", n_dot_v), ("c", weights[0]), ("s", weights[1]));
    b.unit("length_correction", "K' = K (2 - N.N)", inputs, |b, (k, c, s)| {
        let fraction_bits = formats.cosine.fraction_bits;
        let longest = 1.0 + off(formats, steps);
        // Not from near 1 on: registers are 0 before the first pixel, and a range holds what they
        // hold.
        let squared_length =
            (c.squared() + s.squared()).assumed(0.0, longest * longest, "c^2 + s^2 <= 1");
        let correction = (b.integer(2) - squared_length).rounded(fraction_bits).named("correction");
        (k * correction).rounded(fraction_bits).named("corrected")
    })
}

/// 2 J K' - L·V, kept within 0 to 1. [lecture, eq. 4.5; methods A10]
pub fn base(
    b: &Builder,
    j: &Sig,
    k: &Sig,
    light_dot_view: &Sig,
    bound: &BaseBound,
    formats: &SlerpFormats,
) -> Sig {
    let inputs = (("n_dot_l", j), ("n_dot_v", k), ("light_dot_view", light_dot_view));
    b.unit(
        "specular_base",
        "b = max(2 J K - L.V, 0) [lecture, eq. 4.5]",
        inputs,
        |_, (j, k, light_dot_view)| {
            let base = (j * k).doubled() - light_dot_view;
            let base = base.rounded(formats.base.fraction_bits).at_least_zero().clamped_above(1);
            base.known_cosine(bound.angle, bound.rest).named("base")
        },
    )
}

/// What is known of the base's error.
///
/// Let N' = c A + s T of the weights as they are, n its direction, |N' - N| ≤ e, of which x lies
/// across N. The angle between n and N is at most atan(x/(1 - e)) and asin e, so R turns by twice
/// that, and the base moves as the cosine of an angle does that is off by so much. Spans turn by f
/// at most, with cos(f/2) the length of the shortest normal or more, and |cos t| + |sin t| ≤ κ up
/// to f. Beside that the base is off by
///
/// - 2 (2e + e²)², what the correction leaves of |N'|² - 1;
/// - twice the error of J K', where J and K are off by e1 = half a unit of the scalar's last place
///   times |c| + |s| ≤ κ + √2 e, and half a unit of their own; K' by K's error times 2 - N'·N' ≤
///   1 + 2e + e², and another half unit for it and for K' each;
/// - half a unit of L·V and half a unit of the base.
pub struct BaseBound {
    /// By how much the angle between R and L is off at most, in radians.
    pub angle: f64,
    /// What the base is off by beside that.
    pub rest: f64,
}

impl BaseBound {
    /// The bound for spans of `steps` + 1 pixels with normals no shorter than `shortest_normal`.
    pub fn new(formats: &SlerpFormats, steps: u32, shortest_normal: f64) -> BaseBound {
        let e = off(formats, steps);
        let widest = 2.0 * shortest_normal.clamp(0.0, 1.0).acos();
        let kappa = sum_of_components(widest);
        let across = drift_across(formats, steps, widest) + 0.5 * kappa * formats.weight.ulp();
        let half = |format: &specula_scene::Format| 0.5 * format.ulp() + HOST_ERROR;
        let (scalar, own) = (half(&formats.component), half(&formats.cosine));
        let (length, stretch) = (1.0 + e, 2.0 * e + e * e);
        let e1 = (kappa + 2f64.sqrt() * e) * scalar + own;
        let e_k = e1 * (1.0 + stretch) + (length + e1) * own + own;
        let product = length * e_k + length * (1.0 + stretch) * e1 + e1 * e_k;
        let rounding = half(&formats.base);
        let least_along = (1.0 - e).max(0.0);
        let angle = 2.0 * across.atan2(least_along).min(e.min(1.0).asin());
        BaseBound { angle, rest: 2.0 * stretch * stretch + 2.0 * product + scalar + rounding }
    }
}

/// How far (c, s) is off once it is rounded to weights.
fn off(formats: &SlerpFormats, steps: u32) -> f64 {
    drift(formats, steps) + 0.5f64.sqrt() * formats.weight.ulp()
}
