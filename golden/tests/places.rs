//! Wrapped directions to lights and eyes at places, on the built-in scene `lamps`, against
//! numerics N2b.
use glam::DVec3;
use specula_golden::exact::formula::{point_light, wrap};
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_scene::{Frame, Needs, Span, Wrap, load};
use specula_spec::phong::Places;
use specula_spec::{CoreSpec, Method, MethodSpec};

fn lamps() -> Frame {
    load("lamps", Some((160, 120))).unwrap().frame
}

/// The place and the wrap of every light and eye at a place.
fn wraps(frame: &Frame, span: &Span) -> Vec<(DVec3, Wrap)> {
    let eye = frame.eye.map(|eye| (eye, Wrap::to_eye(frame, span, eye)));
    let light = |light| {
        (specula_scene::LocalLight::clone(light).position, Wrap::to_light(frame, span, light))
    };
    frame.local_lights.iter().map(light).chain(eye).collect()
}

/// The angle between two vectors, in radians.
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// numerics N2b: θ - 2 atan(l sin θ/(1 + l cos θ)), θ the angle from w and l the length of what is
/// wrapped. At the ends of spans l is 1, and directions are those of the true vectors.
#[test]
fn wraps_err_by_what_numerics_says() {
    let frame = lamps();
    let mut largest: f64 = 0.0;
    for span in &frame.spans {
        for (place, wrap) in wraps(&frame, span) {
            for i in 0..span.length {
                let x = wrap.chord(span.parameter(i));
                if x.dot(wrap.axis) <= 0.0 {
                    continue;
                }
                let wrapped = point_light::wrapped(wrap.axis, x);
                assert!((wrapped.length() - 1.0).abs() < 1e-12);
                let predicted = wrap::error(angle(wrap.axis, x), x.length());
                assert!(
                    (angle(wrapped, x) - predicted.abs()).abs() < 1e-7,
                    "{} and {predicted}",
                    angle(wrapped, x)
                );
                let to_place = place - frame.position_at(span, span.weights(i));
                let off = angle(wrapped, to_place);
                assert!(i > 0 && i + 1 < span.length || off < 1e-7, "an end is off by {off}");
                largest = largest.max(off);
            }
        }
    }
    println!("directions are off by {:.5} degrees at most", largest.to_degrees());
    assert!(largest > 0.0 && largest.to_degrees() < 0.1);
}

/// What that makes of pixels: an angle ε of L turns N·L by ε and R·L by ε, one of V turns R·L by ε,
/// and n multiplies the latter.
#[test]
fn pixels_of_lamps_err_by_little() {
    let frame = lamps();
    let mut core = CoreSpec::for_scene(&Needs::of(&frame), None, Some(Method::Phong)).unwrap();
    if let MethodSpec::Phong(phong) = &mut core.method {
        phong.places = Places::Wrapped;
    }
    let mut largest: f64 = 0.0;
    for span in &frame.spans {
        let (wrapped, exact) = (MethodSpan::new(&core, &frame, span), PhongSpan::new(&frame, span));
        for i in 0..span.length {
            let (a, b) = (wrapped.pixel(i), exact.pixel(i));
            largest = (0..3).map(|c| (a[c] - b[c]).abs()).fold(largest, f64::max);
        }
    }
    let most = Needs::of(&frame).most_off_by_wraps;
    println!("pixels are off by {largest:.4} LSB at most, of {most:.4} that were told");
    assert!(largest > 0.0 && largest <= most && most < 3.0);
}
