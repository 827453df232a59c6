//! Exponents.
use crate::stress::draw::tilted;
use crate::stress::row::{Case, CatalogueRow, scenes};
use crate::stress::scene::{RawSpan, SpanScene, lit};

/// Row 54.
pub const EVERY: CatalogueRow = CatalogueRow {
    id: "54",
    input: "exponents that are powers of two and others, 1 to 8191",
    trial: scenes(|draw, extent| {
        let case = |n: u32| {
            Case::new(SpanScene::new(
                &[tilted(5.0)],
                vec![RawSpan::between([tilted(-10.0), tilted(10.0)], 40, lit(n))],
            ))
        };
        let fixed = [1, 2, 3, 5, 100, 255, 256, 257, 4095, 4096, 4097, 8190, 8191];
        let random = (0..extent.spans / 16).map(|_| draw.between(1, 8191) as u32);
        fixed.into_iter().chain(random).map(case).collect()
    }),
};
