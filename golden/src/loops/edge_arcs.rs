//! Normals that turn along the edges of a triangle from scan line to scan line [lecture, §4.4, steps
//! ii and iii, eq. 4.9 to 4.12; methods A9, A11].
use glam::{DVec2, DVec3};
use specula_scene::{Arc, Span};

/// The three edges of a triangle, with the normals that they have on the current scan line.
#[derive(Clone, Debug)]
pub struct EdgeArcs([EdgeArc; 3]);

/// An edge from its upper vertex to its lower one.
#[derive(Clone, Debug)]
struct EdgeArc {
    ends: [DVec2; 2],
    /// The number of the current scan line, which is counted from the top.
    line: f64,
    /// The point where the edge meets it, in pixels from the left, and Δx.
    x: f64,
    x_step: f64,
    arc: Arc,
    /// cos tφ and sin tφ on the current line.
    turn: DVec2,
    /// cos φΔt and sin φΔt, Δt = 1/(y2 - y1) [eq. 4.9 to 4.12].
    step: DVec2,
}

impl EdgeArcs {
    /// The edges of a triangle in the picture, whose corners are in pixels to the right and down, with
    /// unit normals there.
    pub fn new(outline: [DVec2; 3], normals: [DVec3; 3]) -> EdgeArcs {
        let edge = |from: usize| {
            let to = (from + 1) % 3;
            let [upper, lower] =
                if outline[from].y <= outline[to].y { [from, to] } else { [to, from] };
            EdgeArc::new(
                [upper, lower].map(|k| outline[k]),
                Arc::between([upper, lower].map(|k| normals[k])),
            )
        };
        EdgeArcs([0, 1, 2].map(edge))
    }

    /// Unit normals at the first pixel of a span of the triangle and at the last, between those on
    /// the two edges that its line meets; `None` where f64 tells no two of them.
    pub fn ends(&mut self, span: &Span) -> Option<[DVec3; 2]> {
        let line = f64::from(span.y);
        let EdgeArcs(edges) = self;
        let mut crossed = edges.iter_mut().filter(|edge| edge.meets(line));
        let [one, other] = [crossed.next()?, crossed.next()?].map(|edge| edge.step_to(line));
        let [left, right] = if one.0 <= other.0 { [one, other] } else { [other, one] };
        let arc = Arc::between([left.1, right.1]);
        let width = right.0 - left.0;
        let share = |column: u32| {
            let pixels = f64::from(column) + 0.5 - left.0;
            if width > 0.0 { (pixels / width).clamp(0.0, 1.0) } else { 0.0 }
        };
        Some([span.x, span.x + span.steps()].map(|column| arc.at(share(column))))
    }
}

impl EdgeArc {
    fn new(ends: [DVec2; 2], arc: Arc) -> EdgeArc {
        let [from, to] = ends;
        let down = to - from;
        // An edge along a scan line is met by none.
        let per_line = if down.y > 0.0 { down.y.recip() } else { 0.0 };
        let mut edge = EdgeArc {
            ends,
            line: 0.0,
            x: 0.0,
            x_step: down.x * per_line,
            step: DVec2::from_angle(arc.angle * per_line),
            turn: DVec2::X,
            arc,
        };
        edge.start_at((from.y - 0.5).ceil());
        edge
    }

    /// Whether a line's centre is on it. Its upper end belongs to it, its lower does not, so that a
    /// line meets two edges.
    fn meets(&self, line: f64) -> bool {
        let centre = line + 0.5;
        self.ends[0].y <= centre && centre < self.ends[1].y
    }

    /// Where it meets a line, and its normal there. The next span of a triangle is usually one line
    /// further, or on the same one.
    fn step_to(&mut self, line: f64) -> (f64, DVec3) {
        match line - self.line {
            0.0 => {}
            1.0 => {
                self.turn = self.step.rotate(self.turn);
                self.x += self.x_step;
                self.line = line;
            }
            _ => self.start_at(line),
        }
        (self.x, self.arc.start * self.turn.x + self.arc.across * self.turn.y)
    }

    /// Begins anew on a line.
    fn start_at(&mut self, line: f64) {
        let [from, to] = self.ends;
        let lines = line + 0.5 - from.y;
        let t = if to.y > from.y { lines / (to.y - from.y) } else { 0.0 };
        self.line = line;
        self.x = from.x + lines * self.x_step;
        self.turn = DVec2::from_angle(t * self.arc.angle);
    }
}
