//! Hast et al.: operations of their schemes, and normals by reflection.
use glam::DVec3;
use specula_golden::exact::wrap;
use specula_golden::operations::TABLE;
use specula_golden::recurrence::Line;

use super::super::stress::draw::tilted;
use super::{Claim, largest};

/// Rows of the table in which a pixel does other operations than are printed.
fn miscounted() -> f64 {
    let ends = [DVec3::Z, DVec3::new(0.6, 0.0, 0.8)];
    let weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let line = Line { ends, steps: 8, vertices: [ends[0], ends[1], DVec3::Z], weights, shininess: 16 };
    let light = DVec3::new(0.0, 0.6, 0.8);
    TABLE.iter().filter(|row| row.source.contains("Hast") && (row.counted)(&line, light) != row.printed).count() as f64
}

/// By how many degrees a normal is off at most, wrapped around the bisector of a span of `degrees`.
fn wrap_error(degrees: f64) -> f64 {
    let ends = [tilted(-degrees / 2.0), tilted(degrees / 2.0)];
    largest(|t| {
        let normal = ends[0].lerp(ends[1], t);
        wrap::error(libm::atan2(normal.x.abs(), normal.z), normal.length()).abs().to_degrees()
    })
}

const fn wrapped(what: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    // 0.5 LSB of diffuse light is 0.11 degrees.
    Claim { what, quantity: "largest error of the normal in degrees", expected, measure, holds: |error| error < 0.5 / 255.0 * 57.3 }
}

/// The last four by the criterion of half an LSB of diffuse light.
pub const CLAIMS: [Claim; 5] = [
    Claim {
        what: "the table of operations",
        quantity: "schemes that do others than are printed",
        expected: (0.0, 0.0),
        measure: miscounted,
        holds: |wrong| wrong == 0.0,
    },
    wrapped("reflection shading is hard to distinguish (half an LSB of diffuse light): 10 degrees", (0.0037, 5e-5), || {
        wrap_error(10.0)
    }),
    wrapped("reflection shading is hard to distinguish (half an LSB of diffuse light): 30 degrees", (0.10, 5e-3), || {
        wrap_error(30.0)
    }),
    wrapped("reflection shading is hard to distinguish (half an LSB of diffuse light): 60 degrees", (0.85, 5e-3), || {
        wrap_error(60.0)
    }),
    wrapped("reflection shading is hard to distinguish (half an LSB of diffuse light): 90 degrees", (3.2, 5e-2), || {
        wrap_error(90.0)
    }),
];
