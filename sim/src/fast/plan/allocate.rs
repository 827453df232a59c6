//! Columns for roots.
use std::collections::{HashMap, HashSet};

use specula_datapath::design::{NodeId, Op};

use super::Planner;
use crate::fast::memory::Place;
use crate::fast::schedule::Group;

impl Planner<'_> {
    /// Gives every root a column; those that are read in their own lane only, and not watched,
    /// share memory.
    pub(super) fn allocate(&mut self, order: &[Group], watched: &[NodeId]) {
        let (history, last_use) = self.uses(order, watched);
        let keeps = |root: NodeId| history.get(&root).copied().unwrap_or(0);
        let sharing = self.sharing(order, watched, &keeps);
        let mut ending: HashMap<usize, Vec<NodeId>> = HashMap::new();
        for (&root, &group) in last_use.iter().filter(|(root, _)| sharing.contains(root)) {
            ending.entry(group).or_default().push(root);
        }
        let mut free: [Vec<Place>; 2] = [vec![], vec![]];
        for (number, group) in order.iter().enumerate() {
            for &root in group.members() {
                let wide = self.is_wide(root);
                let reused =
                    if sharing.contains(&root) { free[usize::from(wide)].pop() } else { None };
                let place =
                    reused.unwrap_or_else(|| self.memory.add(wide, keeps(root), self.batch));
                self.places.insert(root, place);
            }
            let mut ended = ending.remove(&number).unwrap_or_default();
            ended.sort_unstable();
            for place in ended.iter().map(|root| self.places[root]) {
                free[usize::from(place.wide)].push(place);
            }
        }
    }

    /// The roots whose columns may be used again once they have been read.
    fn sharing(
        &self,
        order: &[Group],
        watched: &[NodeId],
        keeps: &dyn Fn(NodeId) -> usize,
    ) -> HashSet<NodeId> {
        let lasting: HashSet<NodeId> = watched.iter().map(|&w| self.flow.source(w).root).collect();
        let column =
            |group: &Group| if let Group::Column(root) = group { Some(*root) } else { None };
        let shares = |root: &NodeId| {
            self.node(*root).op != Op::Input && keeps(*root) == 0 && !lasting.contains(root)
        };
        order.iter().filter_map(column).filter(shares).collect()
    }

    /// For each root, the clocks that readers look back, and the last group that reads it.
    fn uses(
        &self,
        order: &[Group],
        watched: &[NodeId],
    ) -> (HashMap<NodeId, usize>, HashMap<NodeId, usize>) {
        let mut history: HashMap<NodeId, usize> = HashMap::new();
        let mut last_use = HashMap::new();
        for (number, group) in order.iter().enumerate() {
            for &member in group.members() {
                let skew = self.skews[&member];
                for operand in self.flow.operands(self.design, member) {
                    let root = operand.root;
                    if self.skews.contains_key(&root) {
                        let keeps = history.entry(root).or_default();
                        *keeps = (*keeps).max(self.back(operand, skew));
                        last_use.insert(root, number);
                    }
                }
            }
        }
        let earliest = watched.iter().map(|&w| self.shift(w)).min().unwrap_or(0);
        for &id in watched {
            let keeps = history.entry(self.flow.source(id).root).or_default();
            *keeps = (*keeps).max((self.shift(id) - earliest) as usize);
        }
        (history, last_use)
    }
}
