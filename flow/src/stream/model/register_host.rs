//! The bench's host at the registers: it identifies the block and writes the inputs of each frame as
//! soon as the one before has begun.
use super::registers::Registers;

/// What the host does.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Identify,
    CheckCore,
    /// Until the frame before has begun.
    Await,
    /// Write what is left for a frame.
    Write,
    Done,
}

/// Where an access is: each takes three clocks.
enum Access {
    /// It may begin.
    Idle,
    /// Address and data are at the registers.
    Asked(Option<(u32, u32)>),
    /// The answer is there; of a read the frames that had begun.
    Answered(u32),
}

/// The host.
pub struct RegisterHost {
    /// What is written for each frame: addresses and words.
    writes: Vec<Vec<(u32, u32)>>,
    /// Words written of the next frame's.
    done: usize,
    /// Frames that are written.
    written: usize,
    step: Step,
    access: Access,
}

impl RegisterHost {
    /// A host that has these words to write for each frame.
    pub fn new(writes: Vec<Vec<(u32, u32)>>) -> RegisterHost {
        RegisterHost { writes, done: 0, written: 0, step: Step::Identify, access: Access::Idle }
    }

    /// Frames whose inputs are written.
    pub fn written(&self) -> usize {
        self.written
    }

    /// Goes on by a clock.
    pub fn clock(&mut self, registers: &mut Registers) {
        self.access = match &self.access {
            Access::Idle => self.begin(),
            Access::Asked(write) => {
                write.iter().for_each(|&write| registers.write(write));
                Access::Answered(registers.frames)
            }
            Access::Answered(frames) => {
                let frames = *frames;
                self.answer(frames);
                Access::Idle
            }
        };
    }

    /// Begins an access, or ends the writes for a frame.
    fn begin(&mut self) -> Access {
        match self.step {
            Step::Done => Access::Idle,
            Step::Identify | Step::CheckCore | Step::Await => Access::Asked(None),
            Step::Write => match self.writes[self.written].get(self.done) {
                Some(&write) => {
                    self.done += 1;
                    Access::Asked(Some(write))
                }
                None => {
                    (self.done, self.written) = (0, self.written + 1);
                    let more = self.written < self.writes.len();
                    self.step = if more { Step::Await } else { Step::Done };
                    Access::Idle
                }
            },
        }
    }

    fn answer(&mut self, frames: u32) {
        self.step = match self.step {
            Step::Identify => Step::CheckCore,
            Step::CheckCore => Step::Await,
            Step::Await if frames as usize == self.written => Step::Write,
            step => step,
        };
    }
}
