//! The papers' tables: operations per pixel and light in the inner loop. As in the papers, the
//! power and the materials' products are left out.
//!
//! A test runs each [`Scheme`] on [`Counted`] numbers and compares.
use glam::DVec3;

use crate::loops::{
    Chebyshev, Counted, Duff, DuffBlinn, DuffHybrid, DuffQuotient, DuffRoot, FastPhong, FrameSlerp,
    Gouraud, Hybrid, Line, Phong, Reflection, ReflectionBlinn, ReflectionHybrid, ReflectionRoot,
    Scheme, Slerp, Uniform, count,
};

pub use super::operation_counts::Operations;

/// A row of a paper's table.
#[derive(Clone, Copy, Debug)]
pub struct SchemeRow {
    /// The name of the method in [`software`](super::software), if it is one.
    pub name: &'static str,
    /// The number in docs/methods.md, and the paper's equation.
    pub source: &'static str,
    /// The operations that the paper states.
    pub printed: Operations,
    /// The operations of the code for one pixel.
    pub counted: fn(&Line, DVec3) -> Operations,
}

/// Counts the operations of a scheme for one pixel.
fn pixel<S: Scheme<Counted>>(line: &Line, light: DVec3) -> Operations {
    let mut scheme = S::new(line, light);
    count(|| {
        scheme.pixel();
    })
}

const fn row<S: Scheme<Counted>>(
    name: &'static str,
    source: &'static str,
    [adds, subtractions, multiplies, divisions, square_roots]: [u32; 5],
) -> SchemeRow {
    let printed = Operations { adds, subtractions, multiplies, divisions, square_roots };
    SchemeRow { name, source, printed, counted: pixel::<S> }
}

/// Additions, subtractions, multiplications, divisions and square roots of each scheme.
pub const TABLE: [SchemeRow; 17] = [
    row::<Uniform<Counted>>("uniform", "A3, lecture eq. 2.1", [0, 0, 0, 0, 0]),
    // One addition for each intensity, diffuse and specular.
    row::<Gouraud<Counted>>("gouraud", "A4, lecture eq. 3.6", [2, 0, 0, 0, 0]),
    // 3 additions; normalisation 3 * 2 + / √; J and K 6 * 4 +; 2JK - L·V.
    row::<Phong<Counted>>("phong", "A5, lecture eq. 4.1, 4.2, 4.5", [10, 1, 10, 3, 1]),
    // ΔJ, ΔK, ΔN 5 +; D 3 * 2 +; J/d; (2K)J/D - L·V; a Newton step / and +, as (x + D/x)/2.
    row::<FastPhong<Counted, 1>>(
        "fast-phong",
        "A6 and A7, lecture eq. 4.3 to 4.6",
        [8, 1, 4, 3, 0],
    ),
    // 8 * and 4 ± for the weights; J and K 4 * 2 +; 2KJ - L·V.
    row::<Slerp<Counted>>("slerp", "A10, lecture eq. 4.9 to 4.12", [4, 3, 13, 0, 0]),
    row::<FrameSlerp<Counted>>("slerp-frame", "A11", [3, 2, 9, 0, 0]),
    row::<Chebyshev<Counted>>("chebyshev", "A12", [0, 3, 3, 0, 0]),
    row::<Duff<Counted>>("duff-diffuse", "C2, Hast eq. 3 to 8", [3, 0, 0, 1, 1]),
    row::<Hybrid<Counted>>("hybrid", "C3, Hast eq. 17 to 26", [5, 0, 0, 1, 0]),
    row::<Reflection<Counted>>("reflection-diffuse", "C6, Hast eq. 29 to 32", [4, 0, 0, 1, 0]),
    row::<DuffBlinn<Counted>>("duff-blinn", "C8", [4, 0, 2, 1, 1]),
    row::<DuffHybrid<Counted>>("duff-hybrid", "C9, Hast eq. 17", [5, 0, 0, 2, 1]),
    row::<DuffQuotient<Counted>>("duff-quotient", "C10, Hast eq. 33", [4, 1, 1, 2, 1]),
    row::<DuffRoot<Counted>>("duff", "C11, Hast eq. 34", [4, 1, 3, 1, 1]),
    row::<ReflectionBlinn<Counted>>("reflection-blinn", "C12, Hast eq. 29", [6, 0, 2, 1, 0]),
    row::<ReflectionHybrid<Counted>>(
        "reflection-hybrid",
        "C13, Hast eq. 17 and 29",
        [8, 0, 0, 2, 0],
    ),
    row::<ReflectionRoot<Counted>>("reflection", "C14, Hast eq. 34", [6, 1, 3, 1, 0]),
];
