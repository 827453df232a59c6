//! Perspective pictures against an independent ray caster.
mod nonsense;
mod property;
mod shot;

use glam::DVec3;
use specula_fixtures::ray_caster::{Hit, RayCaster};
use specula_scene::primitive::Primitive;
use specula_scene::{Frame, Span};

use shot::{Model, Shot, camera};

/// How far beside a pixel's centre, in pixels, a ray may see what the picture shows there: corners are
/// moved to a grid of 1/256 pixel.
const OFF: f64 = 1.0 / 256.0;

fn shots() -> Vec<(&'static str, Shot)> {
    let teapot =
        Model::mirrored("primitive = \"teapot\"\nlevel = 4", Primitive::Teapot { level: 4 });
    let torus = Model::mirrored(
        "primitive = \"torus\"\nlevel = 6\ntube = 0.45",
        Primitive::Torus { level: 6, tube: 0.45 },
    );
    let (building, hills) = (Model::file("building.obj"), Model::file("hills.obj"));
    let shot = |model: &Model, camera| Shot { model: model.clone(), camera };
    vec![
        ("teapot", shot(&teapot, camera([3.0, 4.0, 6.0], [0.2, 1.5, 0.0], 0.01))),
        ("teapot, from inside", shot(&teapot, camera([0.1, 1.2, 0.2], [3.0, 1.5, 0.5], 0.01))),
        ("torus", shot(&torus, camera([1.5, 0.9, 1.4], [0.0, 0.0, 0.0], 0.01))),
        (
            "torus, cut by the near plane",
            shot(&torus, camera([1.5, 0.9, 1.4], [0.0, 0.0, 0.0], 1.5)),
        ),
        ("building", shot(&building, camera([8.0, 1.7, 10.0], [0.0, 3.0, 0.0], 0.01))),
        (
            "building, from a window",
            shot(&building, camera([0.0, 2.0, 0.0], [3.9, 2.2, 1.0], 0.01)),
        ),
        ("hills", shot(&hills, camera([1.0, 5.0, 2.0], [-6.0, 1.0, -20.0], 0.01))),
        (
            "hills, cut by the near plane",
            shot(&hills, camera([1.0, 5.0, 2.0], [-6.0, 1.0, -20.0], 9.0)),
        ),
    ]
}

/// The span and pixel number at each pixel of a picture, if there are any.
fn by_pixel(frame: &Frame) -> Vec<Option<(&Span, u32)>> {
    let mut pixels = vec![None; (frame.width * frame.height) as usize];
    for span in &frame.spans {
        for i in 0..span.length {
            let pixel = &mut pixels[(span.y * frame.width + span.x + i) as usize];
            assert!(pixel.is_none(), "{span:?} is not alone at pixel {i}");
            *pixel = Some((span, i));
        }
    }
    pixels
}

/// How many pixels show something else than a ray through their centre, which a ray beside it has to
/// see.
fn differing(shot: &Shot, frame: &Frame) -> usize {
    let caster = shot.caster();
    let mut differing = 0;
    for (at, pixel) in by_pixel(frame).into_iter().enumerate() {
        let [x, y] = [at as u32 % frame.width, at as u32 / frame.width].map(|n| f64::from(n) + 0.5);
        let seen = pixel.map(|(span, i)| frame.position_at(span, frame.seen_weights(span, i)));
        let hit = caster.hit(x, y);
        match seen {
            Some(seen) if !is_at(&caster, hit, seen) => {
                differing += 1;
                let [u, v] = caster.place(seen);
                assert!((u - x).abs().max((v - y).abs()) < OFF, "{x} {y}: {seen} is at {u} {v}");
                let hides = |hit: Hit| hit.depth < caster.depth(seen) - tolerance(&caster, hit);
                let is_hidden = beside(x, y).all(|(x, y)| caster.hit(x, y).is_some_and(hides));
                assert!(!is_hidden, "{x} {y}: {seen} is hidden");
            }
            None if hit.is_some() => {
                differing += 1;
                assert!(is_empty_beside(&caster, x, y), "{x} {y}: {hit:?} is not seen");
            }
            _ => {}
        }
    }
    differing
}

/// Whether what a ray meets is a point that is seen.
fn is_at(caster: &RayCaster, hit: Option<Hit>, seen: DVec3) -> bool {
    hit.is_some_and(|hit| (hit.depth - caster.depth(seen)).abs() <= tolerance(caster, hit))
}

