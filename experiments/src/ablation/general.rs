//! General cores, with which a scene's core is compared.
use serde::Serialize;
use specula_datapath::Design;
use specula_scene::{Frame, Needs};

use super::premise::{EYE_AT_INFINITY, LIGHTS, LIGHTS_AT_INFINITY, Premise};

/// The purpose of a general core.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Baseline {
    /// Any scene: four lights or the scene's own, if it has more, the longest spans and the largest exponent that exist.
    Nothing,
    /// The scenes of a renderer: as many lights of the same kinds as the scene has, spans as wide
    /// as the picture, exponents up to 128.
    Renderer,
}

/// The largest exponent of a renderer's materials; OpenGL's fixed-function pipeline had the same.
const USUAL_SHININESS: u32 = 128;

impl Baseline {
    /// Both baselines.
    pub const ALL: [Baseline; 2] = [Baseline::Nothing, Baseline::Renderer];

    /// The name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Baseline::Nothing => "all together",
            Baseline::Renderer => "all together, against a renderer's core",
        }
    }

    /// Whether a core of this kind is built with knowledge of a premise.
    pub(super) fn knows(self, need: &str) -> bool {
        self == Baseline::Renderer && [LIGHTS, LIGHTS_AT_INFINITY, EYE_AT_INFINITY].contains(&need)
    }

    /// The needs of scenes for which `premises` are unknown, except those that a core of this kind
    /// is built with.
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
    /// The needs for which it was to be built.
    pub needs: Needs,
    pub design: Design,
    /// The premises that it needs to know all the same.
    pub known: Vec<&'static str>,
}

impl General {
    /// A table's text about what the core is built for.
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
