//! Errors against exact shading of a smooth surface, where the surface of a mesh is known.
use specula_golden::exact::PhongSpan;
use specula_scene::{LoadedScene, Span};

use specula_testbench::statistics::Sums;
use specula_testbench::{ErrorFigures, Image};

/// The picture's errors against exact shading with the true surface's normals; `None` if no surface
/// is known.
pub(super) fn errors(scene: &LoadedScene, picture: &Image) -> Option<ErrorFigures> {
    against_surface(scene, |span, _, pixel| picture.run(span)[pixel as usize].map(f64::from))
}

/// The errors of interpolation itself: exact shading with interpolated normals against exact
/// shading with the true surface's.
pub fn interpolation_errors(scene: &LoadedScene) -> Option<ErrorFigures> {
    against_surface(scene, |_, phong, pixel| phong.pixel(pixel))
}

/// The value to compare at a pixel of a span, given the span and its exact shading.
trait Given: Fn(&Span, &PhongSpan, u32) -> [f64; 3] + Sync {}

impl<T: Fn(&Span, &PhongSpan, u32) -> [f64; 3] + Sync> Given for T {}

fn against_surface(scene: &LoadedScene, given: impl Given) -> Option<ErrorFigures> {
    if !scene.surfaces.iter().any(Option::is_some) {
        return None;
    }
    Some(Sums::of_spans(&scene.frame, |span| of_span(scene, span, &given)).figures())
}

fn of_span(scene: &LoadedScene, span: &Span, given: &impl Given) -> Sums {
    let (frame, mut sums) = (&scene.frame, Sums::default());
    let Some(surface) =
        scene.surfaces.get(frame.triangles[span.triangle].material).copied().flatten()
    else {
        return sums;
    };
    let phong = PhongSpan::new(frame, span);
    for pixel in 0..span.length {
        let weights = frame.seen_weights(span, pixel);
        let normal =
            surface.normal(frame.position_at(span, weights), frame.normal_at(span, weights));
        let Some(normal) = normal else { continue };
        let (given, exact) = (given(span, &phong, pixel), phong.pixel_with(normal, pixel));
        (0..3).for_each(|c| sums.add(given[c] - exact[c]));
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Finer spheres approach round ones with the square of the level; a teapot has no known
    /// surface.
    #[test]
    fn interpolation_converges_to_the_surface() {
        let sphere = |level: u32| {
            let text =
                format!("size = [64, 48]\n\n[[object]]\nprimitive = \"sphere\"\nlevel = {level}\n");
            interpolation_errors(&specula_scene::parse("sphere.toml", text).unwrap())
                .unwrap()
                .rms_lsb
        };
        let (coarse, fine) = (sphere(6), sphere(24));
        assert!(fine > 0.0 && coarse / fine > 8.0 && coarse / fine < 32.0, "{coarse} {fine}");
        assert_eq!(
            interpolation_errors(&specula_scene::load("teapot", Some((32, 24))).unwrap()),
            None
        );
    }
}
