//! Scenes that move.
use glam::DVec3;
use proptest::prelude::*;
use specula_scene::sequence::{Keys, Movement, Steps};
use specula_scene::{Frame, Needs, Sequence, load, parse};

const OBJECT: &str = "size = [64, 48]\n[[object]]\nprimitive = \"icosahedron\"\nlevel = 1\n";

/// The sequence of a scene file that has one.
fn sequence(text: &str) -> Sequence {
    let scene = parse("moving.toml", text.to_owned()).unwrap_or_else(|error| panic!("{error}"));
    scene.sequence.expect("the scene moves")
}

fn frame(sequence: &Sequence, number: u32) -> Frame {
    sequence.frame(number).unwrap_or_else(|error| panic!("{number}: {error}"))
}

/// The middle of all corners that are seen.
fn middle(frame: &Frame) -> DVec3 {
    let corners = frame.triangles.iter().flat_map(|triangle| triangle.positions);
    let count = 3 * frame.triangles.len();
    corners.sum::<DVec3>() / count as f64
}

#[test]
fn keys_are_met_and_between_them_is_the_way() {
    let keys = |steps| Keys::new(vec![(2.0, 10.0), (6.0, 20.0), (8.0, 0.0)], steps).unwrap();
    for (frame, linear, smooth) in [
        (0.0, 10.0, 10.0),
        (2.0, 10.0, 10.0),
        (3.0, 12.5, 11.5625),
        (4.0, 15.0, 15.0),
        (6.0, 20.0, 20.0),
        (7.0, 10.0, 10.0),
        (8.0, 0.0, 0.0),
        (99.0, 0.0, 0.0),
    ] {
        assert_eq!(keys(Steps::Linear).at(frame), linear, "{frame}");
        assert_eq!(keys(Steps::Smooth).at(frame), smooth, "{frame}");
    }
    assert_eq!(Keys::<f64>::new(vec![], Steps::Linear), None);
    assert_eq!(Keys::new(vec![(1.0, 0.0), (1.0, 1.0)], Steps::Linear), None);
}

#[test]
fn quarter_turns_are_exact() {
    let quarter = Movement::rotation(90.0, DVec3::Y, DVec3::new(1.0, 0.0, 0.0));
    assert_eq!(quarter.of_point(DVec3::new(2.0, 5.0, 0.0)), DVec3::new(1.0, 5.0, -1.0));
    assert_eq!(quarter.of_direction(DVec3::Z), DVec3::X);
}

proptest! {
    /// A rotation keeps lengths and its axis, and turns by its angle.
    #[test]
    fn rotations_are_rigid(
        degrees in -720.0..720.0_f64,
        axis in prop::array::uniform3(-1.0..1.0_f64).prop_filter("an axis", |a| DVec3::from(*a).length() > 0.1),
        point in prop::array::uniform3(-5.0..5.0_f64),
        centre in prop::array::uniform3(-5.0..5.0_f64),
    ) {
        let (axis, point, centre) = (DVec3::from(axis).normalize(), DVec3::from(point), DVec3::from(centre));
        let rotation = Movement::rotation(degrees, axis, centre);
        let moved = rotation.of_point(point);
        prop_assert!(((moved - centre).length() - (point - centre).length()).abs() < 1e-12);
        prop_assert!((rotation.of_point(centre + axis) - centre - axis).length() < 1e-12);
        let across = axis.any_orthonormal_vector();
        let turned = rotation.of_direction(across);
        let (cos, sin) = (across.dot(turned), axis.dot(across.cross(turned)));
        prop_assert!((cos - degrees.to_radians().cos()).abs() < 1e-12);
        prop_assert!((sin - degrees.to_radians().sin()).abs() < 1e-12);
    }
}

/// A turn without key frames ends where the frame after the last one would be, so that no frame
/// comes twice.
#[test]
fn a_full_turn_has_no_frame_twice() {
    let text = format!("{OBJECT}[sequence]\nframes = 8\n[[sequence.motion]]\nof = \"object 1\"\n");
    let turning = sequence(&format!("{text}turn = 360\n"));
    assert_eq!(turning.frames(), 8);
    let still = parse("still.toml", OBJECT.to_owned()).unwrap().frame;
    let first = frame(&turning, 0);
    // The camera of the sequence shows more than the one of the still scene, which sees one view.
    assert_eq!(first.triangles[0].positions.len(), still.triangles[0].positions.len());
    let frames: Vec<Frame> = (0..8).map(|number| frame(&turning, number)).collect();
    for (number, one) in frames.iter().enumerate() {
        assert!(frames[..number].iter().all(|other| other.triangles != one.triangles), "{number}");
    }
}

