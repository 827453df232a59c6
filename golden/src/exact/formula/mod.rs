//! The papers' formulas in f64, each a function of vectors and numbers. Methods and loops use them,
//! and claims are measured with them.
pub mod consistent;
pub mod differences;
pub mod diffuse;
pub mod direct;
pub mod distributions;
pub mod hast;
pub mod illumination;
pub mod newton;
pub mod normalisation;
pub mod point_light;
pub mod quadratic;
pub mod reflection;
pub mod root_shininess;
pub mod scan_line;
pub mod shape;
pub mod slerp;
pub mod specular;
pub mod wrap;
