//! Frames that one core is for.
use specula_scene::Frame;

/// One frame or several, borrowed.
#[derive(Clone, Copy, Debug)]
pub struct Frames<'a>(&'a [Frame]);

impl<'a> Frames<'a> {
    /// Every frame.
    pub fn iter(self) -> impl Iterator<Item = &'a Frame> {
        self.0.iter()
    }
}

impl<'a> From<&'a Frame> for Frames<'a> {
    fn from(frame: &'a Frame) -> Frames<'a> {
        Frames(std::slice::from_ref(frame))
    }
}

impl<'a> From<&'a [Frame]> for Frames<'a> {
    fn from(frames: &'a [Frame]) -> Frames<'a> {
        Frames(frames)
    }
}