/// The world that turns, and a camera that goes around it the other way under a light that goes with
/// it, give the same picture.
#[test]
fn an_orbit_of_the_camera_is_a_turn_of_the_world() {
    let head = "size = [64, 48]\n[camera]\ntarget = [0, 0, 0]\nheight = 3\n[[light]]\nspace = \"view\"\ndirection = [0.2, 0.5, 1]\n[[object]]\nprimitive = \"teapot\"\nlevel = 2\nscale = 0.5\n[sequence]\nframes = 12\n";
    let motion = |of: &str, change: &str| {
        sequence(&format!(
            "{head}[[sequence.motion]]\nof = \"{of}\"\n{change}\naxis = [0.1, 1, 0.2]\n"
        ))
    };
    let (camera, world) = (motion("camera", "orbit = 360"), motion("object 1", "turn = -360"));
    for number in [0, 1, 5, 11] {
        let (one, other) = (frame(&camera, number), frame(&world, number));
        assert_eq!(one.shaded_pixels(), other.shaded_pixels(), "{number}");
        assert_eq!(one.lights, other.lights);
        assert!((middle(&one) - middle(&other)).length() < 1e-9, "{number}");
    }
}

#[test]
fn things_orbit_and_are_shifted() {
    let text = format!(
        "{OBJECT}[camera]\ndirection = [0, 0, 1]\ntarget = [0, 0, 0]\nheight = 8\n[[light]]\nkind = \"point\"\nposition = [3, 0, 0]\n\
         [sequence]\nframes = 5\n\
         [[sequence.motion]]\nof = \"objects\"\ntranslate = [[0, 0, 0], [2, 0, 0]]\nat = [0, 4]\n\
         [[sequence.motion]]\nof = \"light 1\"\norbit = [0, 90]\nat = [0, 4]\ncentre = [1, 0, 0]\naxis = [0, 0, 1]\n"
    );
    let moving = sequence(&text);
    let light = |number: u32| frame(&moving, number).local_lights[0].position;
    assert_eq!([light(0), light(4)], [DVec3::new(3.0, 0.0, 0.0), DVec3::new(1.0, 2.0, 0.0)]);
    let x = |number: u32| middle(&frame(&moving, number)).x;
    assert!((x(4) - x(0) - 2.0).abs() < 0.1 && (x(2) - x(0) - 1.0).abs() < 0.1);
}

/// A camera that frames the objects by itself shows all of them in every frame, in one scale.
#[test]
fn every_frame_is_within_the_picture() {
    for (name, size) in [("turntable", (64, 48)), ("sunrise", (48, 64))] {
        let sequence = load(name, Some(size)).unwrap().sequence.unwrap();
        let mut outlines = vec![];
        for number in 0..sequence.frames() {
            for triangle in frame(&sequence, number).triangles {
                outlines.extend(triangle.outline.unwrap());
            }
        }
        let within = |share: f64| {
            let [low, high] = [0.5 - share / 2.0, 0.5 + share / 2.0];
            let inside = |x: f64, side: u32| (low..=high).contains(&(x / f64::from(side)));
            outlines.iter().all(|p| inside(p.x, size.0) && inside(p.y, size.1))
        };
        assert!(within(0.95) && !within(0.85), "{name}");
    }
}

/// What a sequence needs is whatever any of its frames does.
#[test]
fn the_needs_of_a_sequence_are_those_of_its_frames() {
    let sequence = load("sunrise", Some((48, 36))).unwrap().sequence.unwrap();
    let needs = sequence.needs().unwrap();
    let mut lights = vec![];
    for number in 0..sequence.frames() {
        let own = Needs::of(&frame(&sequence, number));
        assert_eq!(needs.clone().and(own.clone()), needs, "{number}");
        assert_eq!(own.clone().and(needs.clone()), needs, "{number}");
        lights.push(own.ranges.normal_dot_light[0]);
    }
    // The light moves, so that no frame alone has the needs of all.
    assert!(lights.iter().all(|range| *range != needs.ranges.normal_dot_light[0]));
    assert_eq!(needs.longest_span, Needs::of(&frame(&sequence, 0)).longest_span);
}

/// What moves an object through the picture, from `first` to `last` by its height, in 8 frames.
fn passing(first: f64, last: f64) -> String {
    format!(
        "{OBJECT}[camera]\ntarget = [0, 0, 0]\nheight = 3\n[sequence]\nframes = 8\n\
         [[sequence.motion]]\nof = \"object 1\"\ntranslate = [[0, {first}, 0], [0, {last}, 0]]\nat = [0, 7]\n"
    )
}

