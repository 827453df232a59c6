//! The interface of a span that a method shades.

/// Shades a span.
pub(super) trait ShadeSpan {
    /// Pixel `i`, from 0 to length - 1: 0..=255 LSB a channel.
    fn pixel(&self, i: u32) -> [f64; 3];

    /// Shades as many pixels as `out` has, from the span's first pixel on, with one virtual call.
    fn shade(&self, out: &mut [[f64; 3]]) {
        for (shade, i) in out.iter_mut().zip(0..) {
            *shade = self.pixel(i);
        }
    }
}
