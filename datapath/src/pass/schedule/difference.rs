//! The linear programme of a schedule: integers with least differences between them, and a weight
//! for each, so that the weighted sum is least.
//!
//! ```text
//! minimise   sum of weight(i) x(i)      where  x(to) - x(from) >= gap,  x >= 0
//! ```
//!
//! It is the dual of a minimum-cost flow, so it has an integral solution [Leiserson and Saxe 1991].
//! Its objective is L-natural-convex, for which steepest descent is exact: from the least feasible
//! point, the least set of variables whose increase gains most is raised until the gain or a
//! difference ends it [Murota 2003, Shioura 2017]. Which set that is, a minimum cut says: the set
//! must be closed under differences that leave no room [Picard 1976]. The flow of that cut is one of
//! the next step's network, too: a difference that gets room has none of it, as it leads into the set
//! from outside. So it goes on growing, as in the primal-dual method [Ford and Fulkerson 1962].
use std::collections::VecDeque;

use crate::pass::loops::strong_components;

/// A variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variable(usize);

impl Variable {
    /// Its place among all.
    pub fn index(self) -> usize {
        self.0
    }
}

/// The programme.
#[derive(Clone, Debug, Default)]
pub struct Differences {
    weights: Vec<i64>,
    /// (from, to, gap): x(to) - x(from) >= gap.
    gaps: Vec<(usize, usize, i64)>,
}

impl Differences {
    /// A new variable without weight.
    pub fn variable(&mut self) -> Variable {
        self.weights.push(0);
        Variable(self.weights.len() - 1)
    }

    /// Adds to a variable's weight.
    pub fn weigh(&mut self, variable: Variable, weight: i64) {
        self.weights[variable.0] += weight;
    }

    /// Asks that `to` be at least `from` + `gap`.
    pub fn at_least(&mut self, to: Variable, from: Variable, gap: i64) {
        self.gaps.push((from.0, to.0, gap));
    }

    /// The set of variables that each belongs to whose differences are fixed; none of those that are
    /// alone.
    pub fn tied(&self) -> Vec<Option<usize>> {
        let mut edges = vec![vec![]; self.weights.len()];
        self.gaps.iter().for_each(|&(from, to, _)| edges[from].push(to));
        strong_components(&edges)
    }

    /// The least solution of all that are optimal, by variable; none if the differences contradict
    /// each other. The sum must have a least value, which it has where weights that are negative
    /// are held by others.
    pub fn solution(&self) -> Option<Solution> {
        let mut at = self.least()?;
        let mut cut = Cut::new(self);
        while let Some(raised) = cut.raised(self, &at) {
            // Differences from raised variables to others shrink; the first that has no room left
            // ends the step.
            let room = |&&(from, to, _): &&(usize, usize, i64)| raised[from] && !raised[to];
            let slack = |&(from, to, gap): &(usize, usize, i64)| at[to] - at[from] - gap;
            let step = self.gaps.iter().filter(room).map(slack).min()?;
            for (value, _) in at.iter_mut().zip(&raised).filter(|(_, raised)| **raised) {
                *value += step;
            }
        }
        Some(Solution(at))
    }

    /// The least feasible point, by relaxation; none if there is a cycle that grows.
    fn least(&self) -> Option<Vec<i64>> {
        let mut at = vec![0; self.weights.len()];
        for _ in 0..=self.weights.len() {
            let mut changed = false;
            for &(from, to, gap) in &self.gaps {
                if at[to] < at[from] + gap {
                    at[to] = at[from] + gap;
                    changed = true;
                }
            }
            if !changed {
                return Some(at);
            }
        }
        None
    }
}

/// The cut that tells which variables to raise, with its flow from one step to the next.
struct Cut {
    flow: Flow,
    /// The arc of the first difference; those of the others follow, two for each.
    first: usize,
    source: usize,
    sink: usize,
    /// What the source has room for that has not been sent.
    gain: i64,
}

impl Cut {
    fn new(Differences { weights, gaps }: &Differences) -> Cut {
        let (source, sink) = (weights.len(), weights.len() + 1);
        let mut flow = Flow::new(weights.len() + 2);
        let mut gain = 0;
        for (variable, &weight) in weights.iter().enumerate() {
            if weight < 0 {
                gain -= weight;
                flow.add(source, variable, -weight);
            } else if weight > 0 {
                flow.add(variable, sink, weight);
            }
        }
        let first = flow.to.len();
        gaps.iter().for_each(|&(from, to, _)| flow.add(from, to, 0));
        Cut { flow, first, source, sink, gain }
    }

    /// The least set whose increase by 1 gains most; none if no increase gains.
    fn raised(&mut self, program: &Differences, at: &[i64]) -> Option<Vec<bool>> {
        for (number, &(from, to, gap)) in program.gaps.iter().enumerate() {
            let arc = self.first + 2 * number;
            let sent = self.flow.room[arc ^ 1];
            let is_tight = at[to] - at[from] == gap;
            debug_assert!(is_tight || sent == 0, "a difference with room has no flow");
            self.flow.room[arc] = if is_tight { i64::MAX - sent } else { 0 };
        }
        let (sent, level) = self.flow.grow(self.source, self.sink);
        self.gain -= sent;
        let raised = || level[..at.len()].iter().map(Option::is_some).collect();
        (self.gain > 0).then(raised)
    }
}

