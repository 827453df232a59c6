//! General cores that a scene's is measured against.
use serde::Serialize;
use specula_datapath::Design;
use specula_scene::{Frame, Needs};

use super::premise::{EYE_AT_INFINITY, LIGHTS, LIGHTS_AT_INFINITY, Premise};

/// What a general core is built for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Baseline {
    /// Anything: four lights, the longest spans and the largest exponent that there are.
    Nothing,
    /// What a renderer would ask for: as many lights and of the same kinds as the scene's, spans as
    /// wide as the picture, exponents up to 128.
    Renderer,
}

/// The largest exponent of a renderer's materials, as OpenGL's fixed function had it.
const USUAL_SHININESS: u32 = 128;

impl Baseline {
    /// Both.
    pub const ALL: [Baseline; 2] = [Baseline::Nothing, Baseline::Renderer];

    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Baseline::Nothing => "all together",
            Baseline::Renderer => "all together, against a renderer's core",
        }
    }

    /// Whether a core of this kind is built knowing a premise.
    pub(super) fn knows(self, need: &str) -> bool {
        self == Baseline::Renderer && [LIGHTS, LIGHTS_AT_INFINITY, EYE_AT_INFINITY].contains(&need)
    }

    /// The needs of scenes of which `premises` are not known, except for what a core of this kind
    /// is built for.
    pub(super) fn relax(self, needs: &Needs, frame: &Frame, premises: &[&Premise]) -> Needs {
        let mut unknown = needs.clone();
        premises.iter().for_each(|premise| (premise.relax)(&mut unknown));
        if self == Baseline::Renderer {
            unknown.longest_span = unknown.longest_span.min(frame.width.max(needs.longest_span));
            unknown.largest_shininess =
                unknown.largest_shininess.min(USUAL_SHININESS.max(needs.largest_shininess));
        }
        unknown
    }
}

/// A general core.
pub(super) struct General {
    pub baseline: Baseline,
    /// What it was asked to be built for.
    pub needs: Needs,
    pub design: Design,
    /// What it knows of the scene all the same.
    pub known: Vec<&'static str>,
}

impl General {
    /// In the words of a table.
    pub fn built_for(&self) -> String {
        let Needs { lights, longest_span, largest_shininess, .. } = &self.needs;
        let plural = if *lights == 1 { "" } else { "s" };
        let known: Vec<String> =
            self.known.iter().map(|need| format!("; it knows the {need}")).collect();
        format!(
            "against a general core for {lights} light{plural} at once, spans of {longest_span} pixels, n up to {largest_shininess}{}",
            known.concat()
        )
    }
}
