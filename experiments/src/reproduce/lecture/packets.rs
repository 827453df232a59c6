//! What becomes of packets whose normals are stepped along edges (decision 0049).
use glam::DVec3;
use specula_golden::fixed::Model;
use specula_golden::loops::Linear;
use specula_scene::frame::Triangle;
use specula_scene::{Frame, Needs, Span};
use specula_spec::{CoreSpec, Method, SpanPacket};

use super::super::claim::{Claim, Ruling, exact};
use super::super::stepped::{along_edges, small};

/// How much of a picture is not the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Changed {
    /// Spans whose normals at the ends differ in f64.
    spans: u32,
    packets: u32,
    pixels: u32,
}

/// What it changes in the teapot's picture to step normals along edges and then along each scan
/// line to its last pixel, in place of weights; `None` if it has no core.
fn changed(method: Method) -> Option<Changed> {
    let frame = small("teapot")?;
    let spec = CoreSpec::for_scene(&Needs::of(&frame), None, Some(method)).ok()?;
    let model = Model::new(&spec);
    let mut changed = Changed::default();
    let mut shaded = |packet: &SpanPacket| {
        let mut codes = vec![];
        model.shade(packet, &mut codes).ok().map(|()| codes)
    };
    let mut alone = Frame { triangles: vec![], spans: vec![], ..frame.clone() };
    along_edges(
        &frame,
        |normal| normal.to_array(),
        |span, along| {
            let normals = ends(span, along);
            let by_weights = [span.start, span.end].map(|at| frame.normal_at(span, at));
            changed.spans += u32::from(normals != by_weights);
            let (triangle, stepped) = between(&frame, span, normals);
            alone.triangles = vec![triangle];
            let packets = [spec.packet(&frame, span), spec.packet(&alone, &stepped)];
            if packets[0] != packets[1] {
                changed.packets += 1;
                let [before, after] = packets.each_ref().map(&mut shaded);
                let pairs = before.iter().flatten().zip(after.iter().flatten());
                changed.pixels += pairs.filter(|(before, after)| before != after).count() as u32;
            }
        },
    );
    Some(changed)
}

/// The normals at a span's first and last pixel, by an addition a pixel.
fn ends(span: &Span, mut along: [Linear<f64>; 3]) -> [DVec3; 2] {
    let mut next = || DVec3::from_array(along.each_mut().map(Linear::pixel));
    let first = next();
    [first, (0..span.steps()).fold(first, |_, _| next())]
}

/// The span with these normals at its ends, and the triangle that it then is of.
fn between(frame: &Frame, span: &Span, [first, last]: [DVec3; 2]) -> (Triangle, Span) {
    let of = &frame.triangles[span.triangle];
    let triangle = Triangle { normals: [first, last, DVec3::ZERO], ..of.clone() };
    let ends = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    (triangle, Span { triangle: 0, start: ends.0, end: ends.1, ..span.clone() })
}

fn number(method: Method, of: fn(Changed) -> u32) -> f64 {
    changed(method).map_or(f64::NAN, |changed| of(changed).into())
}

const fn packets(quantity: &'static str, measure: fn() -> f64) -> Claim {
    let what = "stepped along edges, normals make the packets that weights make (our question, not a claim)";
    exact(what, quantity, (0.0, 0.0), measure, |packets| {
        Ruling::of(packets == 0.0, "some values lie in the middle between two of their format")
    })
}

const fn pixels(quantity: &'static str, measure: fn() -> f64) -> Claim {
    let what = "and the pixels that weights make";
    exact(what, quantity, (0.0, 0.0), measure, |pixels| Ruling::of(pixels == 0.0, "some differ"))
}

/// Claims about set-up along edges, on the teapot at 320 x 240 in recommended formats.
pub(super) const CLAIMS: [Claim; 5] = [
    exact(
        "additions along edges round otherwise than weights do (our question, not a claim)",
        "spans of the teapot whose normals differ in f64",
        (7646.0, 0.0),
        || number(Method::Phong, |changed| changed.spans),
        |spans| Ruling::of(spans > 0.0, "they are the same to the last bit"),
    ),
    packets("packets of the teapot that differ, phong", || {
        number(Method::Phong, |changed| changed.packets)
    }),
    packets("packets that differ, direct", || number(Method::Direct, |of| of.packets)),
    packets("packets that differ, duff", || number(Method::Duff, |of| of.packets)),
    pixels("pixels of the teapot that differ, phong", || {
        number(Method::Phong, |changed| changed.pixels)
    }),
];
