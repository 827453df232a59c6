//! What a row of the catalogue is.
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_scene::spec::FULL_SCALE;
use specula_scene::{CoreSpec, Frame, Span};

use super::draw::Draw;
use super::scene::SpanScene;
use super::variant::Variant;
use crate::Outcome;

/// How much of a row is tried.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Random spans that each row draws.
    pub spans: usize,
    /// Pixels of the longest random span.
    pub longest: u32,
    /// Whether every option of every method is tried, and not its defaults alone.
    pub every_option: bool,
}

impl Extent {
    /// A few seconds' worth.
    pub const SMALL: Extent = Extent { spans: 3, longest: 100, every_option: false };
    /// What `specula stress` does.
    pub const WHOLE: Extent = Extent { spans: 64, longest: 8192, every_option: true };
}

/// An input that something breaks at, and what is wanted there.
pub struct Row {
    /// Its number in EXTREMES.md, or a word.
    pub id: &'static str,
    /// The input.
    pub input: &'static str,
    /// What is wanted, beside what is wanted everywhere.
    pub wanted: &'static str,
    /// What is tried.
    pub trial: Trial,
}

/// How a row is tried.
pub enum Trial {
    /// Scenes, shaded by every method.
    Scenes {
        /// Draws them.
        cases: fn(&mut Draw, Extent) -> Vec<Case>,
        /// Methods with options that the row is about, beside those that are tried everywhere.
        variants: fn() -> Vec<Variant>,
    },
    /// What the host does without a core. Says what is wrong.
    Host(fn() -> Result<(), String>),
}

/// Scenes for every method as it is tried everywhere.
pub const fn scenes(cases: fn(&mut Draw, Extent) -> Vec<Case>) -> Trial {
    Trial::Scenes { cases, variants: Vec::new }
}

/// A place in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Number of the span.
    pub span: usize,
    /// Number of the pixel in it.
    pub pixel: u32,
}

/// The first place where what is wanted did not happen.
pub type Want = Box<dyn Fn(&Shaded) -> Option<Place> + Send + Sync>;

/// A scene and what is wanted of it.
pub struct Case {
    /// The scene.
    pub scene: SpanScene,
    /// What is wanted, beside what is wanted everywhere.
    pub want: Want,
}

impl Case {
    /// A scene of which no more is wanted than everywhere.
    pub fn new(scene: SpanScene) -> Case {
        Case { scene, want: Box::new(|_| None) }
    }

    /// A scene at every pixel of which `holds` is wanted.
    pub fn wanting(scene: SpanScene, holds: impl Fn(&Pixel) -> bool + Send + Sync + 'static) -> Case {
        Case { scene, want: Box::new(move |shaded| shaded.first_that_does_not(&holds)) }
    }

    /// A scene of which all spans are wanted to have the same code from end to end.
    pub fn wanting_flat(scene: SpanScene) -> Case {
        Case::wanting(scene, |pixel| pixel.code() == Pixel { i: 0, ..*pixel }.code())
    }
}

/// A frame that a core has shaded.
pub struct Shaded<'a> {
    /// The core.
    pub spec: &'a CoreSpec,
    /// The frame.
    pub frame: &'a Frame,
    /// What came of it.
    pub outcome: &'a Outcome,
}

/// A pixel of it.
#[derive(Clone, Copy)]
pub struct Pixel<'a> {
    /// The frame.
    pub shaded: &'a Shaded<'a>,
    /// Its span.
    pub span: &'a Span,
    /// Its number in the span.
    pub i: u32,
}

impl Shaded<'_> {
    fn first_that_does_not(&self, holds: &impl Fn(&Pixel) -> bool) -> Option<Place> {
        self.frame.spans.iter().enumerate().find_map(|(number, span)| {
            let fails = |&i: &u32| !holds(&Pixel { shaded: self, span, i });
            (0..span.length).find(fails).map(|pixel| Place { span: number, pixel })
        })
    }
}

impl Pixel<'_> {
    /// The core's green code.
    pub fn code(&self) -> u8 {
        let image = &self.shaded.outcome.simulated;
        image.pixels[(self.span.y * image.width + self.span.x + self.i) as usize][1]
    }

    /// The method in f64, in LSBs.
    pub fn method(&self) -> f64 {
        MethodSpan::new(self.shaded.spec, self.shaded.frame, self.span).pixel(self.i)[1]
    }

    /// Exact shading, in LSBs.
    pub fn exact(&self) -> f64 {
        PhongSpan::new(self.shaded.frame, self.span).pixel(self.i)[1]
    }

    /// Whether the core's code is no more than `lsb` from a value.
    pub fn is_within(&self, lsb: f64, of: f64) -> bool {
        (f64::from(self.code()) - of).abs() <= lsb
    }

    /// Whether this is the first or the last pixel of its span.
    pub fn is_end(&self) -> bool {
        self.i == 0 || self.i + 1 == self.span.length
    }

    /// The exponent of its material.
    pub fn n(&self) -> u32 {
        self.shaded.frame.material(self.span).shininess
    }

    /// The code of ambient light alone.
    pub fn ambient(&self) -> u8 {
        (FULL_SCALE * self.shaded.frame.material(self.span).ambient[1] * self.shaded.frame.ambient[1]).round() as u8
    }
}
