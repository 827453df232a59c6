//! `specula run` with a scene that moves, and cores that are for more than one picture.
use std::fs::{self, File};
use std::io::BufReader;

use serde_json::Value;

use crate::program::Place;

/// A torus that turns under a light that rises.
const SCENE: &str = "
size = [64, 48]
[camera]
direction = [0, 0.5, 1]
target = [0, 0, 0]
height = 3
[[light]]
direction = [0, 0.2, 1]
[[object]]
primitive = \"torus\"
level = 6
[core]
method = \"lyon\"
[sequence]
frames = 5
[[sequence.motion]]
of = \"object 1\"
turn = 90
axis = [1, 0, 0]
[[sequence.motion]]
of = \"light 1\"
turn = [0, -40]
at = [0, 4]
axis = [1, 0, 0]
steps = \"smooth\"
";

fn with_scene() -> Place {
    let place = Place::new();
    place.write("rise.toml", SCENE);
    place
}

#[test]
fn every_frame_is_shaded_and_compared() {
    let place = with_scene();
    let summary = place.succeeds(&["run", "rise.toml"]);
    for line in [
        "sequence                  5 frames, 0 to 4: all agree",
        "frame_0000.png to frame_0004.png",
    ] {
        assert!(summary.contains(line), "{summary}");
    }
    let report = place.report("out/rise");
    let sequence = &report["sequence"];
    let frames = sequence["by_frame"].as_array().expect("it lists frames");
    assert_eq!(
        (frames.len(), &sequence["mismatches"], &sequence["agreeing"]),
        (5, &0.into(), &5.into())
    );
    let number = |frame: &Value| frame["error"]["total"]["max_lsb"].as_f64().unwrap();
    let worst = frames.iter().map(number).fold(0.0, f64::max);
    assert_eq!(report["error"]["total"]["max_lsb"].as_f64(), Some(worst));
    let table = fs::read_to_string(place.path("out/rise/frames.csv")).unwrap();
    assert_eq!(table.lines().count(), 6);
    // The report is about the frame that it shows.
    let shown = sequence["shown"].as_u64().unwrap();
    let picture = |name: &str| image::open(place.path("out/rise").join(name)).unwrap().into_rgb8();
    assert_eq!(picture("simulated.png"), picture(&format!("frame_{shown:04}.png")));
}

/// Something that passes through the picture: the frames before it comes and after it leaves are of
/// the background, are compared, and are in the animation.
#[test]
fn frames_of_the_background_are_frames() {
    let place = Place::new();
    let [head, _] = SCENE.split_once("[sequence]").map(|(head, rest)| [head, rest]).unwrap();
    let passes = "[sequence]\nframes = 5\n[[sequence.motion]]\nof = \"object 1\"\n\
                  translate = [[-6, 0, 0], [6, 0, 0]]\nat = [0, 4]\n";
    place.write("passes.toml", format!("{head}{passes}"));
    let summary = place.succeeds(&["run", "passes.toml"]);
    assert!(summary.contains("5 frames, 0 to 4: all agree"), "{summary}");
    let report = place.report("out/passes");
    let frames = report["sequence"]["by_frame"].as_array().expect("it lists frames");
    let pixels: Vec<u64> = frames.iter().map(|frame| frame["pixels"].as_u64().unwrap()).collect();
    assert_eq!((pixels[0], pixels[4]), (0, 0), "{pixels:?}");
    assert!(pixels[2] > 0, "{pixels:?}");
    let picture = image::open(place.path("out/passes/frame_0000.png")).unwrap().into_rgb8();
    let first = *picture.get_pixel(0, 0);
    assert!(picture.pixels().all(|pixel| *pixel == first));
    let explored =
        place.specula(&["explore", "passes.toml", "--max-error", "6lsb", "--methods", "gouraud"]);
    let told = "frames: frame 1 alone is looked at, the first of 5 in which something is visible\n";
    assert!(explored.stderr.starts_with(told), "{explored:?}");
    place.succeeds(&["run", "passes.toml", "--core", "out/passes", "-o", "again"]);
    place.succeeds(&["needs", "passes.toml"]);
}