/// A value for each variable.
#[derive(Clone, Debug)]
pub struct Solution(Vec<i64>);

impl Solution {
    /// The value of a variable.
    pub fn of(&self, variable: Variable) -> i64 {
        self.0[variable.0]
    }
}

/// A network with capacities, each arc beside the one that takes its flow back.
struct Flow {
    arcs: Vec<Vec<usize>>,
    to: Vec<usize>,
    room: Vec<i64>,
}

impl Flow {
    fn new(nodes: usize) -> Flow {
        Flow { arcs: vec![vec![]; nodes], to: vec![], room: vec![] }
    }

    fn add(&mut self, from: usize, to: usize, room: i64) {
        for (from, to, room) in [(from, to, room), (to, from, 0)] {
            self.arcs[from].push(self.to.len());
            self.to.push(to);
            self.room.push(room);
        }
    }

    /// Lets the flow grow to the greatest, by Dinic's algorithm: by how much, and how far each node is
    /// that is still reached.
    fn grow(&mut self, source: usize, sink: usize) -> (i64, Vec<Option<u32>>) {
        let mut total = 0;
        loop {
            let level = self.levels(source);
            if level[sink].is_none() {
                return (total, level);
            }
            let mut next = vec![0; self.arcs.len()];
            loop {
                let pushed = self.push(source, sink, &level, &mut next);
                if pushed == 0 {
                    break;
                }
                total += pushed;
            }
        }
    }

    /// Sends what one path of growing levels has room for; 0 if there is none left.
    fn push(
        &mut self,
        source: usize,
        sink: usize,
        level: &[Option<u32>],
        next: &mut [usize],
    ) -> i64 {
        let mut path: Vec<usize> = vec![];
        let mut node = source;
        while node != sink {
            let Some(&arc) = self.arcs[node].get(next[node]) else {
                // Nothing leads on from here: back, and past the arc that led here.
                let Some(last) = path.pop() else { return 0 };
                node = self.to[last ^ 1];
                next[node] += 1;
                continue;
            };
            let deeper = level[self.to[arc]] == level[node].map(|level| level + 1);
            if self.room[arc] > 0 && deeper {
                path.push(arc);
                node = self.to[arc];
            } else {
                next[node] += 1;
            }
        }
        let pushed = path.iter().map(|&arc| self.room[arc]).min().unwrap_or(0);
        for arc in path {
            self.room[arc] -= pushed;
            self.room[arc ^ 1] += pushed;
        }
        pushed
    }

    /// Arcs from the source to each node that is reached.
    fn levels(&self, source: usize) -> Vec<Option<u32>> {
        let mut level = vec![None; self.arcs.len()];
        level[source] = Some(0);
        let mut open = VecDeque::from([source]);
        while let Some(node) = open.pop_front() {
            for &arc in &self.arcs[node] {
                let to = self.to[arc];
                if self.room[arc] > 0 && level[to].is_none() {
                    level[to] = level[node].map(|level| level + 1);
                    open.push_back(to);
                }
            }
        }
        level
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The least sum over all values up to `most`, by trying each.
    fn least_sum(program: &Differences, most: i64) -> i64 {
        let count = program.weights.len() as u32;
        let base = most + 1;
        let points = (0..base.pow(count))
            .map(|number| (0..count).map(|k| number / base.pow(k) % base).collect::<Vec<i64>>());
        let feasible =
            points.filter(|x| program.gaps.iter().all(|&(from, to, gap)| x[to] - x[from] >= gap));
        feasible.map(|x| sum(program, &x)).min().expect("a point that keeps all differences")
    }

    fn sum(program: &Differences, x: &[i64]) -> i64 {
        program.weights.iter().zip(x).map(|(weight, value)| weight * value).sum()
    }

    proptest! {
        /// Small programmes with edges upwards, where no weight is left unheld.
        #[test]
        fn the_sum_is_the_least_of_all(
            gaps in prop::collection::vec((0usize..5, 0usize..5, 0i64..3), 1..10),
            weights in prop::collection::vec(1i64..6, 10),
        ) {
            let mut program = Differences::default();
            let variables: Vec<Variable> = (0..5).map(|_| program.variable()).collect();
            for ((a, b, gap), weight) in gaps.into_iter().zip(weights) {
                let (from, to) = (variables[a.min(b)], variables[a.max(b)]);
                if from == to { continue }
                program.at_least(to, from, gap);
                program.weigh(to, weight);
                program.weigh(from, -weight);
            }
            let solution = program.solution().expect("no cycles");
            let x: Vec<i64> = variables.iter().map(|&variable| solution.of(variable)).collect();
            prop_assert!(program.gaps.iter().all(|&(from, to, gap)| x[to] - x[from] >= gap));
            prop_assert_eq!(sum(&program, &x), least_sum(&program, 8));
        }
    }

    #[test]
    fn differences_that_contradict_each_other_have_no_solution() {
        let mut program = Differences::default();
        let [a, b] = [(); 2].map(|()| program.variable());
        program.at_least(a, b, 1);
        program.at_least(b, a, 0);
        assert!(program.solution().is_none());
    }
}