/// Frames before an object comes and after it leaves are of the background, and ask for nothing.
#[test]
fn a_frame_without_anything_is_background() {
    let scene = parse("passing.toml", passing(-5.0, 5.0)).unwrap_or_else(|error| panic!("{error}"));
    let sequence = scene.sequence.as_ref().expect("the scene moves");
    let frames: Vec<Frame> = (0..8).map(|number| frame(sequence, number)).collect();
    let filled: Vec<&Frame> = frames.iter().filter(|frame| !frame.spans.is_empty()).collect();
    assert_eq!(filled.len(), 4);
    assert!(frames[0].spans.is_empty() && frames[7].spans.is_empty());
    assert_eq!(frames[0].lights, filled[0].lights);
    assert_eq!((scene.number, &scene.frame), (2, filled[0]));
    let needs = filled.into_iter().map(Needs::of).reduce(Needs::and);
    assert_eq!(Some(sequence.needs().expect("something is visible")), needs);
}

/// A sequence of nothing says why its first frame is empty.
#[test]
fn a_sequence_without_anything_is_an_error() {
    let error = parse("away.toml", passing(70.0, 80.0)).expect_err("nothing is in any frame");
    assert_eq!(error.to_string(), "scene `away.toml, frame 0`: nothing of the scene is visible");
}

/// A mesh of one triangle, so far to the right.
fn triangle(x: f64) -> String {
    format!("v {x} 0 0\nv {} 0 0\nv {x} 1 0\nf 1 2 3\n", x + 1.0)
}

fn folder(files: &[(&str, String)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn loaded(folder: &tempfile::TempDir) -> Result<specula_scene::LoadedScene, String> {
    let path = folder.path().to_str().unwrap();
    load(path, Some((64, 48))).map_err(|error| error.to_string().replace(path, "FOLDER"))
}

/// A folder's meshes are frames in the order of their names, in one picture.
#[test]
fn a_folder_of_meshes_is_a_sequence() {
    let folder = folder(&[
        ("b.obj", triangle(3.0)),
        ("a.obj", triangle(0.0)),
        ("c.toml", "[[object]]\nprimitive = \"icosahedron\"\n".to_owned()),
        ("notes.txt", "not a frame".to_owned()),
    ]);
    let sequence = loaded(&folder).unwrap().sequence.unwrap();
    assert_eq!(sequence.frames(), 3);
    let middles: Vec<DVec3> = (0..3).map(|number| middle(&frame(&sequence, number))).collect();
    let outline = |number: u32| frame(&sequence, number).triangles[0].outline.unwrap()[0];
    // Seen from the right, three units are as far in the picture as they are in view space.
    assert!(middles[1].x - middles[0].x > 2.0 && outline(1).x > outline(0).x + 10.0);
    assert!(sequence.needs().is_ok());
}

#[test]
fn frames_that_do_not_go_together_are_refused() {
    let object = "[[object]]\nprimitive = \"icosahedron\"\n";
    let lit = |lights: usize| "[[light]]\ndirection = [0, 0, 1]\n".repeat(lights) + object;
    let other = folder(&[("a.toml", lit(1)), ("b.toml", lit(2))]);
    let moving = folder(&[("a.toml", format!("{object}[sequence]\nframes = 2\n"))]);
    let broken = folder(&[("a.obj", triangle(0.0)), ("b.obj", "v 1 2\n".to_owned())]);
    let errors = [&folder(&[]), &other, &moving, &broken].map(|folder| loaded(folder).unwrap_err());
    insta::assert_snapshot!(errors.join("\n"), @r"
    folder of frames `FOLDER`: it has neither scene files nor meshes
    frame `FOLDER/b.toml` has another picture, other kinds of lights or another kind of eye than `FOLDER/a.toml`
    frame `FOLDER/a.toml` is no scene of objects that stand still
    mesh `FOLDER/b.obj`, line 1: three numbers are needed here, the line ends early
    ");
}

/// A perspective camera that chooses its distance does so once, too.
#[test]
fn a_perspective_camera_is_far_enough_in_every_frame() {
    let text = "size = [64, 48]\n[camera]\nkind = \"perspective\"\nfield_of_view = 50\n[[object]]\nprimitive = \"torus\"\nlevel = 4\ntranslate = [1, 0, 0]\n\
                [sequence]\nframes = 8\n[[sequence.motion]]\nof = \"camera\"\norbit = 360\n";
    let moving = sequence(text);
    let frames: Vec<Frame> = (0..8).map(|number| frame(&moving, number)).collect();
    let outlines =
        || frames.iter().flat_map(|f| &f.triangles).flat_map(|triangle| triangle.outline.unwrap());
    let inside = |low: f64, high: f64| {
        outlines().all(|p| {
            let [x, y] = [p.x / 64.0, p.y / 48.0];
            low <= x && x <= high && low <= y && y <= high
        })
    };
    assert!(inside(0.0, 1.0) && !inside(0.2, 0.8));
    // The eye goes around at one distance: the torus, beside the axis, comes nearer and goes away.
    let seen: Vec<u64> = frames.iter().map(Frame::shaded_pixels).collect();
    assert!(seen.iter().max() > seen.iter().min().map(|least| least + 20).as_ref(), "{seen:?}");
}
