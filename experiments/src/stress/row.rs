//! The rows of the catalogue: what they are made of.
use specula_golden::exact;
use specula_scene::{Frame, Span};
use specula_spec::{CoreSpec, FULL_SCALE};

use super::draw::Draw;
use super::scene::SpanScene;
use super::variant::Variant;
use specula_testbench::Outcome;

/// How much of a row is tried.
#[derive(Clone, Copy, Debug)]
pub struct TrialExtent {
    /// Number of random spans that each row draws.
    pub spans: usize,
    /// Length of the longest random span in pixels.
    pub longest: u32,
    /// Whether every option of every method is tried rather than its defaults alone.
    pub every_option: bool,
}

impl TrialExtent {
    /// An extent that takes a few seconds.
    pub const SMALL: TrialExtent = TrialExtent { spans: 3, longest: 100, every_option: false };
    /// The extent of `specula stress`.
    pub const WHOLE: TrialExtent = TrialExtent { spans: 64, longest: 8192, every_option: true };
}

/// An input for which something breaks, and the requirements on it.
pub struct CatalogueRow {
    /// Its number in docs/extremes.md, or a word.
    pub id: &'static str,
    /// The input as text.
    pub input: &'static str,
    /// How the row is tried, with its requirements.
    pub trial: Trial,
}

/// The way in which a row is tried.
pub enum Trial {
    /// Scenes, shaded by every method.
    Scenes {
        /// Draws the scenes.
        cases: fn(&mut Draw, TrialExtent) -> Vec<Case>,
        /// Methods with options for this row, in addition to those that are tried in every row.
        variants: fn() -> Vec<Variant>,
    },
    /// Something that the host does without a core.
    Host {
        /// The requirement as text.
        what: &'static str,
        /// Says what is wrong.
        check: fn() -> Result<(), String>,
    },
}

/// A trial of scenes with the methods that are tried in every row.
pub const fn scenes(cases: fn(&mut Draw, TrialExtent) -> Vec<Case>) -> Trial {
    Trial::Scenes { cases, variants: Vec::new }
}

/// A place in a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelPlace {
    /// Number of the span.
    pub span: usize,
    /// Number of the pixel in it.
    pub pixel: u32,
}

/// A requirement of a row on some cores, in addition to those of every row.
pub struct RowRequirement {
    /// The requirement as text, for a table.
    pub what: &'static str,
    /// Whether the requirement applies to a core.
    pub applies_to: fn(&CoreSpec) -> bool,
    /// Finds the first place where it is not met.
    pub fails: Fails,
}

/// A function that finds the first place where a requirement is not met.
pub type Fails = Box<dyn Fn(&Shaded) -> Option<PixelPlace> + Send + Sync>;

/// A row's limit for the difference between method and cores without a proven bound.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Whether the limit applies to a core.
    pub applies_to: fn(&CoreSpec) -> bool,
    /// The limit in LSBs.
    pub lsb: f64,
}

/// A scene and the requirements on it.
pub struct Case {
    /// The scene.
    pub scene: SpanScene,
    /// The requirements, in addition to those of every row.
    pub requirements: Vec<RowRequirement>,
    /// The limit for cores without a bound.
    pub figure: Option<Figure>,
}

impl Case {
    /// A scene with no requirements other than those of every row.
    pub fn new(scene: SpanScene) -> Case {
        Case { scene, requirements: Vec::new(), figure: None }
    }

    /// Adds the requirement `what` on some cores at every pixel.
    pub fn requiring(
        self,
        what: &'static str,
        applies_to: fn(&CoreSpec) -> bool,
        holds: impl Fn(&Pixel) -> bool + Send + Sync + 'static,
    ) -> Case {
        self.requiring_frame(what, applies_to, move |shaded| shaded.first_that_does_not(&holds))
    }

    /// Adds the requirement `what` on some cores and a whole frame; `fails` finds the first place
    /// where it is not met.
    pub fn requiring_frame(
        mut self,
        what: &'static str,
        applies_to: fn(&CoreSpec) -> bool,
        fails: impl Fn(&Shaded) -> Option<PixelPlace> + Send + Sync + 'static,
    ) -> Case {
        self.requirements.push(RowRequirement { what, applies_to, fails: Box::new(fails) });
        self
    }

    /// Adds a limit for cores without a bound.
    pub fn with_figure(self, applies_to: fn(&CoreSpec) -> bool, lsb: f64) -> Case {
        Case { figure: Some(Figure { applies_to, lsb }), ..self }
    }
}

/// A condition that holds for every core.
pub fn all(_: &CoreSpec) -> bool {
    true
}

/// A frame that a core has shaded.
pub struct Shaded<'a> {
    /// The core.
    pub spec: &'a CoreSpec,
    /// The shaded frame.
    pub frame: &'a Frame,
    /// The outcome of the simulation.
    pub outcome: &'a Outcome,
}

/// A pixel of a shaded frame.
#[derive(Clone, Copy)]
pub struct Pixel<'a> {
    /// The shaded frame.
    pub shaded: &'a Shaded<'a>,
    /// Its span.
    pub span: &'a Span,
    /// Its number in the span.
    pub i: u32,
}

impl Shaded<'_> {
    fn first_that_does_not(&self, holds: &impl Fn(&Pixel) -> bool) -> Option<PixelPlace> {
        self.frame.spans.iter().enumerate().find_map(|(number, span)| {
            let fails = |&i: &u32| !holds(&Pixel { shaded: self, span, i });
            (0..span.length).find(fails).map(|pixel| PixelPlace { span: number, pixel })
        })
    }
}

impl Pixel<'_> {
    /// The core's code of the green channel.
    pub fn code(&self) -> u8 {
        let image = &self.shaded.outcome.simulated;
        image.pixels[(self.span.y * image.width + self.span.x + self.i) as usize][1]
    }

    /// The method's value in f64, in LSBs.
    pub fn method(&self) -> f64 {
        exact::method(self.shaded.spec, self.shaded.frame, self.span, self.i)[1]
    }

    /// The value of exact shading, in LSBs.
    pub fn exact(&self) -> f64 {
        exact::phong(self.shaded.frame, self.span, self.i)[1]
    }

    /// Whether the core's code differs from a value by at most `lsb`.
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
