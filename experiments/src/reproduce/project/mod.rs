//! The lecture's programming project, with the schemes of the other papers beside its own: models,
//! shaded by loops in f32, and what the papers claim of their speed.
mod claim;
pub mod model;
mod timed;

pub use claim::{CLAIMS, Outcome, SpeedClaim};
pub use model::Model;
pub use timed::{Timed, timed};

/// An algorithm of the project.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Algorithm {
    /// Its name in the papers.
    pub title: &'static str,
    /// The loop under lights and for an eye at infinity; `None` for one that is of use only at
    /// places.
    pub at_infinity: Option<&'static str>,
    /// The loop under a light and for an eye at places.
    pub at_places: &'static str,
    /// Where the loop at places takes directions from.
    pub seen_from: &'static str,
}

/// The algorithms: the lecture's four, Hast's and Reshetov's.
pub const ALGORITHMS: [Algorithm; 14] = [
    Algorithm { seen_from: "vertices", ..everywhere("Gouraud shading", "gouraud") },
    Algorithm {
        title: "naive Phong shading",
        at_infinity: Some("phong"),
        at_places: "phong-places",
        seen_from: "pixels, by a root",
    },
    Algorithm {
        title: "naive Phong shading, directions wrapped (Hast, eq. 36 to 38)",
        at_infinity: None,
        at_places: "phong-wrapped-places",
        seen_from: "pixels, without a root",
    },
    everywhere("fast Phong shading, one Newton step", "fast-phong"),
    everywhere("Phong shading by slerp", "slerp"),
    everywhere("Duff, eq. 34", "duff"),
    everywhere("Duff, eq. 33", "duff-quotient"),
    everywhere("Lyon, R - L and f_2", "lyon-reflection"),
    Algorithm {
        seen_from: "vertices and middles of spans",
        ..everywhere("hybrid shading", "hybrid")
    },
    everywhere("reflection shading, eq. 34", "reflection"),
    everywhere("consistent normals, rational q", "consistent"),
    everywhere("consistent normals, trigonometric q", "consistent-trigonometric"),
    everywhere("Phong shading with Blinn's highlight", "phong-blinn"),
    everywhere("consistent normals for L and H, rational q", "consistent-normal"),
];

const fn everywhere(title: &'static str, name: &'static str) -> Algorithm {
    Algorithm { title, at_infinity: Some(name), at_places: name, seen_from: "middles of spans" }
}
