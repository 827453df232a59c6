//! Which methods shade a scene.
use specula_scene::{Frame, Method};

/// Those that shade lights and eyes at places.
const FROM_PLACES: [Method; 2] = [Method::Phong, Method::Gouraud];

/// Every method, or those that shade from places where lights or the eye are at some.
pub fn methods(frame: &Frame) -> Vec<Method> {
    let at_infinity = frame.local_lights.is_empty() && frame.eye.is_none();
    Method::ALL.into_iter().filter(|&method| at_infinity || FROM_PLACES.contains(&method)).collect()
}
