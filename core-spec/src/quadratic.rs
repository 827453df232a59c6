//! Quadratics in the pixel number, by start value and differences.
use glam::DVec3;
use specula_datapath::Format;
use specula_scene::frame::Span;

use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{InputGroup, inputs};

/// The numerator of Hast's specular base, as a formula.
pub(crate) const REFLECTED: &str = "2(N.V)(N.L) - (L.V)(N.N)";

inputs! {
    /// Start value and differences of a quadratic in the pixel number.
    Quadratic {
        /// Value at the first pixel.
        start: one,
        /// Value at the second pixel less that at the first; 0 in a span of one pixel.
        first_difference: one,
        /// The constant second difference; 0 in a span of fewer than three pixels, where it is not
        /// used.
        second_difference: one,
    }
}

impl Quadratic<CoreInput> {
    /// The inputs of x·x with |x| ≤ 1: from 0 to 1 along the span, so differences of neighbours are
    /// up to 1 and 2.
    pub(crate) fn squared_length_inputs(
        value: &str,
        name: &str,
        format: Format,
    ) -> Quadratic<CoreInput> {
        Quadratic::inputs(value, name, format, [(0.0, 1.0), (-1.0, 1.0), (0.0, 2.0)])
    }

    /// The inputs of what [`Quadratic::reflected`] makes of |x| ≤ 1 and unit vectors: from -1 to 1
    /// along the span, so differences of neighbours are up to 2 and 4.
    pub(crate) fn reflected_inputs(
        value: &str,
        name: &str,
        format: Format,
    ) -> Quadratic<CoreInput> {
        Quadratic::inputs(value, name, format, [(-1.0, 1.0), (-2.0, 2.0), (-4.0, 4.0)])
    }

    /// The inputs of what [`Quadratic::through`] makes of values from 0 to 1: differences of
    /// neighbours are up to 1 and 2.
    pub(crate) fn share_inputs(value: &str, name: &str, format: Format) -> Quadratic<CoreInput> {
        Quadratic::inputs(value, name, format, [(0.0, 1.0), (-1.0, 1.0), (-2.0, 2.0)])
    }

    /// The inputs of a quadratic, `value` as a formula; `limits` of start value, first and second
    /// difference.
    fn inputs(
        value: &str,
        name: &str,
        format: Format,
        limits: [(f64, f64); 3],
    ) -> Quadratic<CoreInput> {
        let input = |meaning: InputMeaning, part: &str, (low, high)| {
            CoreInput::between(meaning, format!("{name}_{part}"), format, low, high)
        };
        let [first, second] = [InputMeaning::first_difference, InputMeaning::second_difference];
        Quadratic {
            start: input(InputMeaning::at_first_pixel(value), "start", limits[0]),
            first_difference: input(first(value), "first_difference", limits[1]),
            second_difference: input(second(value), "second_difference", limits[2]),
        }
    }
}

impl Quadratic<f64> {
    /// Start and differences of c + b i + a i² (Hast eq. 20 to 26: p0 = C, dp0 = A + B, d2p = 2A),
    /// as far as the span is long enough to use them.
    pub(crate) fn new(span: &Span, c: f64, b: f64, a: f64) -> Quadratic<f64> {
        let used_from = |steps: u32, x: f64| if span.steps() >= steps { x } else { 0.0 };
        Quadratic {
            start: c,
            first_difference: used_from(1, a + b),
            second_difference: used_from(2, 2.0 * a),
        }
    }

    /// Through values at the first pixel, half-way and at the last.
    pub(crate) fn through(span: &Span, [first, half, last]: [f64; 3]) -> Quadratic<f64> {
        let steps = f64::from(span.steps().max(1));
        let bend = 2.0 * (first - 2.0 * half + last);
        let slope = last - first - bend;
        Quadratic::new(span, first, slope / steps, bend / steps / steps)
    }

    /// (m + k i)·(m + k i).
    pub(crate) fn squared_length(span: &Span, m: DVec3, k: DVec3) -> Quadratic<f64> {
        Quadratic::new(span, m.dot(m), 2.0 * k.dot(m), k.dot(k))
    }

    /// 2(x·n)(x·l) - (n·l)(x·x) with x = m + k i: n reflected about x, times l and x·x [Hast et
    /// al., eq. 10, 18 to 26 and 29].
    pub(crate) fn reflected(span: &Span, [m, k]: [DVec3; 2], n: DVec3, l: DVec3) -> Quadratic<f64> {
        let n_dot_l = n.dot(l);
        Quadratic::new(
            span,
            2.0 * m.dot(n) * m.dot(l) - n_dot_l * m.dot(m),
            2.0 * (m.dot(n) * k.dot(l) + k.dot(n) * m.dot(l)) - 2.0 * n_dot_l * k.dot(m),
            2.0 * k.dot(n) * k.dot(l) - n_dot_l * k.dot(k),
        )
    }

    pub(crate) fn quantised(&self, format: Format) -> Quadratic<i64> {
        self.map_each(&mut |&x| format.quantise(x))
    }
}
