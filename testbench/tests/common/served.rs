//! Which methods shade a scene.
use specula_scene::{Frame, Method};

/// Every method; only `phong` where lights or the eye are at places.
pub fn methods(frame: &Frame) -> Vec<Method> {
    let at_infinity = frame.local_lights.is_empty() && frame.eye.is_none();
    Method::ALL.into_iter().filter(|&method| at_infinity || method == Method::Phong).collect()
}
