//! What a vertex sends back, which the host computes [lecture, eq. 2.1].
use glam::DVec3;
use smallvec::SmallVec;
use specula_scene::limits::MOST_LIGHTS;
use specula_scene::{Frame, Illumination};

use super::VertexHighlight;

/// A point of a surface, and the light that reaches it.
pub struct LitPoint {
    /// N, a unit vector; 0 where the surface has none.
    pub normal: DVec3,
    /// V, a unit vector towards the eye; `None` for an eye at that very point.
    pub view: Option<DVec3>,
    /// Every light, those at infinity first; `None` for a light at that very point (extremes row
    /// 39).
    pub lights: SmallVec<[Option<Illumination>; MOST_LIGHTS]>,
}

impl LitPoint {
    /// A point of a frame.
    pub fn new(frame: &Frame, normal: DVec3, position: DVec3) -> LitPoint {
        LitPoint {
            normal,
            view: frame.view_from(position),
            lights: frame.lights_from(position).collect(),
        }
    }

    /// What distance leaves of light number `index` here; 1 of one that does not become weaker.
    pub fn attenuation(&self, index: usize) -> f64 {
        self.lights[index].map_or(1.0, |light| light.attenuation)
    }

    /// Lambert's max(N·L, 0) of light number `index`, times the light's share.
    pub fn diffuse(&self, index: usize) -> f64 {
        self.lights[index]
            .map_or(0.0, |light| light.share * self.normal.dot(light.direction).max(0.0))
    }

    /// The highlight of R = 2(N·V)N - V [lecture, eq. 2.1] and light number `index`, times the light's
    /// share; 0 where there is no normal to reflect about.
    pub fn highlight(&self, index: usize, highlight: VertexHighlight) -> f64 {
        let (Some(light), Some(view)) = (self.lights[index], self.view) else { return 0.0 };
        if self.normal == DVec3::ZERO {
            return 0.0;
        }
        let reflection = 2.0 * self.normal.dot(view) * self.normal - view;
        light.share * highlight.of(reflection, light.direction)
    }
}
