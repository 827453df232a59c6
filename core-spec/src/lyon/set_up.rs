//! Set-up of a span for `lyon`.
use glam::DVec3;
use specula_scene::frame::{DirectionalLight, EYE, Frame, Span};

use super::{Halfway, LyonLight, LyonSpan, LyonSpec, NormalWrap, Normals, ShapeDatapath};
use crate::increments::Increments;
use crate::method_set_up::MethodSetUp;
use crate::ways::Ways;

/// Sets up the spans of a frame.
pub(super) struct LyonSetUp<'a> {
    lyon: &'a LyonSpec,
    frame: &'a Frame,
    lights: Vec<Vectors>,
}

/// What is the same of a light in every span.
struct Vectors {
    direction: [i64; 3],
    halfway: Option<[i64; 3]>,
    has_highlight: bool,
}

impl<'a> LyonSetUp<'a> {
    pub fn new(lyon: &'a LyonSpec, frame: &'a Frame) -> LyonSetUp<'a> {
        LyonSetUp {
            lyon,
            frame,
            lights: frame.lights.iter().map(|light| Vectors::new(lyon, light)).collect(),
        }
    }
}

impl Vectors {
    fn new(lyon: &LyonSpec, light: &DirectionalLight) -> Vectors {
        let (f, l) = (&lyon.formats, light.direction);
        let (takes_h, takes_unit) =
            (lyon.difference.takes_halfway(), lyon.difference.takes_unit_halfway());
        let sum = takes_h.then(|| f.vector_sum().quantise_vector(l + EYE));
        let unit = takes_unit.then(|| unit_halfway(lyon.halfway, l));
        Vectors {
            direction: f.vector.quantise_vector(l),
            halfway: sum.or(unit.map(|h| f.vector.quantise_vector(h.unwrap_or(DVec3::ZERO)))),
            has_highlight: unit != Some(None),
        }
    }
}

/// The half-way vector of about unit length; none where it has no direction.
fn unit_halfway(halfway: Halfway, light: DVec3) -> Option<DVec3> {
    let h = (light + EYE) / 2.0;
    match halfway {
        Halfway::Unit => h.try_normalize(),
        Halfway::Half => Some(h),
        Halfway::HalfG2 => {
            let y = 1.0 - h.length_squared();
            Some((1.0 + (y + y * y) / 2.0) * h)
        }
    }
}

/// Inputs that say what the normal is along a span.
struct NormalInputs {
    start: [i64; 3],
    delta: Option<[i64; 3]>,
    axis: Option<[i64; 3]>,
    follows: Option<i64>,
}

impl LyonSetUp<'_> {
    fn sends_ways(&self) -> bool {
        self.lyon.places.sends_ways(self.frame)
    }

    fn ways<'b>(&'b self, span: &'b Span) -> Ways<'b> {
        Ways { frame: self.frame, span, accumulator: self.lyon.formats.way_accumulator }
    }

    fn normals(&self, span: &Span) -> NormalInputs {
        let f = &self.lyon.formats;
        let between = |ends| self.lyon.span_vectors().quantised(span, ends);
        match self.lyon.normals {
            Normals::Linear => {
                let [start, delta] = between(self.frame.end_normals(span));
                NormalInputs { start, delta: Some(delta), axis: None, follows: None }
            }
            Normals::Flat => {
                let start = f.vector.quantise_vector(self.frame.facet_normal(span));
                NormalInputs { start, delta: None, axis: None, follows: None }
            }
            Normals::Wrapped => {
                let NormalWrap { wrap, follows } = self.lyon.wrap(self.frame, span);
                let follows = self.lyon.follows().then_some(i64::from(follows));
                let [start, delta] = between(match follows {
                    Some(_) => wrap.ends,
                    None => wrap.ends.map(|n| n + wrap.axis),
                });
                NormalInputs {
                    start,
                    delta: Some(delta),
                    axis: Some(f.vector.quantise_vector(wrap.axis)),
                    follows,
                }
            }
        }
    }

    /// What the weight grows by, where there is one.
    fn weight_step(&self, span: &Span) -> Option<i64> {
        let changes = self.lyon.normals != Normals::Flat;
        (changes && self.lyon.increments == Increments::Multiplied)
            .then(|| self.lyon.formats.weight_accumulator.quantise(span.weight_step()))
    }

    fn shininess(&self, shininess: u32) -> i64 {
        let (lyon, n) = (self.lyon, f64::from(shininess));
        match (lyon.shape, lyon.odd_power) {
            (ShapeDatapath::FK, 2..) => {
                lyon.formats.shininess_share.quantise(lyon.shininess_factor() * n)
            }
            (ShapeDatapath::FK, _) => shininess.into(),
            (ShapeDatapath::Root, _) => {
                lyon.formats.root_shininess.quantise((lyon.root_factor() * n).sqrt())
            }
        }
    }
}

impl MethodSetUp for LyonSetUp<'_> {
    type SpanGroup = LyonSpan<i64>;
    type LightGroup = LyonLight<i64>;
    type Geometry = ();

    fn geometry(&self, _span: &Span) {}

    fn span_inputs(&self, span: &Span, (): &()) -> LyonSpan<i64> {
        let normals = self.normals(span);
        LyonSpan {
            normal_start: normals.start,
            normal_delta: normals.delta,
            weight_step: self.weight_step(span),
            wrap_axis: normals.axis,
            wrap_follows: normals.follows,
            eye: self.ways(span).vector_eye().filter(|_| self.sends_ways()),
            shininess: self.shininess(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, (): &(), index: usize) -> LyonLight<i64> {
        if self.sends_ways() {
            let way = self.ways(span).vector_light(index, self.lyon.formats.vector);
            return LyonLight { direction: None, way: Some(way), halfway: None };
        }
        let &Vectors { direction, halfway, .. } = &self.lights[index];
        LyonLight { direction: Some(direction), way: None, halfway }
    }

    fn has_highlight(&self, index: usize) -> bool {
        self.sends_ways() || self.lights[index].has_highlight
    }
}