/// How much the distance of a surface changes over a hundredth of a pixel.
fn tolerance(caster: &RayCaster, hit: Hit) -> f64 {
    0.01 * caster.pixel() * hit.depth / hit.cosine.max(1e-6)
}

/// Whether rays through the centres of all pixels, or beside them, meet nothing.
fn is_empty(shot: &Shot) -> bool {
    let (caster, (width, height)) = (shot.caster(), shot.camera.size);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (f64::from(x), f64::from(y))));
    pixels.into_iter().all(|(x, y)| is_empty_beside(&caster, x + 0.5, y + 0.5))
}

/// Whether a ray through a place of the picture, or beside it, meets nothing.
fn is_empty_beside(caster: &RayCaster, x: f64, y: f64) -> bool {
    beside(x, y).any(|(x, y)| caster.hit(x, y).is_none())
}

/// A place of the picture and eight around it.
fn beside(x: f64, y: f64) -> impl Iterator<Item = (f64, f64)> {
    let steps = [-OFF, 0.0, OFF];
    steps.into_iter().flat_map(move |i| steps.map(|j| (x + i, y + j)))
}

/// Every pixel shows what a ray through its centre meets, or one through a place 1/256 pixel beside it.
#[test]
fn pictures_show_what_rays_meet() {
    for (name, shot) in shots() {
        let frame = shot.frame("screen").unwrap_or_else(|error| panic!("{name}: {error}"));
        let (differing, pixels) = (differing(&shot, &frame), frame.shaded_pixels());
        println!("{name}: {differing} of {pixels} pixels");
        assert!(pixels > 1000 && differing * 500 < pixels as usize, "{name}: {differing}");
    }
}

/// Perspective-correct weights at each pixel stand for the point whose image is the pixel's centre,
/// whatever the weights between the ends of spans.
#[test]
fn seen_weights_stand_for_what_is_at_the_pixel() {
    for (name, shot) in shots() {
        let caster = shot.caster();
        for interpolation in ["screen", "perspective"] {
            let frame = shot.frame(interpolation).expect("the scene is right");
            for span in &frame.spans {
                for i in 0..span.length {
                    let [x, y] = caster.place(frame.position_at(span, frame.seen_weights(span, i)));
                    let off = [x - f64::from(span.x + i) - 0.5, y - f64::from(span.y) - 0.5];
                    assert!(off.iter().all(|off| off.abs() < OFF), "{name}: {off:?} {span:?} {i}");
                }
            }
        }
    }
}

/// What depends on the interpolation is weights alone, and perspective-correct ones are those that are
/// seen at both ends of each span.
#[test]
fn interpolation_changes_weights_alone() {
    for (name, shot) in shots() {
        let [screen, perspective] =
            ["screen", "perspective"].map(|way| shot.frame(way).expect("the scene is right"));
        let mut differ = 0;
        assert_eq!(screen.spans.len(), perspective.spans.len(), "{name}");
        for (one, other) in screen.spans.iter().zip(&perspective.spans) {
            assert_eq!((one.x, one.y, one.length), (other.x, other.y, other.length), "{name}");
            differ += usize::from(one.start != other.start);
            for (weights, i) in [(other.start, 0), (other.end, other.steps())] {
                let seen = perspective.seen_weights(other, i);
                assert!((0..3).all(|v| (weights[v] - seen[v]).abs() < 1e-9), "{name}: {other:?}");
                assert_eq!(seen, screen.seen_weights(one, i), "{name}");
            }
        }
        assert!(differ > 0, "{name}");
    }
}

/// Weights are 0 to 1 and add up to 1; normals are turned to the eye.
#[test]
fn frames_keep_to_what_they_say() {
    for (name, shot) in shots() {
        let eye = shot.caster().in_view(shot.camera.eye);
        for interpolation in ["screen", "perspective"] {
            let frame = shot.frame(interpolation).expect("the scene is right");
            for span in &frame.spans {
                for weights in [span.start, span.end] {
                    assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)), "{name}: {span:?}");
                    assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-14, "{name}: {span:?}");
                }
                assert!(span.length > 1 || span.start == span.end);
            }
            for triangle in &frame.triangles {
                let [a, b, c] = triangle.positions;
                let own = (b - a).cross(c - a).normalize();
                let seen = own * own.dot(eye - a).signum();
                assert!(triangle.facet.normal.dot(seen) > 0.0, "{name}: {triangle:?}");
                let outward = triangle.normals.iter().sum::<DVec3>();
                assert!(outward.dot(seen) > -1e-12, "{name}: {triangle:?}");
            }
        }
    }
}
