//! How much of the past a plan depends on.
use std::collections::HashMap;

use specula_datapath::design::NodeId;

use super::Planner;
use crate::fast::flow::{Recurrence, Source};
use crate::fast::schedule::Group;

impl Planner<'_> {
    /// How far back the inputs lie that the watched values depend on.
    pub(super) fn reach(&self, order: &[Group], watched: &[NodeId]) -> u64 {
        let mut reaches: HashMap<NodeId, u64> = HashMap::new();
        let reach_of =
            |reaches: &HashMap<NodeId, u64>, root: NodeId| reaches.get(&root).copied().unwrap_or(0);
        for group in order {
            for &member in group.members() {
                let skew = self.skews[&member];
                let variable = |o: &Source| self.skews.contains_key(&o.root);
                let operands = self.flow.operands(self.design, member).into_iter().filter(variable);
                let reach = operands
                    .map(|o| reach_of(&reaches, o.root) + self.back(o, skew) as u64)
                    .max()
                    .unwrap_or(0);
                reaches.insert(member, reach);
            }
        }
        watched
            .iter()
            .map(|&id| self.shift(id) + reach_of(&reaches, self.flow.source(id).root))
            .max()
            .unwrap_or(0)
    }

    /// Whether all feedback is accumulators that the beginning of a span loads and registers that
    /// hold what the last pixel had, and none takes what another was in the span before.
    pub(super) fn restarts_with_spans(&self, order: &[Group]) -> bool {
        // For each root that depends on feedback, how many clocks before its own.
        let mut ages: HashMap<NodeId, usize> = HashMap::new();
        for group in order {
            let Group::Column(root) = group else { return false };
            let skew = self.skews[root];
            let operands = self.flow.operands(self.design, *root).into_iter();
            let age_of = |o: Source| ages.get(&o.root).map(|age| age + self.back(o, skew));
            let age = operands.filter_map(age_of).max();
            match self.flow.recurrences[root.0 as usize] {
                None => ages.extend(age.map(|age| (*root, age))),
                Some(feedback) => {
                    if !self.is_loaded_by_spans(feedback) || age.is_some_and(|age| age > 0) {
                        return false;
                    }
                    ages.insert(*root, 0);
                }
            }
        }
        true
    }

    /// Whether the first pixel of a span brings feedback to what it is in every run.
    fn is_loaded_by_spans(&self, feedback: Recurrence) -> bool {
        let is_valid = |id: NodeId| self.flow.source(id).root == self.design.valid;
        match feedback {
            Recurrence::Hold { enable, .. } => is_valid(enable),
            Recurrence::Accumulate { valid, first, registers, .. } => {
                // The pixel that is the first has to be the one that counts.
                let together = self.shift(valid) == self.shift(first);
                let first = self.flow.source(first).root == self.design.start;
                first && is_valid(valid) && together && registers == 1
            }
        }
    }
}
