//! Lengths of spans.
use glam::DVec3;

use super::scenes::{aimed, flat_from_end_to_end, spans};
use crate::stress::draw::tilted;
use crate::stress::row::{Case, CatalogueRow, scenes};
use crate::stress::scene::{RawSpan, SpanScene, lit, mirror};

/// Row 37.
pub const SHORTEST: CatalogueRow = CatalogueRow {
    id: "37",
    input: "one, two and three pixels",
    trial: scenes(|draw, extent| {
        let span = |length| RawSpan::between([tilted(-20.0), tilted(20.0)], length, lit(64));
        let mut random = spans(draw, extent, [0.0, 120.0], lit);
        random.iter_mut().for_each(|span| span.length = draw.between(1, 3) as u32);
        let alone = [1, 2, 3].map(|length| {
            Case::new(SpanScene::new(&[tilted(-38.0), tilted(39.0)], vec![span(length)]))
        });
        alone.into_iter().chain([Case::new(aimed(draw, random))]).collect()
    }),
};

/// Row 38.
pub const LONGEST: CatalogueRow = CatalogueRow {
    id: "38",
    input: "8192 pixels, where a second difference's error adds up 2^24 times; n = 4096 and 256",
    trial: scenes(|_, extent| {
        let wide = |(degrees, n): (f64, u32)| {
            let ends = [tilted(-degrees / 3.0), tilted(degrees * 2.0 / 3.0)];
            Case::new(SpanScene::new(
                &[tilted(degrees)],
                vec![RawSpan::between(ends, 8192, mirror(n))],
            ))
        };
        let angles = [(90.0, 4096), (30.0, 256), (1.0, 4096), (150.0, 16)];
        angles.into_iter().take(if extent.every_option { 4 } else { 1 }).map(wide).collect()
    }),
};

/// Row 52.
pub const FLAT: CatalogueRow = CatalogueRow {
    id: "52",
    input: "a flat face: k.k = 0 and no difference",
    trial: scenes(|draw, extent| {
        let fixed = [0.0, 17.3, 60.0, 85.0].map(tilted).into_iter();
        let random: Vec<DVec3> = (0..extent.spans).map(|_| draw.direction()).collect();
        let flat = |normal| RawSpan::between([normal; 2], 1000.min(extent.longest), lit(64));
        let all = fixed.chain(random).map(flat).collect();
        vec![flat_from_end_to_end(SpanScene::new(&[tilted(31.9), tilted(-110.0)], all))]
    }),
};