/// The animation has every frame's pixels, whatever changes from one to the next.
#[test]
fn the_animation_is_the_frames() {
    let place = with_scene();
    place.succeeds(&["run", "rise.toml"]);
    let file = BufReader::new(File::open(place.path("out/rise/animation.png")).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    assert_eq!(reader.info().animation_control().map(|control| control.num_frames), Some(5));
    let mut canvas = vec![0; 64 * 48 * 3];
    let mut part = vec![0; reader.output_buffer_size().unwrap()];
    for number in 0..5 {
        reader.next_frame(&mut part).unwrap();
        let control = *reader.info().frame_control().unwrap();
        let width = control.width as usize * 3;
        for row in 0..control.height as usize {
            let to = ((control.y_offset as usize + row) * 64 + control.x_offset as usize) * 3;
            canvas[to..to + width].copy_from_slice(&part[row * width..(row + 1) * width]);
        }
        let picture = image::open(place.path(&format!("out/rise/frame_{number:04}.png"))).unwrap();
        assert!(picture.into_rgb8().into_raw() == canvas, "{number}");
    }
}

/// A core for one frame does not shade the others, and says which; one for all does.
#[test]
fn a_core_for_all_frames_takes_the_sequence_again() {
    let place = with_scene();
    place.succeeds(&["run", "rise.toml", "-o", "all"]);
    place.succeeds(&["run", "rise.toml", "--core", "all", "-o", "again"]);
    assert_eq!(place.report("again")["sequence"], place.report("all")["sequence"]);
    let still = SCENE.split("[sequence]").next().unwrap();
    place.write("still.toml", still);
    place.succeeds(&["run", "still.toml", "-o", "one"]);
    let refused = place.specula(&["run", "rise.toml", "--core", "one"]);
    assert_eq!(refused.status, Some(2));
    assert!(refused.stderr.contains("rise, frame 1"), "{}", refused.stderr);
}

#[test]
fn errors_that_are_measured_are_of_one_picture() {
    let place = with_scene();
    let refused = place.specula(&["run", "rise.toml", "--max-error", "2lsb"]);
    assert_eq!(refused.status, Some(2));
    insta::assert_snapshot!(refused.stderr);
}

/// Frames are the same on every machine and in every run, whichever is ready first.
#[test]
fn a_sequence_gives_the_same_files_every_time() {
    let place = with_scene();
    for folder in ["one", "other"] {
        place.succeeds(&["run", "rise.toml", "-o", folder, "--name", "rise"]);
    }
    for name in place.names("one").iter().filter(|name| !name.starts_with("report.")) {
        let read = |folder: &str| fs::read(place.path(folder).join(name)).unwrap();
        assert!(read("one") == read("other"), "{name}");
    }
}

/// What is kept is told, and takes other scenes within it.
#[test]
fn what_is_kept_may_change_without_a_new_core() {
    let core = "keep = [\"lights\", \"materials\"]\n[core.kept]\nshininess = [4, 64]\n";
    let still = SCENE.split("[sequence]").next().unwrap();
    let place = Place::new();
    place.write("kept.toml", format!("{still}{core}"));
    place.succeeds(&["run", "kept.toml", "-o", "kept"]);
    let report = fs::read_to_string(place.path("kept/report.md")).unwrap();
    assert!(report.contains("one directional light anywhere; n up to 64, any colours"), "{report}");
    let other = still.replace("[0, 0.2, 1]", "[-0.8, 0.5, 0.3]");
    place.write("other.toml", format!("{other}[object.material]\nshininess = 9\ndiffuse = 0.3\n"));
    place.succeeds(&["run", "other.toml", "--core", "kept"]);
    place.write("sharp.toml", format!("{other}[object.material]\nshininess = 65\n"));
    let refused = place.specula(&["run", "sharp.toml", "--core", "kept"]);
    assert_eq!(refused.status, Some(2));
    assert!(refused.stderr.contains("it takes exponents up to 64"), "{}", refused.stderr);
}

/// `auto` chooses a core that keeps the goal, says why, and names itself in the command.
#[test]
fn auto_chooses_a_method() {
    let place = Place::new();
    let ended = place.specula(&["run", "icosahedron", "--size", "96x72", "--method", "auto"]);
    assert_eq!(ended.status, Some(0), "{}", ended.stderr);
    assert!(
        ended.stderr.starts_with("method: ") && ended.stderr.contains("within 2 LSB"),
        "{}",
        ended.stderr
    );
    let report = place.report("out/icosahedron");
    assert!(report["error"]["total"]["max_lsb"].as_f64() < Some(2.5));
    let command = report["command"].as_str().unwrap();
    assert!(command.ends_with("--size 96x72 --method auto"), "{command}");
}

/// What looks at one frame says so.
#[test]
fn one_frame_is_explored_and_that_is_told() {
    let place = with_scene();
    let ended =
        place.specula(&["explore", "rise.toml", "--max-error", "6lsb", "--methods", "gouraud"]);
    assert!(ended.stderr.starts_with("frames: the first of 5 alone is looked at\n"), "{ended:?}");
}
