//! The needs of several frames together.
use super::{Interval, LocalKind, Needs, Ranges};
use crate::contributions::Contributions;

impl Needs {
    /// The needs of a core that is to shade both: whatever either needs.
    ///
    /// Lights go with lights of their number; both have the same kinds of lights at places, as the
    /// frames of a sequence do ([`crate::sequence`]).
    pub fn and(self, other: Needs) -> Needs {
        let at_infinity = |needs: &Needs| needs.lights - needs.local_lights.len();
        let most_at_infinity = at_infinity(&self).max(at_infinity(&other));
        let local_lights = kinds(&self.local_lights, &other.local_lights);
        Needs {
            lights: most_at_infinity + local_lights.len(),
            local_lights,
            attenuated_lights: either(self.attenuated_lights, other.attenuated_lights),
            local_eye: self.local_eye || other.local_eye,
            longest_span: self.longest_span.max(other.longest_span),
            picture_width: self.picture_width.max(other.picture_width),
            smallest_shininess: self.smallest_shininess.min(other.smallest_shininess),
            largest_shininess: self.largest_shininess.max(other.largest_shininess),
            uneven_shininess: self.uneven_shininess.or(other.uneven_shininess),
            materials: self.materials.max(other.materials),
            brightest_coefficient: self.brightest_coefficient.max(other.brightest_coefficient),
            contributions: self.contributions.and(&other.contributions),
            flat: self.flat && other.flat,
            consistent_normals_differ: self.consistent_normals_differ
                || other.consistent_normals_differ,
            widest_angle: self.widest_angle.max(other.widest_angle),
            shortest_normal: self.shortest_normal.min(other.shortest_normal),
            shortest_way: self.shortest_way.min(other.shortest_way),
            shortest_unit_way: self.shortest_unit_way.min(other.shortest_unit_way),
            shortest_halfway: self.shortest_halfway.min(other.shortest_halfway),
            most_off_by_wraps: self.most_off_by_wraps.max(other.most_off_by_wraps),
            least_cone_cosine: self.least_cone_cosine.min(other.least_cone_cosine),
            least_view_cosine: self.least_view_cosine.min(other.least_view_cosine),
            least_view_cosine_of_pixels: self
                .least_view_cosine_of_pixels
                .min(other.least_view_cosine_of_pixels),
            ranges: self.ranges.and(&other.ranges),
        }
    }
}

/// Lights at places of which each may be either of two: a spot with the larger exponent.
fn kinds(a: &[LocalKind], b: &[LocalKind]) -> Vec<LocalKind> {
    let kind = |(a, b): (&LocalKind, &LocalKind)| match (a, b) {
        (LocalKind::Spot { exponent: a }, LocalKind::Spot { exponent: b }) => {
            LocalKind::Spot { exponent: *a.max(b) }
        }
        (a, _) => *a,
    };
    a.iter().zip(b).map(kind).collect()
}

/// Numbers that are in either list, ascending.
fn either(mut a: Vec<usize>, b: Vec<usize>) -> Vec<usize> {
    a.extend(b);
    a.sort_unstable();
    a.dedup();
    a
}

impl Contributions {
    fn and(&self, other: &Contributions) -> Contributions {
        let most = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|c| a[c].max(b[c]));
        Contributions {
            ambient: most(self.ambient, other.ambient),
            diffuse: most(self.diffuse, other.diffuse),
            specular: most(self.specular, other.specular),
            grey: self.grey && other.grey,
        }
    }
}

impl Ranges {
    fn and(&self, other: &Ranges) -> Ranges {
        let of_vectors =
            |a: [Interval; 3], b: [Interval; 3]| std::array::from_fn(|i| a[i].hull(b[i]));
        let mut lights = [&self.normal_dot_light, &other.normal_dot_light];
        lights.sort_by_key(|lights| lights.len());
        let [fewer, more] = lights;
        let light = |(number, own): (usize, &Interval)| {
            fewer.get(number).map_or(*own, |other| own.hull(*other))
        };
        Ranges {
            normal: of_vectors(self.normal, other.normal),
            normal_delta: of_vectors(self.normal_delta, other.normal_delta),
            normal_dot_eye: self.normal_dot_eye.hull(other.normal_dot_eye),
            normal_dot_light: more.iter().enumerate().map(light).collect(),
            weight_step: self.weight_step.hull(other.weight_step),
        }
    }
}
