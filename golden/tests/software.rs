//! The loops against f64: each as the method it is, in f64 to its last places, and in f32 to what
//! the paper's recurrence costs there.
//!
//! A scheme is given neither the number of the pixel nor anything but the operations of [`Number`],
//! so that all of them go from pixel to pixel.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, tilted};
use specula_golden::exact::formula::normalisation::g2;
use specula_golden::exact::formula::reflection::reflection_minus_light;
use specula_golden::exact::formula::shape::lobe;
use specula_golden::exact::formula::wrap;
use specula_golden::exact::{MethodSpan, phong};
use specula_golden::loops::software::{METHODS, Mesh, by_name};
use specula_golden::loops::{
    Blinn, Chained, Chebyshev, Consistent, ConsistentNormal, Direct, DuffBlinn, DuffHybrid,
    DuffQuotient, DuffRoot, FastPhong, FrameSlerp, Gouraud, Half, HalfG2, Hybrid, Line, LyonCross,
    LyonLightReflection, LyonNormal, LyonProjection, LyonReflection, Pair, Phong, Rational,
    ReflectionBlinn, ReflectionHybrid, ReflectionRoot, Scheme, Slerp, Sum, TorranceSparrow,
    Trigonometric, TrowbridgeReitz, Uniform, Unit,
};
use specula_scene::frame::EYE;
use specula_scene::{Attenuation, DirectionalLight, Frame, LocalLight, Needs, Spot};
use specula_spec::phong::Places;
use specula_spec::{CoreSpec, FULL_SCALE, Method, MethodSpec};

const STEPS: u32 = 64;
const SHININESS: u32 = 16;
const REFLECTANCES: [f64; 3] = [0.1, 0.3, 0.5];

/// What roundings add up to over a span of S steps, in units of the type's 2^-24 or 2^-53.
#[derive(Clone, Copy)]
enum Growth {
    /// A pixel is worked out by itself: some dozens of operations on numbers up to 2.
    Pixel,
    /// What grows by a step is off by S units more, and so are the factors and divisors that are
    /// made of it, eight at most: N·N has three components twice, and a rotation two products a
    /// step, over sin 30°.
    Step,
    /// Second differences are off by 1 + S + S²/2 units (numerics N3b): p and q of a quotient, and
    /// q again where the base takes both. A harmonic recurrence passes a rounding on S/φ times over
    /// (numerics N2d), φ = 1/2, as does the rounding of its factor 2 cos δ.
    Difference,
}

impl Growth {
    /// How far I_d and the base may be off.
    fn amount(self, unit: f64) -> f64 {
        let s = f64::from(STEPS);
        unit * match self {
            Growth::Pixel => 32.0,
            Growth::Step => 8.0 * (4.0 + s),
            Growth::Difference => 4.0 * (8.0 + s + s * s / 2.0),
        }
    }

    /// The same of a pixel in LSBs: the power makes n times as much of the base, which rows 5 and
    /// C8 raise to 4n.
    fn lsb(self, unit: f64, exponent: u32) -> f64 {
        let [_, diffuse, specular] = REFLECTANCES;
        FULL_SCALE * self.amount(unit) * (diffuse + specular * f64::from(exponent))
    }
}

/// What a loop is in exact arithmetic.
type Exact = fn(&Frame) -> Vec<f64>;

/// A loop, and what it is to be.
struct Row {
    name: &'static str,
    in_f64: fn(&Frame) -> Vec<f64>,
    exponent: u32,
    exact: Exact,
    growth: Growth,
}

/// The method with options in exact arithmetic, red at every pixel.
fn method(frame: &Frame, method: Method, options: &str) -> Vec<f64> {
    let table = format!("[{}]\n{options}", method.name()).parse().unwrap();
    let spec = CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(method)).unwrap();
    let span = MethodSpan::new(&spec, frame, &frame.spans[0]);
    (0..=STEPS).map(|i| span.pixel(i)[0]).collect()
}

/// Lyon's with g2 alone, as he has it.
fn lyon(frame: &Frame, options: &str) -> Vec<f64> {
    method(frame, Method::Lyon, &format!("newton_steps = 0\n{options}"))
}

/// A scheme in f64, with f64's power and sum.
fn in_f64<S: Scheme<f64>>(frame: &Frame) -> Vec<f64> {
    let mut scheme = S::new(&Line::new(frame, &frame.spans[0]), frame.lights[0].direction);
    (0..=STEPS).map(|_| shaded(scheme.pixel(), S::exponent(SHININESS))).collect()
}

