//! Shading before a perspective camera: exact shading against a ray caster's own normals, and what
//! interpolation along spans makes of a picture.
use std::path::Path;

use glam::DVec3;
use specula_fixtures::ray_caster::{CastCamera, CastTriangle, Hit, RayCaster};
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_golden::loops::software::{Mesh as LoopMesh, by_name};
use specula_scene::mesh::Mesh;
use specula_scene::{Frame, Needs, parse};
use specula_spec::{CoreSpec, Method};

const MESHES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures/meshes");

const SIZE: (u32, u32) = (96, 72);

fn camera(eye: [f64; 3], target: [f64; 3]) -> CastCamera {
    let [eye, target] = [eye, target].map(DVec3::from_array);
    CastCamera { eye, target, field_of_view: 50.0, near: 0.01, size: SIZE }
}

/// A mesh before a camera; `more` ends the camera's table.
fn frame(mesh: &str, camera: &CastCamera, more: &str) -> Frame {
    let CastCamera { eye, target, field_of_view, near, size } = camera;
    let text = format!(
        "size = [{}, {}]\nambient = {AMBIENT}\n[camera]\nkind = \"perspective\"\neye = {:?}\ntarget = {:?}\nfield_of_view = {field_of_view:?}\nnear = {near:?}\n{more}\n\
         [[light]]\ndirection = {DIRECTION:?}\ncolour = 0.5\n[[light]]\nkind = \"point\"\nposition = {PLACE:?}\ncolour = 0.5\n\
         [[object]]\nmesh = '{MESHES}/{mesh}'\n[object.material]\nambient = 0.7\ndiffuse = 0.6\nspecular = 0.5\nshininess = {SHININESS}\n",
        size.0,
        size.1,
        eye.to_array(),
        target.to_array(),
    );
    parse("a.toml", text).expect("the scene is right").frame
}

const AMBIENT: f64 = 0.2;
const DIRECTION: [f64; 3] = [-0.3, 1.0, 0.5];
const PLACE: [f64; 3] = [3.0, 6.0, 2.0];
const SHININESS: i32 = 12;

fn triangles(mesh: &str) -> Vec<CastTriangle> {
    let (mesh, _) = Mesh::read(Path::new(&format!("{MESHES}/{mesh}"))).expect("the mesh is right");
    let triangle = |(corners, normals): (&[u32; 3], &[DVec3; 3])| CastTriangle {
        places: corners.map(|k| mesh.positions[k as usize]),
        normals: *normals,
    };
    mesh.triangles.iter().zip(&mesh.normals).map(triangle).collect()
}

/// Phong's formula at a point that a ray meets, in LSB, in world coordinates.
fn shaded(hit: &Hit, view: DVec3) -> f64 {
    let lights = [
        DVec3::from_array(DIRECTION).normalize(),
        (DVec3::from_array(PLACE) - hit.place).normalize(),
    ];
    let reflected = |light: DVec3| {
        let mirrored = 2.0 * hit.normal.dot(light) * hit.normal - light;
        0.6 * hit.normal.dot(light).max(0.0) + 0.5 * mirrored.dot(view).max(0.0).powi(SHININESS)
    };
    let sum = AMBIENT * 0.7 + 0.5 * lights.map(reflected).iter().sum::<f64>();
    255.0 * sum.clamp(0.0, 1.0)
}

/// Exact shading is Phong's formula with the normal and the place that a ray meets, for an eye at
/// infinity and at its place, and for either interpolation.
#[test]
fn exact_shading_is_that_of_what_rays_meet() {
    let views = [
        ("hills.obj", camera([1.0, 5.0, 2.0], [-6.0, 1.0, -20.0])),
        ("building.obj", camera([8.0, 1.7, 10.0], [0.0, 3.0, 0.0])),
        ("plane.obj", camera([1.0, 1.5, 2.0], [0.0, 0.0, -8.0])),
    ];
    for (mesh, camera) in views {
        let caster = RayCaster::new(camera, triangles(mesh));
        let far = (camera.eye - camera.target).normalize();
        for (viewer, interpolation) in
            [("infinite", "screen"), ("local", "screen"), ("local", "perspective")]
        {
            let more = format!("viewer = {viewer:?}\ninterpolation = {interpolation:?}");
            let frame = frame(mesh, &camera, &more);
            let (mut largest, mut pixels): (f64, u32) = (0.0, 0);
            for span in frame.spans.iter().step_by(3) {
                let phong = PhongSpan::new(&frame, span);
                for i in (0..span.length).step_by(2) {
                    let [x, y] = [span.x + i, span.y].map(|n| f64::from(n) + 0.5);
                    // At an edge, something else may be met.
                    let seen = frame.position_at(span, frame.seen_weights(span, i));
                    let is_seen = |hit: &Hit| {
                        (caster.depth(seen) - hit.depth).abs()
                            < 0.01 * caster.pixel() * hit.depth / hit.cosine
                    };
                    let Some(hit) = caster.hit(x, y).filter(is_seen) else { continue };
                    let view =
                        if viewer == "local" { (camera.eye - hit.place).normalize() } else { far };
                    largest = largest.max((phong.pixel(i)[1] - shaded(&hit, view)).abs());
                    pixels += 1;
                }
            }
            println!("{mesh}, {viewer}, {interpolation}: {largest:.4} LSB at {pixels} pixels");
            assert!(pixels > 200 && largest < 0.25, "{mesh} {viewer}: {largest} at {pixels}");
        }
    }
}

