//! Pixels that are taken at a block's `m_axis`.

/// A pixel, and the clock in which it is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SentPixel {
    /// The clock, counted from the first one without reset.
    pub clock: u64,
    /// The pixel, `tlast` above it, and `tuser` above that.
    pub bits: u64,
}

/// All pixels of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StreamRecord {
    /// The pixels, in order.
    pub pixels: Vec<SentPixel>,
}

/// The first pixel that is not as it must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StreamDifference {
    /// Its number, from 0 on.
    pub number: usize,
    /// What was taken; `None` if the pixel is missing.
    pub found: Option<SentPixel>,
    /// What had to be; `None` of a pixel too many.
    pub expected: Option<u64>,
}

impl StreamRecord {
    /// What a bench with `+record` writes: a line with clock and bits for each pixel. `None` if a line
    /// is none.
    pub fn read(text: &str) -> Option<StreamRecord> {
        let pixel = |line: &str| {
            let (clock, bits) = line.split_once(' ')?;
            let bits = u64::from_str_radix(bits, 16).ok()?;
            Some(SentPixel { clock: clock.parse().ok()?, bits })
        };
        Some(StreamRecord { pixels: text.lines().map(pixel).collect::<Option<_>>()? })
    }

    /// The first pixel that is lost, doubled, out of order or wrong.
    pub fn difference(&self, expected: &[u64]) -> Option<StreamDifference> {
        let most = self.pixels.len().max(expected.len());
        let at = |number: usize| {
            let (found, expected) = (self.pixels.get(number), expected.get(number));
            StreamDifference { number, found: found.copied(), expected: expected.copied() }
        };
        let differs = |both: &StreamDifference| both.found.map(|pixel| pixel.bits) != both.expected;
        (0..most).map(at).find(differs)
    }
}

impl StreamDifference {
    /// The difference as text.
    pub fn in_words(&self) -> String {
        let StreamDifference { number, found, expected } = self;
        match (found, expected) {
            (Some(SentPixel { clock, bits }), Some(expected)) => format!(
                "pixel {number} of the stream is {bits:x} in cycle {clock}, not {expected:x} (tuser, \
                 tlast, row, column, b, g, r)"
            ),
            (Some(SentPixel { clock, .. }), None) => {
                format!("pixel {number} is sent in cycle {clock}, and is one too many")
            }
            (None, _) => format!("pixel {number} is never sent"),
        }
    }
}
