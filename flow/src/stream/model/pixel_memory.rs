//! `NAME_pixels`: pixels from when they enter the core until they have been sent, and the places that
//! there are for them.

/// What belongs to a pixel besides its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tag {
    /// Its column and row.
    pub position: [u32; 2],
    /// Whether it is the first one of its frame: `tuser`.
    pub first: bool,
    /// Whether it is the last one of its span: `tlast`.
    pub last: bool,
}

/// A pixel as it stands at the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// What was written when a pixel entered.
    pub tag: Tag,
    /// Which of the pixels that have left the core gave the colour, from 0 on.
    pub colour: usize,
}

/// The memory for pixels under way.
pub struct PixelMemory {
    tags: Vec<Tag>,
    colours: Vec<usize>,
    entering: usize,
    leaving: usize,
    sending: usize,
    /// Pixels that have left the core, from reset on.
    left: usize,
    stored: usize,
    waiting: bool,
    /// The pixel between memory and output, if any is there.
    read: Option<Pixel>,
    /// The pixel at the output: `m_axis_tvalid`.
    shown: Option<Pixel>,
    freed: bool,
}

impl PixelMemory {
    /// An empty one of 2^`log2_depth` places.
    pub fn new(log2_depth: u32) -> PixelMemory {
        let places = 1 << log2_depth;
        PixelMemory {
            tags: vec![Tag::default(); places],
            colours: vec![0; places],
            entering: 0,
            leaving: 0,
            sending: 0,
            left: 0,
            stored: 0,
            waiting: false,
            read: None,
            shown: None,
            freed: false,
        }
    }

    /// The pixel at the output.
    pub fn shown(&self) -> Option<Pixel> {
        self.shown
    }

    /// Whether a place is free again.
    pub fn freed(&self) -> bool {
        self.freed
    }

    /// Ends a clock in which a pixel enters, one leaves the core, or the one at the output is taken
    /// where it is valid.
    pub fn clock(&mut self, enters: Option<Tag>, leaves: bool, ready: bool) {
        let output_free = self.shown.is_none() || ready;
        let moves = self.read.is_some() && output_free;
        let reads = self.waiting && (self.read.is_none() || output_free);

        if moves {
            self.shown = self.read.take();
        } else if ready {
            self.shown = None;
        }
        if reads {
            let (tag, colour) = (self.tags[self.sending], self.colours[self.sending]);
            self.read = Some(Pixel { tag, colour });
            self.sending = self.behind(self.sending);
        }
        self.freed = reads;
        self.waiting = leaves || self.stored > usize::from(reads);
        self.stored = self.stored + usize::from(leaves) - usize::from(reads);

        if let Some(tag) = enters {
            self.tags[self.entering] = tag;
            self.entering = self.behind(self.entering);
        }
        if leaves {
            self.colours[self.leaving] = self.left;
            self.leaving = self.behind(self.leaving);
            self.left += 1;
        }
    }

    fn behind(&self, place: usize) -> usize {
        (place + 1) % self.tags.len()
    }
}

/// Places for pixels, one of which is spent with each pixel that enters.
pub struct Places {
    all: u32,
    free: u32,
    /// Whether a pixel may enter.
    pub room: bool,
}

impl Places {
    /// All but one of 2^`log2_depth`.
    pub fn new(log2_depth: u32) -> Places {
        let all = (1 << log2_depth) - 1;
        Places { all, free: all, room: true }
    }

    /// Whether no pixel is under way.
    pub fn are_free(&self) -> bool {
        self.free == self.all
    }

    /// Ends a clock in which a place is spent, or one was free again.
    pub fn clock(&mut self, spent: bool, freed: bool) {
        self.room = freed || self.free > u32::from(spent);
        self.free = self.free + u32::from(freed) - u32::from(spent);
    }
}