fn shaded(Pair { diffuse, base }: Pair<f64>, exponent: u32) -> f64 {
    let [ambient, k_d, k_s] = REFLECTANCES;
    FULL_SCALE
        * (ambient
            + k_d * diffuse.clamp(0.0, 1.0)
            + k_s * base.clamp(0.0, 1.0).powi(exponent as i32))
}

/// B10 with K = 3, which no `--method` has: behind g2, (1 - x/3)^3.
fn cubed(frame: &Frame) -> Vec<f64> {
    let (span, light) = (&frame.spans[0], frame.lights[0].direction);
    let [start, end] = frame.end_normals(span);
    let pixel = |i: u32| {
        let n = start.lerp(end, span.parameter(i));
        let n = g2(n.length_squared()) * n;
        let x = f64::from(SHININESS) / 2.0 * reflection_minus_light(n, light).length_squared();
        // The highlight stands for the base of exponent 1.
        shaded(Pair { diffuse: n.dot(light), base: lobe(x, 3) }, 1)
    };
    (0..=STEPS).map(pixel).collect()
}

/// C7 with Phong's highlight, which no `--method` has.
fn chained(frame: &Frame) -> Vec<f64> {
    let (span, light) = (&frame.spans[0], frame.lights[0].direction);
    let [start, end] = frame.end_normals(span);
    let normals = (0..=STEPS).map(|i| start.lerp(end, span.parameter(i)));
    let pixel = |n: DVec3| Pair {
        diffuse: n.dot(light),
        base: 2.0 * n.dot(light) * n.dot(EYE) - light.dot(EYE),
    };
    wrap::chained(start, normals).map(|n| shaded(pixel(n), SHININESS)).collect()
}

macro_rules! rows {
    ($($name:literal, $scheme:ty, $exact:expr, $growth:ident;)*) => {
        fn rows() -> Vec<Row> {
            vec![$(Row {
                name: $name,
                in_f64: in_f64::<$scheme>,
                exponent: <$scheme as Scheme<f64>>::exponent(SHININESS),
                exact: $exact,
                growth: Growth::$growth,
            },)*]
        }
    };
}

