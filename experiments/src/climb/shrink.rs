//! Minimises scenes that show a fault.
use glam::DVec3;
use specula_spec::{LightPipelines, Specialise};

use super::genome::Genome;
use crate::stress::scene::{RawSpan, SpanScene};

/// Largest number of scenes that are tried to make one smaller.
const MAX_TRIED: usize = 300;

/// The genome without everything that its fault does not need, and the fault of the result.
///
/// `wrong` gives the fault of a genome, if it has one. A change is kept if a fault remains; changes
/// are repeated until none is kept, or too many have been tried.
pub(super) fn shrink<T>(
    genome: &Genome,
    is_wrong: T,
    wrong: &dyn Fn(&Genome) -> Option<T>,
) -> (Genome, T) {
    let (mut best, mut tried) = ((genome.clone(), is_wrong), 0);
    loop {
        let text = best.0.text();
        let smaller = simpler(&best.0).into_iter().take(MAX_TRIED - tried).find_map(|simpler| {
            tried += 1;
            // A repair may have put back what was removed, since the core needs it.
            let simpler = simpler.repaired().filter(|simpler| simpler.text() != text)?;
            wrong(&simpler).map(|is_wrong| (simpler, is_wrong))
        });
        match smaller {
            Some(smaller) => best = smaller,
            None => return best,
        }
    }
}

/// Genomes that are simpler by one step each, those with the largest steps first.
fn simpler(genome: &Genome) -> Vec<Genome> {
    let scene = |scene: SpanScene| Genome { scene, core: genome.core.clone() };
    let scenes = fewer(&genome.scene).into_iter().chain(plainer(&genome.scene)).map(scene);
    scenes.chain(simpler_cores(genome)).collect()
}

/// Scenes without one span, without one light, or with shorter spans.
fn fewer(scene: &SpanScene) -> Vec<SpanScene> {
    let mut fewer = Vec::new();
    if scene.spans.len() > 1 {
        fewer.extend((0..scene.spans.len()).map(|span| without_span(scene, span)));
    }
    if scene.lights.len() > 1 {
        fewer.extend((0..scene.lights.len()).map(|light| without_light(scene, light)));
    }
    for (span, length) in scene.spans.iter().map(|span| span.length).enumerate() {
        for shorter in [1, length / 2, length - length / 8]
            .into_iter()
            .filter(|&shorter| (1..length).contains(&shorter))
        {
            let mut changed = scene.clone();
            changed.spans[span].length = shorter;
            fewer.push(changed);
        }
    }
    fewer
}

fn without_span(scene: &SpanScene, span: usize) -> SpanScene {
    let mut changed = scene.clone();
    changed.spans.remove(span);
    changed
}

fn without_light(scene: &SpanScene, light: usize) -> SpanScene {
    let mut changed = scene.clone();
    changed.lights.remove(light);
    changed.colours.remove(light);
    changed
}

/// Scenes with plain values in place of others.
fn plainer(scene: &SpanScene) -> Vec<SpanScene> {
    let mut plainer = Vec::new();
    if scene.eye.is_some() {
        plainer.push(SpanScene { eye: None, ..scene.clone() });
    }
    if scene.ambient != [0.0; 3] {
        plainer.push(SpanScene { ambient: [0.0; 3], ..scene.clone() });
    }
    if scene.colours.iter().any(|colour| *colour != [1.0; 3]) {
        plainer.push(SpanScene { colours: vec![[1.0; 3]; scene.lights.len()], ..scene.clone() });
    }
    for (number, span) in scene.spans.iter().enumerate() {
        for span in plainer_spans(span) {
            let mut changed = scene.clone();
            changed.spans[number] = span;
            plainer.push(changed);
        }
    }
    plainer
}

const PLAIN: [fn(&mut RawSpan); 10] = [
    |span| span.face = None,
    |span| span.positions = [DVec3::ZERO; 3],
    |span| span.cone_cosines = [1.0; 3],
    |span| (span.start, span.end) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
    |span| span.normals[2] = span.normals[0],
    |span| span.material.ambient = [0.0; 3],
    |span| span.material.diffuse = [0.0; 3],
    |span| span.material.specular = [0.0; 3],
    |span| span.material.diffuse = [1.0; 3],
    |span| span.material.specular = [1.0; 3],
];

fn plainer_spans(span: &RawSpan) -> impl Iterator<Item = RawSpan> + '_ {
    PLAIN.iter().filter_map(|change| {
        let mut changed = span.clone();
        change(&mut changed);
        // A black channel is as plain as a white one: neither replaces the other.
        let is_plain = |colour: [f64; 3]| colour == [0.0; 3];
        let brightens = is_plain(span.material.diffuse) && !is_plain(changed.material.diffuse)
            || is_plain(span.material.specular) && !is_plain(changed.material.specular);
        (changed != *span && !brightens).then_some(changed)
    })
}

/// Genomes with a default in place of another option or format.
fn simpler_cores(genome: &Genome) -> Vec<Genome> {
    let mut simpler = Vec::new();
    let core = &genome.core;
    for (name, _) in &core.formats {
        let mut changed = genome.clone();
        changed.core.formats.retain(|(other, _)| other != name);
        simpler.push(changed);
    }
    for (key, _) in &core.options {
        let mut changed = genome.clone();
        changed.core.options.retain(|(other, _)| other != key);
        simpler.push(changed);
    }
    if core.light_pipelines != LightPipelines::Each {
        let mut changed = genome.clone();
        changed.core.light_pipelines = LightPipelines::Each;
        simpler.push(changed);
    }
    if core.specialise != Specialise::Scene {
        let mut changed = genome.clone();
        changed.core.specialise = Specialise::Scene;
        simpler.push(changed);
    }
    simpler
}
