//! Which values stand in loops.
use crate::graph::Graph;

/// The loop that each value stands in: those that a register's value reaches before the register
/// takes over the next.
pub fn loops(graph: &Graph) -> Vec<Option<usize>> {
    let count = graph.values.len();
    let mut reads: Vec<Vec<usize>> = vec![vec![]; count];
    for (index, value) in graph.values.iter().enumerate() {
        reads[index] = value.op.operands().map(|operand| operand.0 as usize).collect();
    }
    strong_components(&reads)
}

/// The strongly connected component of each node that is in one of several nodes, by Tarjan's
/// algorithm without recursion.
pub fn strong_components(edges: &[Vec<usize>]) -> Vec<Option<usize>> {
    let count = edges.len();
    let mut search = Components {
        order: vec![None; count],
        lowest: vec![0; count],
        open: vec![],
        is_open: vec![false; count],
        found: vec![None; count],
        next: 0,
    };
    for node in 0..count {
        if search.order[node].is_none() {
            search.from(node, edges);
        }
    }
    search.found
}

struct Components {
    order: Vec<Option<usize>>,
    lowest: Vec<usize>,
    open: Vec<usize>,
    is_open: Vec<bool>,
    found: Vec<Option<usize>>,
    next: usize,
}

impl Components {
    fn from(&mut self, root: usize, edges: &[Vec<usize>]) {
        let mut path = vec![(root, 0)];
        self.enter(root);
        while let Some((node, edge)) = path.last_mut() {
            let node = *node;
            if let Some(&to) = edges[node].get(*edge) {
                *edge += 1;
                match self.order[to] {
                    None => {
                        self.enter(to);
                        path.push((to, 0));
                    }
                    Some(order) if self.is_open[to] => {
                        self.lowest[node] = self.lowest[node].min(order);
                    }
                    Some(_) => {}
                }
                continue;
            }
            path.pop();
            if let Some(&(before, _)) = path.last() {
                self.lowest[before] = self.lowest[before].min(self.lowest[node]);
            }
            if Some(self.lowest[node]) == self.order[node] {
                self.close(node);
            }
        }
    }

    fn enter(&mut self, node: usize) {
        self.order[node] = Some(self.next);
        self.lowest[node] = self.next;
        self.next += 1;
        self.open.push(node);
        self.is_open[node] = true;
    }

    fn close(&mut self, node: usize) {
        let first = self.open.iter().rposition(|&open| open == node).unwrap_or(0);
        let members = self.open.split_off(first);
        for &member in &members {
            self.is_open[member] = false;
            if members.len() > 1 {
                self.found[member] = Some(node);
            }
        }
    }
}
