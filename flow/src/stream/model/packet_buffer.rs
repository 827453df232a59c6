//! `NAME_packets`: words are put together to a packet.

/// The packet that is taken in while a span is shaded.
pub struct PacketBuffer {
    /// Its words so far.
    words: Vec<u64>,
    /// Words of a packet.
    size: usize,
}

impl PacketBuffer {
    /// An empty one for packets of so many words.
    pub fn new(size: usize) -> PacketBuffer {
        PacketBuffer { words: vec![], size }
    }

    /// The packet, as soon as it is whole: `full`.
    pub fn packet(&self) -> Option<&[u64]> {
        (self.words.len() == self.size).then_some(&self.words)
    }

    /// Whether a word that is offered is taken: `s_axis_tready`.
    pub fn takes(&self) -> bool {
        self.packet().is_none()
    }

    /// Ends a clock in which `word` is offered, and in which the packet is loaded where `load` says so.
    pub fn clock(&mut self, word: Option<u64>, load: bool) {
        if self.takes() {
            self.words.extend(word);
        } else if load {
            self.words.clear();
        }
    }
}
