//! What a row of the catalogue is.
use specula_golden::exact;
use specula_scene::{Frame, Span};
use specula_spec::{CoreSpec, FULL_SCALE};

use super::draw::Draw;
use super::scene::SpanScene;
use super::variant::Variant;
use specula_testbench::Outcome;

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

/// An input that something breaks at, and what is asked there.
pub struct Row {
    /// Its number in docs/extremes.md, or a word.
    pub id: &'static str,
    /// The input.
    pub input: &'static str,
    /// What is tried, and asked.
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
    /// What the host does without a core.
    Host {
        /// What is asked of it.
        what: &'static str,
        /// Says what is wrong.
        check: fn() -> Result<(), String>,
    },
}

/// Scenes for every method as it is tried everywhere.
pub const fn scenes(cases: fn(&mut Draw, Extent) -> Vec<Case>) -> Trial {
    Trial::Scenes { cases, variants: Vec::new }
}

/// A place in a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// Number of the span.
    pub span: usize,
    /// Number of the pixel in it.
    pub pixel: u32,
}

/// Something that a row asks of some cores, beside what is asked everywhere.
pub struct Ask {
    /// What, in the words of a table.
    pub what: &'static str,
    /// Of which cores.
    pub of: fn(&CoreSpec) -> bool,
    /// The first place where it does not happen.
    pub fails: Fails,
}

/// Where what is asked does not happen first.
pub type Fails = Box<dyn Fn(&Shaded) -> Option<Place> + Send + Sync>;

/// How far cores without a proven bound may be from their method, where a row knows.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Which cores.
    pub of: fn(&CoreSpec) -> bool,
    /// In LSBs.
    pub lsb: f64,
}

/// A scene and what is asked of it.
pub struct Case {
    /// The scene.
    pub scene: SpanScene,
    /// What is asked, beside what is asked everywhere.
    pub asks: Vec<Ask>,
    /// What is known of cores without a bound.
    pub figure: Option<Figure>,
}

impl Case {
    /// A scene of which no more is asked than everywhere.
    pub fn new(scene: SpanScene) -> Case {
        Case { scene, asks: Vec::new(), figure: None }
    }

    /// The same, with `what` asked of some cores at every pixel.
    pub fn asking(
        self,
        what: &'static str,
        of: fn(&CoreSpec) -> bool,
        holds: impl Fn(&Pixel) -> bool + Send + Sync + 'static,
    ) -> Case {
        self.asking_frame(what, of, move |shaded| shaded.first_that_does_not(&holds))
    }

    /// The same, with `what` asked of some cores and a whole frame; `fails` says where it does not
    /// happen first.
    pub fn asking_frame(
        mut self,
        what: &'static str,
        of: fn(&CoreSpec) -> bool,
        fails: impl Fn(&Shaded) -> Option<Place> + Send + Sync + 'static,
    ) -> Case {
        self.asks.push(Ask { what, of, fails: Box::new(fails) });
        self
    }

    /// The same, with what is known of cores without a bound.
    pub fn with_figure(self, of: fn(&CoreSpec) -> bool, lsb: f64) -> Case {
        Case { figure: Some(Figure { of, lsb }), ..self }
    }
}

/// Every core.
pub fn all(_: &CoreSpec) -> bool {
    true
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
        exact::method(self.shaded.spec, self.shaded.frame, self.span, self.i)[1]
    }

    /// Exact shading, in LSBs.
    pub fn exact(&self) -> f64 {
        exact::phong(self.shaded.frame, self.span, self.i)[1]
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
        (FULL_SCALE
            * self.shaded.frame.material(self.span).ambient[1]
            * self.shaded.frame.ambient[1])
            .round() as u8
    }
}
