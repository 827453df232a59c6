//! Triangles without area and polygons far away.
use glam::DVec3;
use specula_scene::mesh::normals::newell;

use crate::stress::draw::tilted;
use crate::stress::row::{Case, CatalogueRow, Pixel, Trial, all, scenes};
use crate::stress::scene::{RawSpan, SpanScene, material};

/// Row 50.
pub const TRIANGLES: CatalogueRow = CatalogueRow {
    id: "50",
    input: "normals of no length at both ends, as of triangles without area, and at one",
    trial: scenes(|_, _| {
        let grey = || material(0.2, 0.3, 0.3, 64);
        let none = [1, 2, 100].map(|length| RawSpan::between([DVec3::ZERO; 2], length, grey()));
        let one = [[DVec3::ZERO, DVec3::Z], [tilted(60.0), DVec3::ZERO]]
            .map(|ends| RawSpan::between(ends, 17, grey()));
        let ambient = |pixel: &Pixel| pixel.code() == pixel.ambient();
        let scene = |spans: Vec<RawSpan>| SpanScene::new(&[DVec3::Z, tilted(50.0)], spans);
        let nothing = Case::new(scene(none.into())).requiring(
            "ambient light alone where there is no normal at all",
            all,
            ambient,
        );
        vec![nothing, Case::new(scene(one.into()))]
    }),
};

/// Row 51.
pub const FAR_AWAY: CatalogueRow = CatalogueRow {
    id: "51",
    input: "Newell's normal of a unit square at an offset of 10^6, and of degenerate polygons",
    trial: Trial::Host {
        what: "wrong normals: the square's is exact, and where there is no area there is none",
        check: || {
            let offset = DVec3::splat(1e6);
            let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]
                .map(|corner| corner + offset);
            let flat = [DVec3::ZERO, DVec3::X, 2.0 * DVec3::X];
            match (newell(&square), newell(&flat), newell(&[offset; 3])) {
                (Some(DVec3::Z), None, None) => Ok(()),
                other => Err(format!("the normals are {other:?}")),
            }
        },
    },
};