rows! {
    "uniform", Uniform<f64>, |f| method(f, Method::Gouraud, "interpolation = \"uniform\""), Pixel;
    "gouraud", Gouraud<f64>, |f| method(f, Method::Gouraud, ""), Step;
    "phong", Phong<f64>, |f| method(f, Method::Phong, ""), Step;
    "phong-blinn", Blinn<f64>, |f| method(f, Method::Phong, "highlight = \"blinn\""), Step;
    "phong-torrance-sparrow", TorranceSparrow<f64>, |f| method(f, Method::Phong, "highlight = \"torrance-sparrow\""), Step;
    "phong-trowbridge-reitz", TrowbridgeReitz<f64>, |f| method(f, Method::Phong, "highlight = \"trowbridge-reitz\""), Step;
    "fast-phong", FastPhong<f64, 1>, |f| method(f, Method::Direct, "root = \"newton\"\nnewton_steps = 1"), Step;
    "fast-phong-2", FastPhong<f64, 2>, |f| method(f, Method::Direct, "root = \"newton\"\nnewton_steps = 2"), Step;
    "slerp", Slerp<f64>, |f| method(f, Method::Slerp, ""), Step;
    "slerp-edges", Slerp<f64>, |f| method(f, Method::Slerp, "edges = \"slerp\""), Step;
    "slerp-frame", FrameSlerp<f64>, |f| method(f, Method::Slerp, ""), Step;
    "chebyshev", Chebyshev<f64>, |f| method(f, Method::Slerp, ""), Difference;
    "lyon", LyonCross<f64>, |f| lyon(f, "difference = \"halfway-cross-normal\""), Step;
    "lyon-reflection", LyonReflection<f64, 4>, |f| lyon(f, "difference = \"reflection-minus-light\""), Step;
    "lyon-reflection-1", LyonReflection<f64, 2>, |f| lyon(f, "difference = \"reflection-minus-light\"\nsquarings = 1"), Step;
    "lyon-reflection-0", LyonReflection<f64, 1>, |f| lyon(f, "difference = \"reflection-minus-light\"\nsquarings = 0"), Step;
    "lyon-reflection-cubed", LyonReflection<f64, 3>, cubed, Step;
    "lyon-light-reflection", LyonLightReflection<f64>, |f| lyon(f, "difference = \"light-reflection\""), Step;
    "lyon-projection", LyonProjection<f64, Sum, 4>, |f| lyon(f, "difference = \"halfway-projection\""), Step;
    "lyon-unit-projection", LyonProjection<f64, Unit, 4>, |f| lyon(f, "difference = \"unit-halfway-projection\""), Step;
    "lyon-half-projection", LyonProjection<f64, Half, 4>,
        |f| lyon(f, "difference = \"unit-halfway-projection\"\nhalfway = \"half\""), Step;
    "lyon-half-g2-projection", LyonProjection<f64, HalfG2, 4>,
        |f| lyon(f, "difference = \"unit-halfway-projection\"\nhalfway = \"half-g2\""), Step;
    "lyon-half-g2-projection-1", LyonProjection<f64, HalfG2, 2>,
        |f| lyon(f, "difference = \"unit-halfway-projection\"\nhalfway = \"half-g2\"\nsquarings = 1"), Step;
    "lyon-unit-normal", LyonNormal<f64, Unit>, |f| lyon(f, "difference = \"unit-halfway-minus-normal\""), Step;
    "lyon-half-g2-normal", LyonNormal<f64, HalfG2>,
        |f| lyon(f, "difference = \"unit-halfway-minus-normal\"\nhalfway = \"half-g2\""), Step;
    "duff", DuffRoot<f64>, |f| method(f, Method::Duff, "specular = \"eq34\""), Difference;
    "duff-blinn", DuffBlinn<f64>, |f| method(f, Method::Duff, "specular = \"blinn\""), Difference;
    "duff-hybrid", DuffHybrid<f64>, |f| method(f, Method::Duff, "specular = \"quotient\""), Difference;
    "duff-quotient", DuffQuotient<f64>, |f| method(f, Method::Duff, "specular = \"eq33\""), Difference;
    "direct", Direct<f64>, |f| method(f, Method::Direct, ""), Step;
    "hybrid", Hybrid<f64>, |f| method(f, Method::Hybrid, ""), Difference;
    "reflection", ReflectionRoot<f64>, |f| method(f, Method::Reflection, "bisector = \"triangle\"\nspecular = \"eq34\""), Difference;
    "reflection-blinn", ReflectionBlinn<f64>,
        |f| method(f, Method::Reflection, "bisector = \"triangle\"\nspecular = \"blinn\""), Difference;
    "reflection-hybrid", ReflectionHybrid<f64>,
        |f| method(f, Method::Reflection, "bisector = \"triangle\"\nspecular = \"hybrid\""), Difference;
    "reflection-chained", Chained<f64>, chained, Step;
    "consistent", Consistent<f64, Rational>, |f| method(f, Method::Consistent, ""), Step;
    "consistent-trigonometric", Consistent<f64, Trigonometric>,
        |f| method(f, Method::Consistent, "curve = \"trigonometric\""), Step;
    "consistent-normal", ConsistentNormal<f64, Rational>,
        |f| method(f, Method::Consistent, "diffuse = \"consistent\"\nhighlight = \"blinn\""), Step;
}

