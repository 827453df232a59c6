//! Bases of powers.
use glam::DVec3;

use crate::stress::draw::{Draw, tilted};
use crate::stress::row::{Case, CatalogueRow, Pixel, TrialExtent, all, scenes};
use crate::stress::scene::{RawSpan, SpanScene, material, mirror};

/// Row 5.
pub const NEGATIVE: CatalogueRow = CatalogueRow {
    id: "5",
    input: "a base below 0 and an even power: the light 91 to 180 degrees from R",
    trial: scenes(|draw, extent| {
        let angles = [91.0, 100.0, 135.0, 180.0]
            .into_iter()
            .chain((0..extent.spans / 8).map(|_| draw.within(90.0, 180.0)));
        let case = |degrees: f64| {
            let span = |n| RawSpan::between([DVec3::Z; 2], 4, mirror(n));
            let dark = |pixel: &Pixel| pixel.method() > 0.0 || pixel.code() == 0;
            let scene = SpanScene::new(&[tilted(degrees)], [1, 2, 256].map(span).into());
            Case::new(scene).requiring(
                "no highlight where the method has none in exact arithmetic",
                all,
                dark,
            )
        };
        angles.map(case).collect()
    }),
};

/// A quarter of full scale, so that a base above 1 shows.
const QUARTER: f64 = 0.25;

/// Row 6.
pub const ABOVE_ONE: CatalogueRow = CatalogueRow {
    id: "6",
    input: "the light in the eye's reflection, n = 4096: a base above 1 by rounding",
    trial: scenes(|draw, extent| {
        let angles = [0.0, 14.3, 37.9, 59.9, 81.2]
            .into_iter()
            .chain((0..extent.spans / 8).map(|_| draw.within(0.0, 90.0)));
        let case = |degrees: f64| {
            let span =
                RawSpan::between([tilted(degrees); 2], 33, material(0.0, 0.0, QUARTER, 4096));
            let below = |pixel: &Pixel| f64::from(pixel.code()) <= (255.0 * QUARTER).round();
            let scene = SpanScene::new(&[tilted(2.0 * degrees)], vec![span]);
            Case::new(scene).requiring(
                "no more than a base of 1 gives, a quarter of full scale",
                all,
                below,
            )
        };
        angles.map(case).collect()
    }),
};

/// Row 53.
pub const CENTRE: CatalogueRow = CatalogueRow {
    id: "53",
    input: "the highlight's centre exactly on a pixel, n = 1 to 4096",
    trial: scenes(|_: &mut Draw, _: TrialExtent| {
        let span = |j: u32| RawSpan::between([DVec3::Z; 2], 5, mirror(1 << j));
        let scene = SpanScene::new(&[DVec3::Z], (0..=12).map(span).collect());
        vec![Case::new(scene).requiring("255", all, |pixel| pixel.code() == 255)]
    }),
};
