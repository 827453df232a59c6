//! What every method does with a span.

/// Shades one span.
pub(super) trait ShadeSpan {
    /// Pixel `i`, 0 to length - 1: 0..=255 LSB a channel.
    fn pixel(&self, i: u32) -> [f64; 3];

    /// As many pixels as `out` has, the span's first pixel first: one virtual call for all of them.
    fn shade(&self, out: &mut [[f64; 3]]) {
        for (shade, i) in out.iter_mut().zip(0..) {
            *shade = self.pixel(i);
        }
    }
}
