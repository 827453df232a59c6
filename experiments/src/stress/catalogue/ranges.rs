//! Values at the ends of their ranges.
use glam::DVec3;

use crate::stress::draw::{AXES, tilted};
use crate::stress::row::{Case, CatalogueRow, all, scenes};
use crate::stress::scene::{RawSpan, SpanScene, material, matt, mirror};

/// Row 26.
pub const LONGER_THAN_ONE: CatalogueRow = CatalogueRow {
    id: "26",
    input: "unit normals that come out longer when rounded, every 3 degrees and in random directions",
    trial: scenes(|draw, extent| {
        let flat = |normal| RawSpan::between([normal; 2], 2, mirror(256));
        let fixed = (1..30).map(|k| flat(tilted(3.0 * f64::from(k))));
        let random: Vec<DVec3> = (0..4 * extent.spans).map(|_| draw.direction()).collect();
        let all = fixed.chain(random.into_iter().map(flat)).collect();
        vec![Case::new(SpanScene::new(&[tilted(60.0), DVec3::Z], all))]
    }),
};

/// Row 29.
pub const ALONG_AXES: CatalogueRow = CatalogueRow {
    id: "29",
    input: "normals and lights along every axis, both ways",
    trial: scenes(|_, _| {
        let case = |&light: &DVec3| {
            let scene = SpanScene::new(
                &[light],
                AXES.map(|normal| RawSpan::between([normal; 2], 2, matt())).into(),
            );
            Case::new(scene).requiring("255 where they meet, 0 elsewhere", all, |pixel| {
                f64::from(pixel.code()) == pixel.exact()
            })
        };
        AXES.iter().map(case).collect()
    }),
};

/// Bright light.
pub const BRIGHT: CatalogueRow = CatalogueRow {
    id: "white",
    input: "four lights at full scale on a surface that sends back all of them, four times as bright in its highlight; and none of it",
    trial: scenes(|_, _| {
        let white = RawSpan::between([DVec3::Z; 2], 3, material(1.0, 1.0, 4.0, 64));
        let black = RawSpan::between([tilted(-40.0), tilted(40.0)], 20, material(0.0, 0.0, 0.0, 1));
        let case = |what, span, code| {
            Case::new(SpanScene::new(&[DVec3::Z; 4], vec![span])).requiring(
                what,
                all,
                move |pixel| pixel.code() == code,
            )
        };
        vec![
            case("white where all light comes back", white, 255),
            case("black where none does", black, 0),
        ]
    }),
};