/// Root mean square and largest error of a method in exact arithmetic against exact shading, in LSB.
fn method_error(frame: &Frame, method: Method) -> [f64; 2] {
    let spec = CoreSpec::for_scene(&Needs::of(frame), None, Some(method)).expect("it serves");
    let (mut squares, mut largest): (f64, f64) = (0.0, 0.0);
    for span in &frame.spans {
        let (method, exact) = (MethodSpan::new(&spec, frame, span), PhongSpan::new(frame, span));
        for i in 0..span.length {
            let error = method.pixel(i)[1] - exact.pixel(i)[1];
            squares += error * error;
            largest = largest.max(error.abs());
        }
    }
    [(squares / frame.shaded_pixels() as f64).sqrt(), largest]
}

/// A plane at a low angle: weights that are linear on the screen put its far part where its near part
/// is. Perspective-correct ends leave what is between them, which is next to nothing where a row is at one
/// distance (corners are moved by up to 1/512 pixel), and little where the camera is tilted.
#[test]
fn a_plane_at_a_low_angle_shows_the_interpolation() {
    let camera = camera([0.0, 1.5, 3.5], [0.0, 0.0, -8.0]);
    for (up, times) in [("[0, 1, 0]", 1000.0), ("[0.2, 1, 0]", 3.0)] {
        let [screen, perspective] = ["screen", "perspective"].map(|interpolation| {
            let more = format!("up = {up}\ninterpolation = {interpolation:?}");
            method_error(&frame("plane.obj", &camera, &more), Method::Phong)
        });
        println!(
            "up {up}: screen {screen:.3?} LSB, perspective {perspective:.3?} LSB (rms, largest)"
        );
        assert!(screen[0] > 10.0 && screen[0] > times * perspective[0] && perspective[0] > 0.0);
    }
}

/// The loops in software do what the methods do, also where triangles are cut and where weights are not
/// linear over a triangle.
#[test]
fn loops_shade_in_perspective() {
    let camera = camera([1.0, 2.0, 3.5], [0.0, 0.0, -8.0]);
    let loops = [
        ("gouraud", Method::Gouraud, ""),
        ("phong", Method::Phong, "places = \"exact\""),
        ("hybrid", Method::Hybrid, ""),
        ("slerp-edges", Method::Slerp, "edges = \"slerp\""),
    ];
    for mesh in ["plane.obj", "hills.obj"] {
        for interpolation in ["screen", "perspective"] {
            let mut frame = frame(mesh, &camera, &format!("interpolation = {interpolation:?}"));
            frame.local_lights.clear();
            for (name, method, options) in loops {
                let table = format!("[{}]\n{options}", method.name()).parse().expect("it is right");
                let spec = CoreSpec::for_scene(&Needs::of(&frame), Some(&table), Some(method))
                    .expect("it serves");
                let mesh_of_loop = LoopMesh::of(&frame);
                let mut software = (by_name(name).expect("there is one").of_mesh)(&mesh_of_loop);
                software.set_up(&frame.spans);
                let mut largest: f64 = 0.0;
                for (index, span) in frame.spans.iter().enumerate() {
                    let mut pixels = vec![[0.0; 3]; span.length as usize];
                    software.shade(index, &mut pixels);
                    let exact = MethodSpan::new(&spec, &frame, span);
                    let off = |(i, pixel): (usize, &[f32; 3])| {
                        (f64::from(pixel[1]) - exact.pixel(i as u32)[1]).abs()
                    };
                    largest = pixels.iter().enumerate().map(off).fold(largest, f64::max);
                }
                println!("{mesh}, {interpolation}, {name}: {largest:.4} LSB");
                assert!(largest < 0.1, "{mesh}, {interpolation}, {name}: {largest}");
            }
        }
    }
}
