//! Random spans without any restriction.
use crate::stress::draw::Draw;
use crate::stress::row::{Case, CatalogueRow, TrialExtent, scenes};
use crate::stress::scene::{RawSpan, SpanScene, material};

/// Random spans.
pub const ANYTHING: CatalogueRow = CatalogueRow {
    id: "any",
    input: "random normals near each other, anywhere and opposite, random weights and cones, one to four lights anywhere",
    trial: scenes(|draw, extent| {
        let frames = 1 + extent.spans / 16;
        (0..frames).map(|_| Case::new(scene(draw, extent))).collect()
    }),
};

fn scene(draw: &mut Draw, extent: TrialExtent) -> SpanScene {
    let lights: Vec<glam::DVec3> = (0..draw.between(1, 4)).map(|_| draw.direction()).collect();
    let longest = draw.one_of(&[3, 20, 150, extent.longest]).min(extent.longest);
    SpanScene::new(&lights, (0..extent.spans).map(|_| span(draw, longest)).collect())
}

fn span(draw: &mut Draw, longest: u32) -> RawSpan {
    let first = draw.direction();
    let near = |draw: &mut Draw| (first + 0.5 * draw.direction()).try_normalize().unwrap_or(first);
    let normals = match draw.between(0, 3) {
        0 => [first; 3],
        1 => [first, -first, draw.direction()],
        2 => [first, draw.direction(), draw.direction()],
        _ => [first, near(draw), near(draw)],
    };
    let weights = |draw: &mut Draw| {
        let (a, b) = (draw.unit(), draw.unit());
        [a, (1.0 - a) * b, (1.0 - a) * (1.0 - b)]
    };
    let reflectances = |draw: &mut Draw| [draw.unit(), draw.unit(), draw.unit()];
    let grey = material(0.0, 0.0, 0.0, draw.even_shininess());
    RawSpan {
        length: draw.length(longest),
        normals,
        face: None,
        positions: [glam::DVec3::ZERO; 3],
        cone_cosines: draw.one_of(&[[1.0; 3], [0.0; 3], [0.3, 0.9, -0.1]]),
        start: weights(draw),
        end: weights(draw),
        material: specula_scene::Material {
            ambient: reflectances(draw),
            diffuse: reflectances(draw),
            specular: reflectances(draw),
            ..grey
        },
    }
}
