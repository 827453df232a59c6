//! Placement of labels next to points, so that they do not overlap each other nor, where there is
//! room, what is drawn.
use specula_drawing::{CAPITAL, CHARACTER, Point};

/// A rectangle: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Area {
    /// The square of side 2 `radius` about a point.
    pub fn about((x, y): Point, radius: f64) -> Area {
        Area { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius }
    }

    fn overlaps(&self, other: &Area) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn is_within(&self, outer: &Area) -> bool {
        self.left >= outer.left
            && self.right <= outer.right
            && self.top >= outer.top
            && self.bottom <= outer.bottom
    }

    /// Its point nearest to another one.
    fn nearest(&self, (x, y): Point) -> Point {
        (x.clamp(self.left, self.right), y.clamp(self.top, self.bottom))
    }
}

/// A label in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The beginning of its base line.
    pub begin: Point,
    /// A line from the label to its point, if the label is not next to it.
    pub leader: Option<(Point, Point)>,
}

/// Possible distances of labels from their points, in pixels.
const DISTANCES: [f64; 8] = [7.0, 13.0, 22.0, 34.0, 48.0, 64.0, 84.0, 110.0];
/// Number of directions in which a label may stand.
const DIRECTIONS: u32 = 16;
/// Least distance at which a line connects the label and its point.
const FAR: f64 = 13.0;
/// Distance between labels.
const ROOM: f64 = 2.0;
/// The cost of covering something drawn, in pixels of distance.
const COVERING: f64 = 30.0;

/// Places labels next to their points, the first ones first, within an area; `drawn` is what they
/// should not cover. Labels for which there is no room are left out.
pub fn placed(labels: &[(Point, &str)], drawn: &[Area], within: &Area) -> Vec<Option<Placed>> {
    let mut taken: Vec<Area> = vec![];
    labels
        .iter()
        .map(|&(place, words)| {
            let best = candidates(place, words)
                .filter(|(_, area)| {
                    area.is_within(within) && !taken.iter().any(|other| other.overlaps(area))
                })
                .map(|(distance, area)| {
                    (
                        distance
                            + COVERING
                                * drawn.iter().filter(|shape| shape.overlaps(&area)).count() as f64,
                        distance,
                        area,
                    )
                })
                .min_by(|one, other| one.0.total_cmp(&other.0));
            let (_, distance, area) = best?;
            taken.push(area);
            let leader = (distance >= FAR).then(|| (place, area.nearest(place)));
            Some(Placed { begin: (area.left + ROOM, area.bottom - ROOM), leader })
        })
        .collect()
}

/// Areas that a label could take around a point, each with its distance from the point.
fn candidates((x, y): Point, words: &str) -> impl Iterator<Item = (f64, Area)> {
    let (width, height) =
        (CHARACTER * words.chars().count() as f64 + 2.0 * ROOM, CAPITAL + 2.0 * ROOM);
    let area = move |distance: f64, direction: u32| {
        let turn = std::f64::consts::TAU * f64::from(direction) / f64::from(DIRECTIONS);
        let (sin, cos) = (libm::sin(turn), libm::cos(turn));
        let middle = (x + cos * (distance + width / 2.0), y - sin * (distance + height / 2.0));
        let (left, top) = ((middle.0 - width / 2.0).round(), (middle.1 - height / 2.0).round());
        Area { left, top, right: left + width, bottom: top + height }
    };
    DISTANCES.into_iter().flat_map(move |distance| {
        (0..DIRECTIONS).map(move |direction| (distance, area(distance, direction)))
    })
}
