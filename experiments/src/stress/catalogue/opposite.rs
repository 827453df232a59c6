//! Normals that oppose each other along a span.
use glam::DVec3;
use specula_spec::{CoreSpec, Method};

use super::scenes::{aimed, spans};
use crate::stress::draw::{Draw, tilted};
use crate::stress::row::{Case, CatalogueRow, Pixel, TrialExtent, scenes};
use crate::stress::scene::{RawSpan, SpanScene, lit, mirror};

/// Row 1.
pub const LERP: CatalogueRow = CatalogueRow {
    id: "1",
    input: "N0 = -N1, t = 1/2 a pixel or not",
    trial: scenes(|draw, extent| opposite(draw, extent, lit(16))),
};

/// Row 2.
pub const DUFF: CatalogueRow = CatalogueRow {
    id: "2",
    input: "N0 = -N1 along an axis: q = 0 at a pixel",
    trial: scenes(|_, _| {
        let span = |length| RawSpan::between([DVec3::Z, -DVec3::Z], length, lit(16));
        let scene = SpanScene::new(&[DVec3::Z], [3, 5, 9, 257].map(span).into());
        let longest = SpanScene::new(
            &[DVec3::Z],
            vec![RawSpan::between([DVec3::Z, -DVec3::Z], 8191, lit(16))],
        );
        let is_duff = |spec: &CoreSpec| spec.method() == Method::Duff;
        let ambient = |pixel: &Pixel| !is_middle(pixel) || pixel.code() == pixel.ambient();
        vec![
            Case::new(scene).requiring("ambient light alone where q = 0", is_duff, ambient),
            Case::new(longest),
        ]
    }),
};

/// Row 3.
pub const WIDE: CatalogueRow = CatalogueRow {
    id: "3",
    input: "spans of 150 to 175 degrees",
    trial: scenes(|draw, extent| {
        let fixed =
            [1, 256, 4096].map(|n| RawSpan::between([tilted(-75.0), tilted(75.0)], 300, mirror(n)));
        let random = spans(draw, extent, [150.0, 175.0], lit);
        vec![
            Case::new(SpanScene::new(&[tilted(10.0)], fixed.into())),
            Case::new(aimed(draw, random)),
        ]
    }),
};

/// Row 4.
pub const HYBRID: CatalogueRow = CatalogueRow {
    id: "4",
    input: "q = 0 in the middle of a span with nothing but highlight",
    trial: scenes(|_, _| {
        let span = |length| RawSpan::between([DVec3::Z, -DVec3::Z], length, mirror(16));
        let divides = |spec: &CoreSpec| matches!(spec.method(), Method::Hybrid | Method::Direct);
        let scene = SpanScene::new(&[DVec3::Z], [3, 5, 9, 257].map(span).into());
        let case = Case::new(scene)
            .requiring("no highlight where q = 0", divides, |pixel| {
                !is_middle(pixel) || pixel.code() == 0
            })
            .requiring("all of it at the ends", divides, |pixel| {
                !pixel.is_end() || pixel.code() == 255
            });
        vec![case]
    }),
};

fn is_middle(pixel: &Pixel) -> bool {
    pixel.span.length % 2 == 1 && pixel.i == pixel.span.length / 2
}

/// Exact shading of the middle is ambient light, and so is the shade of these methods.
fn is_ambient_in_the_middle(pixel: &Pixel) -> bool {
    // It is not required of options that have a direction there, such as flat or wrapped normals.
    !(is_middle(pixel) && pixel.method() == f64::from(pixel.ambient()))
        || pixel.code() == pixel.ambient()
}

fn opposite(draw: &mut Draw, extent: TrialExtent, of: specula_scene::Material) -> Vec<Case> {
    let directions = [DVec3::X, DVec3::Y, DVec3::Z, tilted(40.0), tilted(20.0)];
    let fixed = directions.iter().flat_map(|&first| [3, 4, 33, 257].map(|length| (first, length)));
    let random: Vec<(DVec3, u32)> =
        (0..extent.spans).map(|_| (draw.direction(), draw.length(extent.longest))).collect();
    let span =
        |(first, length): (DVec3, u32)| RawSpan::between([first, -first], length, of.clone());
    let fixed = SpanScene::new(&[tilted(30.0)], fixed.map(span).collect());
    let random = SpanScene::new(
        &[draw.direction(), draw.direction()],
        random.into_iter().map(span).collect(),
    );
    let vanishes = |spec: &CoreSpec| matches!(spec.method(), Method::Lyon | Method::Phong);
    let what = "ambient light alone where the normal vanishes";
    vec![Case::new(fixed).requiring(what, vanishes, is_ambient_in_the_middle), Case::new(random)]
}
