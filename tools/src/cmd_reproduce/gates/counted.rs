//! Cores of all contenders, synthesised.
use specula_datapath::Design;
use specula_experiments::reproduce::gates::{CONTENDERS, Comparison, Counts, EqualCore};
use specula_flow::synth::{Cells, Logic, SynthTarget, synthesised_both_ways};
use specula_scene::Frame;
use specula_spec::Specialise;
use specula_testbench::BenchError;

use crate::error::ToolError;
use crate::progress;

/// What cores are made for.
pub struct Case {
    /// What they are made for, as text.
    pub title: String,
    /// The contenders' cores.
    pub cores: [EqualCore; CONTENDERS.len()],
    /// What they take.
    pub counts: Comparison,
}

/// The cases that are wanted.
pub struct Wanted<'a> {
    /// Largest quantisation error, in LSBs.
    pub most: f64,
    /// The only kind of cores, if both are not wanted.
    pub specialise: Option<Specialise>,
    /// Exponents of further scenes, for general cores.
    pub exponents: &'a [u32],
}

/// Cores with what they are made for.
type Named = (String, [EqualCore; CONTENDERS.len()]);

impl Wanted<'_> {
    /// The cases for a frame, counted.
    pub fn cases(&self, frame: &Frame) -> Result<Vec<Case>, ToolError> {
        let cases = self.cores(frame)?;
        let designs: Vec<Design> = cases
            .iter()
            .flat_map(|(_, cores)| cores)
            .map(|core| specula_hdl::elaborate(&core.spec, "core").map_err(BenchError::from))
            .collect::<Result<_, _>>()?;
        let bar = progress::steps();
        bar.set_length(designs.len() as u64);
        bar.set_message("cores synthesised");
        let counted = synthesised_both_ways(&designs, &SynthTarget::ECP5, &|| bar.inc(1));
        bar.finish_and_clear();
        let counts: Vec<Counts> =
            designs.iter().zip(counted?).map(|(design, both)| counts(design, both)).collect();
        let (each, _) = counts.as_chunks::<{ CONTENDERS.len() }>();
        let case =
            |((title, cores), counts): (Named, &Comparison)| Case { title, cores, counts: *counts };
        Ok(cases.into_iter().zip(each).map(case).collect())
    }

    fn cores(&self, frame: &Frame) -> Result<Vec<Named>, ToolError> {
        let own = equal_cores(frame, self.most)?;
        let largest = frame.materials.iter().map(|material| material.shininess).max().unwrap_or(0);
        let special =
            own.clone().map(|core| EqualCore { spec: core.spec.specialised(frame), ..core });
        let mut cases = vec![];
        if self.specialise != Some(Specialise::Scene) {
            cases.push((format!("any scene, n = {largest}"), own));
        }
        if self.specialise != Some(Specialise::General) {
            cases.push((format!("this scene alone, n = {largest}"), special));
        }
        if self.specialise != Some(Specialise::Scene) {
            for &exponent in self.exponents {
                let cores = equal_cores(&with_exponent(frame, exponent), self.most)?;
                cases.push((format!("any scene, n = {exponent}"), cores));
            }
        }
        Ok(cases)
    }
}

/// The contenders' cores at equal error.
fn equal_cores(frame: &Frame, most: f64) -> Result<[EqualCore; CONTENDERS.len()], ToolError> {
    let [a, b, c, d] = CONTENDERS
        .map(|contender| -> Result<EqualCore, ToolError> { Ok(contender.core(frame, most)??) });
    Ok([a?, b?, c?, d?])
}

/// The frame with one exponent for all materials.
fn with_exponent(frame: &Frame, shininess: u32) -> Frame {
    let materials = frame
        .materials
        .iter()
        .map(|material| specula_scene::Material { shininess, ..material.clone() });
    Frame { materials: materials.collect(), ..frame.clone() }
}

fn counts(design: &Design, (cells, logic): (Cells, Logic)) -> Counts {
    let (Cells { luts, blocks, .. }, Logic { gates, luts: luts_alone, flip_flops }) =
        (cells, logic);
    Counts { gates, luts_alone, luts, blocks, flip_flops, ..Counts::of(design) }
}