/// 30 degrees, with the highlight on the span and vertices among faces as their triangle's.
fn span() -> Frame {
    let material = material(REFLECTANCES[0], REFLECTANCES[1], REFLECTANCES[2], SHININESS);
    let mut frame = frame([tilted(-15.0), tilted(15.0)], STEPS + 1, &[tilted(20.0)], material);
    let triangle = &mut frame.triangles[0];
    let face = triangle.facet.normal;
    for (cone, normal) in triangle.cones.iter_mut().zip(triangle.normals) {
        cone.cosine = normal.dot(face);
    }
    frame
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Intensities of vertices and polygons are worked out before the loop, wherever the lights are.
const OF_VERTICES: [(&str, &str); 2] =
    [("gouraud", "interpolation = \"linear\""), ("uniform", "interpolation = \"uniform\"")];

/// Loops of lights and an eye at places, which have a test of their own.
const PLACED: [(&str, Places); 2] =
    [("phong-places", Places::Exact), ("phong-wrapped-places", Places::Wrapped)];

#[test]
fn every_loop_is_compared() {
    let mut compared: Vec<&str> =
        rows().iter().map(|row| row.name).chain(PLACED.map(|(name, _)| name)).collect();
    let mut all = METHODS.map(|method| method.name);
    compared.sort();
    all.sort();
    assert_eq!(compared, all);
}

#[test]
fn loops_in_f64_are_their_methods() {
    let frame = span();
    let off = |row: &Row| {
        let (error, most) = (
            largest_difference(&(row.in_f64)(&frame), &(row.exact)(&frame)),
            row.growth.lsb(f64::EPSILON / 2.0, row.exponent),
        );
        (error > most).then(|| format!("{}: {error} LSB, and {most} at most", row.name))
    };
    let wrong: Vec<String> = rows().iter().filter_map(off).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn loops_in_f32_are_off_by_their_roundings() {
    let frame = span();
    let off = |row: &Row| {
        let mut out = [[0.0; 3]; STEPS as usize + 1];
        by_name(row.name).unwrap().shade(&frame, &frame.spans[0], &mut out);
        let shaded = out.map(|pixel| f64::from(pixel[0]));
        let (error, most) = (
            largest_difference(&shaded, &(row.exact)(&frame)),
            row.growth.lsb(f64::from(f32::EPSILON / 2.0), row.exponent),
        );
        println!("{}: {error} of {most}", row.name);
        (error > most).then(|| format!("{}: {error} LSB, and {most} at most", row.name))
    };
    let wrong: Vec<String> = rows().iter().filter_map(off).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// extremes rows 1, 2, 4, 7, 12, 13, 14 and 37: everything is a number between 0 and 255.
#[test]
fn nothing_is_undefined() {
    for (ends, length) in [
        ([DVec3::X, -DVec3::X], 3),
        ([DVec3::Z, -DVec3::Z], 5),
        ([DVec3::Z; 2], 1),
        ([-DVec3::Z; 2], 4),
    ] {
        let frame =
            frame(ends, length, &[DVec3::Z, -DVec3::Z, DVec3::X], material(0.1, 0.5, 0.5, 16));
        for method in METHODS {
            let mut out = vec![[0.0; 3]; length as usize];
            method.shade(&frame, &frame.spans[0], &mut out);
            assert!(
                out.iter().flatten().all(|c| (0.0..=255.0).contains(c)),
                "{}: {out:?}",
                method.name
            );
        }
    }
}

/// Lights and an eye at places: a lamp, a spot and a light at infinity over a tilted span, close by
/// and far away. f32 adds up S steps, each off by 2^-24 of the vector; n = 16 multiplies that.
#[test]
fn places_are_those_of_the_methods() {
    for distance in [1.5, 100.0] {
        let frame = lit_from_places(distance);
        let (span, needs) = (&frame.spans[0], Needs::of(&frame));
        for (name, places) in PLACED {
            let mut core = CoreSpec::for_scene(&needs, None, Some(Method::Phong)).unwrap();
            if let MethodSpec::Phong(phong) = &mut core.method {
                phong.places = places;
            }
            let mut out = [[0.0; 3]; 65];
            by_name(name).unwrap().shade(&frame, span, &mut out);
            for (i, pixel) in (0..).zip(out) {
                let error =
                    (f64::from(pixel[0]) - MethodSpan::new(&core, &frame, span).pixel(i)[0]).abs();
                assert!(error < 0.05, "{name} at {distance}, pixel {i}: {error}");
            }
        }
    }
}

/// Lights and eye as above, from the vertices and the polygon's middle: spans of two polygons, set up
/// one after another and all together, in memory of those before.
#[test]
fn vertices_and_polygons_see_places() {
    for distance in [1.5, 100.0] {
        let mut frame = lit_from_places(distance);
        let mut short = frame.spans[0].clone();
        (short.y, short.triangle, short.length) = (1, 1, 9);
        (short.start, short.end) = ([0.25, 0.25, 0.5], [0.5, 0.0, 0.5]);
        frame.spans.push(short);
        frame.triangles[0].facet.normal = tilted(7.0);
        frame.triangles[0].facet.middle = DVec3::new(0.1, 0.2, -0.3);
        frame.triangles.push(frame.triangles[0].clone());
        for (name, options) in OF_VERTICES {
            let table = format!("[gouraud]\n{options}").parse().unwrap();
            let core = CoreSpec::for_scene(&Needs::of(&frame), Some(&table), Some(Method::Gouraud))
                .unwrap();
            let mesh = Mesh::of(&frame);
            let mut software = (by_name(name).unwrap().of_mesh)(&mesh);
            software.set_up(&frame.spans[1..]);
            software.set_up(&frame.spans);
            for (number, span) in frame.spans.iter().enumerate().rev() {
                let mut out = vec![[0.0; 3]; span.length as usize];
                software.shade(number, &mut out);
                for (i, pixel) in (0..).zip(out) {
                    let error = (f64::from(pixel[0])
                        - MethodSpan::new(&core, &frame, span).pixel(i)[0])
                        .abs();
                    assert!(
                        error < 0.005,
                        "{name} at {distance}, span {number}, pixel {i}: {error}"
                    );
                }
            }
        }
    }
}

/// A pixel is its own middle: there, at a vertex, every loop of Phong's formula is exact, however
/// near lights and eye are.
#[test]
fn the_middle_of_a_pixel_sees_places() {
    let loops = [
        "phong",
        "fast-phong",
        "fast-phong-2",
        "slerp",
        "slerp-frame",
        "duff",
        "duff-hybrid",
        "duff-quotient",
        "direct",
        "hybrid",
        "reflection",
        "reflection-hybrid",
        "reflection-chained",
    ];
    let mut frame = lit_from_places(1.5);
    let span = &mut frame.spans[0];
    (span.length, span.end) = (1, span.start);
    let span = &frame.spans[0];
    let exact = phong(&frame, span, 0);
    for name in loops {
        let mut out = [[0.0; 3]];
        by_name(name).unwrap().shade(&frame, span, &mut out);
        let error = (f64::from(out[0][0]) - exact[0]).abs();
        assert!(error < 0.05, "{name}: {error}");
    }
}

/// Light that becomes weaker with distance, along a span as the method has it.
#[test]
fn loops_of_pixels_know_what_distance_leaves() {
    let mut frame = lit_from_places(1.5);
    let weaker = Attenuation { constant: 0.3, linear: 0.2, quadratic: 0.4 };
    frame.local_lights[1].attenuation = Some(weaker);
    let core = CoreSpec::for_scene(&Needs::of(&frame), None, Some(Method::Phong)).unwrap();
    let span = &frame.spans[0];
    let mut expected = [[0.0; 3]; 65];
    MethodSpan::new(&core, &frame, span).shade(&mut expected);
    let mut out = [[0.0; 3]; 65];
    by_name("phong-places").unwrap().shade(&frame, span, &mut out);
    let [expected, out] =
        [expected.map(|pixel| pixel[0]), out.map(|pixel: [f32; 3]| f64::from(pixel[0]))];
    let error = largest_difference(&expected, &out);
    assert!(error < 0.01, "{error}");
    let whole = lit_from_places(1.5);
    let brighter = phong(&whole, span, 32)[0] - phong(&frame, span, 32)[0];
    assert!(brighter > 5.0, "{brighter}");
}

/// Lights and an eye far away are the same from the middle of a span as at infinity.
#[test]
fn far_places_are_as_at_infinity() {
    let far = {
        let mut frame = lit_from_places(1e6);
        frame.eye = Some(1e6 * EYE);
        frame.local_lights.iter_mut().for_each(|light| light.spot = None);
        frame
    };
    let infinite = {
        let mut frame = far.clone();
        let light = |light: LocalLight| DirectionalLight {
            direction: light.position.normalize(),
            colour: light.colour,
        };
        frame.lights.extend(frame.local_lights.drain(..).map(light));
        frame.eye = None;
        frame
    };
    for method in METHODS.iter().filter(|method| method.serves(&infinite) && method.serves(&far)) {
        let shaded = [&far, &infinite].map(|frame| {
            let mut out = [[0.0; 3]; 65];
            method.shade(frame, &frame.spans[0], &mut out);
            out.map(|pixel| f64::from(pixel[0]))
        });
        let error = largest_difference(&shaded[0], &shaded[1]);
        assert!(error < 0.01, "{}: {error}", method.name);
    }
}

fn lit_from_places(distance: f64) -> Frame {
    let mut frame =
        frame([tilted(-15.0), tilted(15.0)], 65, &[tilted(20.0)], material(0.1, 0.3, 0.3, 16));
    frame.triangles[0].positions =
        [DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.2, 0.0), DVec3::Y];
    let lamp = |direction: DVec3, spot| LocalLight {
        position: distance * direction,
        spot,
        attenuation: None,
        colour: [0.5; 3],
    };
    let spot = Spot { axis: -tilted(-30.0), exponent: 20 };
    frame.local_lights = vec![lamp(tilted(40.0), None), lamp(tilted(-35.0), Some(spot))];
    frame.eye = Some(distance * tilted(10.0));
    frame
}
