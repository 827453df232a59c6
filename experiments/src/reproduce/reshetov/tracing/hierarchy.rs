//! A hierarchy of boxes around triangles, so that a ray is tried with few of them.
use glam::DVec3;

use super::ray::{Crossing, Ray};

/// Triangles that a leaf has at most.
const LEAF: usize = 4;

/// A tree of boxes; the first is around all triangles.
pub struct Hierarchy {
    nodes: Vec<Node>,
    /// Numbers of the triangles, those of a leaf side by side.
    order: Vec<usize>,
}

struct Node {
    corners: [DVec3; 2],
    content: Content,
}

enum Content {
    /// A range of the order.
    Leaf(std::ops::Range<usize>),
    /// The numbers of two nodes.
    Halves([usize; 2]),
}

impl Hierarchy {
    /// The hierarchy of triangles, halved at the median along the longest side.
    pub fn new(triangles: &[[DVec3; 3]]) -> Hierarchy {
        let mut hierarchy =
            Hierarchy { nodes: vec![], order: (0..triangles.len()).collect::<Vec<_>>() };
        hierarchy.add(triangles, 0..triangles.len());
        hierarchy
    }

    /// Adds the node of a range of the order, and all below it.
    fn add(&mut self, triangles: &[[DVec3; 3]], range: std::ops::Range<usize>) -> usize {
        let part = &mut self.order[range.clone()];
        let [low, high] = corners(part.iter().flat_map(|&k| triangles[k]));
        let number = self.nodes.len();
        if part.len() <= LEAF {
            self.nodes.push(Node { corners: [low, high], content: Content::Leaf(range) });
            return number;
        }
        let axis = (high - low).max_position();
        let along = |k: &usize| triangles[*k].iter().map(|corner| corner[axis]).sum::<f64>();
        let half = part.len() / 2;
        part.select_nth_unstable_by(half, |a, b| along(a).total_cmp(&along(b)));
        self.nodes.push(Node { corners: [low, high], content: Content::Leaf(0..0) });
        let middle = range.start + half;
        let halves =
            [self.add(triangles, range.start..middle), self.add(triangles, middle..range.end)];
        self.nodes[number].content = Content::Halves(halves);
        number
    }

    /// The triangle that a ray meets first, farther than `nearest` from its origin.
    pub fn first(
        &self,
        triangles: &[[DVec3; 3]],
        ray: Ray,
        nearest: f64,
    ) -> Option<(usize, Crossing)> {
        let mut found: Option<(usize, Crossing)> = None;
        let mut open = vec![0];
        while let Some(node) = open.pop().map(|number: usize| &self.nodes[number]) {
            let farthest = found.map_or(f64::INFINITY, |(_, crossing)| crossing.distance);
            if ray.entry(node.corners, farthest).is_none() {
                continue;
            }
            match &node.content {
                Content::Halves(halves) => open.extend(halves),
                Content::Leaf(range) => {
                    for &k in &self.order[range.clone()] {
                        let nearer = |crossing: &Crossing| {
                            found.is_none_or(|(_, found)| crossing.distance < found.distance)
                        };
                        let crossing = ray.crossing(triangles[k], nearest).filter(nearer);
                        found = crossing.map(|crossing| (k, crossing)).or(found);
                    }
                }
            }
        }
        found
    }
}

/// The corners of the box around places.
pub fn corners(places: impl Iterator<Item = DVec3>) -> [DVec3; 2] {
    places.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], p| [low.min(p), high.max(p)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stress::draw::Draw;

    /// Rays among random triangles meet what trying each triangle finds.
    #[test]
    fn the_first_is_the_nearest_of_all() {
        let mut draw = Draw::new(31, 0);
        let mut point = |size: f64| {
            DVec3::new(draw.within(-size, size), draw.within(-size, size), draw.within(-size, size))
        };
        let triangles: Vec<[DVec3; 3]> = (0..200)
            .map(|_| {
                let middle = point(1.0);
                [(); 3].map(|()| middle + point(0.2))
            })
            .collect();
        let hierarchy = Hierarchy::new(&triangles);
        let mut met = 0;
        for _ in 0..2000 {
            let ray = Ray { origin: point(1.0), direction: point(1.0).normalize() };
            let all =
                triangles.iter().enumerate().filter_map(|(k, t)| Some((k, ray.crossing(*t, 0.0)?)));
            let nearest = all.min_by(|(_, a), (_, b)| a.distance.total_cmp(&b.distance));
            assert_eq!(hierarchy.first(&triangles, ray, 0.0), nearest);
            met += usize::from(nearest.is_some());
        }
        assert!((300..1700).contains(&met), "rays that meet some: {met}");
    }
}
