//! The papers' loops in f32 on this machine: their run time and their error.
use std::hint::black_box;

use rayon::prelude::*;
use serde::Serialize;
use specula_golden::exact::PhongSpan;
use specula_golden::loops::software::{METHODS, Mesh, Method};
use specula_scene::Frame;

use super::thread_clock;
use specula_testbench::ErrorFigures;
use specula_testbench::statistics::{Sums, median};

/// The measurements of a loop.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Software {
    /// Its name.
    pub name: &'static str,
    /// Nanoseconds for each pixel, without set-up: the median of the rounds.
    pub pixel_ns: f64,
    /// Nanoseconds to set a span up, including its share of what is computed once for the frame:
    /// the median of the rounds.
    pub set_up_ns: f64,
    /// Nanoseconds for both, for each pixel of the frame: the median of the rounds.
    pub total_ns: f64,
    /// `total_ns` as a multiple of naive Phong shading's: the median of the ratios in each round,
    /// in which all loops run one after another.
    pub ratio_to_phong: f64,
    /// Errors against exact shading, before rounding to 8 bits.
    pub error: ErrorFigures,
}

/// The loop with which others are compared: the lecture's naive Phong shading, with directions to
/// lights and an eye at places computed at each pixel.
fn naive(frame: &Frame) -> &'static str {
    if frame.directions_are_constant() { "phong" } else { "phong-places" }
}

/// The extent of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimingExtent {
    /// Number of rounds, at least 1, in each of which every loop shades the frame.
    pub rounds: usize,
    /// Least number of pixels that a loop shades in a round; small frames are shaded several times.
    pub pixels: u64,
}

impl Default for TimingExtent {
    fn default() -> TimingExtent {
        TimingExtent { rounds: 11, pixels: 100_000 }
    }
}

/// Number of spans that are set up before they are shaded: few enough to stay in the cache, enough
/// for the clock, which takes some 300 ns to read.
const BLOCK: usize = 512;

/// Measures every loop on one thread, in time during which the thread has a processor. Rounds are
/// interleaved, so that a temporary slowdown of the machine affects all loops. `done` is called
/// after each round.
///
/// Loops for lights and an eye at places are measured only where there are some.
pub fn measure(frame: &Frame, extent: TimingExtent, done: &mut dyn FnMut()) -> Vec<Software> {
    let methods: Vec<Method> = METHODS.into_iter().filter(|method| method.serves(frame)).collect();
    measure_loops(&methods, frame, extent, done)
}

/// Measures these loops as [`measure`] does; naive Phong shading must be one of them.
pub fn measure_loops(
    methods: &[Method],
    frame: &Frame,
    extent: TimingExtent,
    done: &mut dyn FnMut(),
) -> Vec<Software> {
    let mesh = Mesh::of(frame);
    let times = (extent.pixels / frame.shaded_pixels().max(1)).max(1);
    let mut turns = vec![Vec::new(); methods.len()];
    // The first round is a warm-up.
    for round in 0..=extent.rounds.max(1) {
        for (method, turns) in methods.iter().zip(&mut turns) {
            let turn = FrameTime::take(method, &mesh, times);
            turns.extend((round > 0).then_some(turn));
        }
        done();
    }
    let naive = methods.iter().position(|method| method.name == naive(frame));
    let naive = naive.map(|number| turns[number].clone()).unwrap_or_default();
    let errors: Vec<ErrorFigures> =
        methods.par_iter().map(|method| errors(method, &mesh)).collect();
    let row = |((method, turns), error): ((&Method, &Vec<FrameTime>), ErrorFigures)| {
        row(method.name, (turns, &naive), frame, error)
    };
    methods.iter().zip(&turns).zip(errors).map(row).collect()
}

fn row(
    name: &'static str,
    (turns, naive): (&[FrameTime], &[FrameTime]),
    frame: &Frame,
    error: ErrorFigures,
) -> Software {
    let (pixels, spans) = (frame.shaded_pixels().max(1) as f64, frame.spans.len().max(1) as f64);
    let of = |part: fn(&FrameTime) -> f64| median(&turns.iter().map(part).collect::<Vec<f64>>());
    let ratios: Vec<f64> =
        turns.iter().zip(naive).map(|(turn, naive)| turn.total() / naive.total()).collect();
    Software {
        name,
        pixel_ns: of(|turn| turn.shading) * 1e9 / pixels,
        set_up_ns: of(|turn| turn.set_up) * 1e9 / spans,
        total_ns: of(FrameTime::total) * 1e9 / pixels,
        ratio_to_phong: median(&ratios),
        error,
    }
}

/// Seconds for shading the frame once.
#[derive(Clone, Copy, Debug)]
struct FrameTime {
    set_up: f64,
    shading: f64,
}

