//! Columns for roots.
use std::collections::{HashMap, HashSet};

use specula_hdl::design::{NodeId, Op};

use super::Planner;
use crate::fast::memory::Place;
use crate::fast::schedule::Group;

impl Planner<'_> {
    /// Gives every root a column; those that are read in their own lane only, and not watched, share memory.
    pub(super) fn allocate(&mut self, order: &[Group], watched: &[NodeId]) {
        let (history, last_use) = self.uses(order, watched);
        let lasting: HashSet<NodeId> = watched.iter().map(|&w| self.flow.source(w).root).collect();
        let mut free: [Vec<Place>; 2] = [vec![], vec![]];
        let mut ending: HashMap<usize, Vec<NodeId>> = HashMap::new();
        for (&root, &group) in &last_use {
            ending.entry(group).or_default().push(root);
        }
        for (number, group) in order.iter().enumerate() {
            for &root in group.members() {
                let keeps = history.get(&root).copied().unwrap_or(0);
                let shared = self.may_share(root, group, keeps, &lasting);
                let wide = self.is_wide(root);
                let reused = if shared { free[usize::from(wide)].pop() } else { None };
                let place = reused.unwrap_or_else(|| self.memory.add(wide, keeps, self.batch));
                self.places.insert(root, place);
            }
            let mut ended = ending.remove(&number).unwrap_or_default();
            ended.sort_unstable();
            for root in ended {
                let keeps = history.get(&root).copied().unwrap_or(0);
                let column = Group::Column(root);
                let holder = order.iter().find(|g| g.members().contains(&root)).unwrap_or(&column);
                if self.may_share(root, holder, keeps, &lasting) {
                    let place = self.places[&root];
                    free[usize::from(place.wide)].push(place);
                }
            }
        }
    }

    fn may_share(&self, root: NodeId, group: &Group, history: usize, lasting: &HashSet<NodeId>) -> bool {
        let plain = matches!(group, Group::Column(_)) && self.node(root).op != Op::Input;
        plain && history == 0 && !lasting.contains(&root)
    }

    /// For each root, the clocks that readers look back, and the last group that reads it.
    fn uses(&self, order: &[Group], watched: &[NodeId]) -> (HashMap<NodeId, usize>, HashMap<NodeId, usize>) {
        let mut history: HashMap<NodeId, usize> = HashMap::new();
        let mut last_use = HashMap::new();
        for (number, group) in order.iter().enumerate() {
            for &member in group.members() {
                let skew = self.skews[&member];
                for operand in self.flow.operands(self.design, member) {
                    let root = self.flow.source(operand).root;
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
