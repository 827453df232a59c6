//! Key frames: values at some frames, and those between them.
use std::ops::{Add, Mul, Sub};

/// The way from one key frame to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Steps {
    /// At constant speed.
    #[default]
    Linear,
    /// From rest to rest, by 3 u² - 2 u³.
    Smooth,
}

impl Steps {
    /// The share of the way that is done at the share `u` of the time, both 0 to 1.
    fn share(self, u: f64) -> f64 {
        match self {
            Steps::Linear => u,
            Steps::Smooth => u * u * (3.0 - 2.0 * u),
        }
    }
}

/// Values at key frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Keys<T> {
    /// Frame numbers, which ascend, with the value at each; at least one.
    keys: Vec<(f64, T)>,
    steps: Steps,
}

impl<T> Keys<T>
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    /// Values at key frames, whose numbers ascend; `None` if they do not, or there are none.
    pub fn new(keys: Vec<(f64, T)>, steps: Steps) -> Option<Keys<T>> {
        let ascend = keys.windows(2).all(|pair| pair[0].0 < pair[1].0);
        (ascend && !keys.is_empty()).then_some(Keys { keys, steps })
    }

    /// The value at a frame: before the first key frame that of the first, after the last that of
    /// the last.
    pub fn at(&self, frame: f64) -> T {
        let after = self.keys.partition_point(|&(key, _)| key <= frame);
        match (after.checked_sub(1).map(|before| self.keys[before]), self.keys.get(after)) {
            (Some((start, from)), Some(&(end, to))) => {
                from + (to - from) * self.steps.share((frame - start) / (end - start))
            }
            (Some((_, last)), None) => last,
            // There is a key, so the first one is after the frame where none is before it.
            (None, _) => self.keys[0].1,
        }
    }
}