impl FrameTime {
    /// Shades the frame `times` times.
    fn take(method: &Method, mesh: &Mesh, times: u64) -> FrameTime {
        let frame = mesh.frame;
        let longest = frame.spans.iter().map(|span| span.length).max().unwrap_or(0);
        let mut out = vec![[0.0f32; 3]; longest as usize];
        let mut turn = FrameTime { set_up: 0.0, shading: 0.0 };
        for _ in 0..times {
            let begin = thread_clock::now();
            let mut software = (method.of_mesh)(mesh);
            turn.set_up += (thread_clock::now() - begin).as_secs_f64();
            for block in frame.spans.chunks(BLOCK) {
                let begin = thread_clock::now();
                software.set_up(block);
                let middle = thread_clock::now();
                for (number, span) in block.iter().enumerate() {
                    let out = &mut out[..span.length as usize];
                    software.shade(number, out);
                    black_box(out);
                }
                turn.shading += (thread_clock::now() - middle).as_secs_f64();
                turn.set_up += (middle - begin).as_secs_f64();
            }
        }
        FrameTime { set_up: turn.set_up / times as f64, shading: turn.shading / times as f64 }
    }

    fn total(&self) -> f64 {
        self.set_up + self.shading
    }
}

fn errors(method: &Method, mesh: &Mesh) -> ErrorFigures {
    let mut software = (method.of_mesh)(mesh);
    let mut sums = Sums::default();
    for span in &mesh.frame.spans {
        let (phong, mut of_span) = (PhongSpan::new(mesh.frame, span), Sums::default());
        let mut out = vec![[0.0; 3]; span.length as usize];
        software.set_up(std::slice::from_ref(span));
        software.shade(0, &mut out);
        for (pixel, given) in (0..).zip(out) {
            let exact = phong.pixel(pixel);
            (0..3).for_each(|c| of_span.add(f64::from(given[c]) - exact[c]));
        }
        sums.merge(&of_span);
    }
    sums.figures()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHORT: TimingExtent = TimingExtent { rounds: 3, pixels: 2000 };

    #[test]
    fn every_loop_is_timed_and_naive_phong_is_the_yardstick() {
        let scene = specula_scene::load("icosahedron", Some((32, 24))).unwrap();
        let mut rounds = 0;
        let rows = measure(&scene.frame, SHORT, &mut || rounds += 1);
        assert_eq!((rows.len(), rounds), (METHODS.len() - 2, 4));
        assert!(
            rows.iter().all(|row| row.pixel_ns > 0.0
                && row.set_up_ns > 0.0
                && row.total_ns > row.pixel_ns),
            "{rows:?}"
        );
        let of = |name: &str| rows.iter().find(|row| row.name == name).unwrap();
        assert_eq!(of("phong").ratio_to_phong, 1.0);
        assert!(of("phong").error.max_lsb < 0.05 && of("gouraud").error.max_lsb > 1.0, "{rows:?}");
    }

    /// The lecture teaches Gouraud shading because intensities are computed only at vertices.
    /// Triangles are large here, since the set-up of spans of a pixel or two would cost more.
    #[test]
    fn gouraud_shading_is_faster_than_naive_phong_shading() {
        let scene = specula_scene::load("icosahedron", Some((160, 120))).unwrap();
        let rows = measure(&scene.frame, TimingExtent { rounds: 5, pixels: 1 }, &mut || ());
        let of = |name: &str| rows.iter().find(|row| row.name == name).unwrap();
        for name in ["uniform", "gouraud"] {
            assert!(of(name).ratio_to_phong < 0.8, "{:?} {:?}", of(name), of("phong"));
        }
    }

    /// Lights and an eye at places are seen from each pixel by naive Phong shading alone.
    #[test]
    fn lights_at_places_have_loops_of_their_own() {
        let scene = specula_scene::load("lamps", Some((32, 24))).unwrap();
        let rows = measure(&scene.frame, SHORT, &mut || ());
        let served = METHODS.iter().filter(|method| method.serves(&scene.frame)).count();
        assert!(rows.len() == served && served > 30, "{rows:?}");
        let of = |name: &str| rows.iter().find(|row| row.name == name).unwrap();
        assert!(rows.iter().all(|row| row.pixel_ns > 0.0 && row.set_up_ns > 0.0), "{rows:?}");
        assert_eq!(of("phong-places").ratio_to_phong, 1.0);
        assert!(of("phong-places").error.max_lsb < 0.05, "{rows:?}");
        assert!(of("gouraud").error.max_lsb > 1.0 && of("phong").error.max_lsb > 0.05, "{rows:?}");
    }
}
