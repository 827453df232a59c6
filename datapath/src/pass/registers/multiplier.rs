//! A product in a multiplier block, with the registers that the block has inside.
use super::Placing;
use crate::design::{MultiplierBlock, Node, NodeId, Op, Register};

impl Placing<'_> {
    /// The product `node` of these factors, `registers` clocks later in the block's own registers.
    pub(super) fn multiplied(
        &mut self,
        node: Node,
        factors: [NodeId; 2],
        registers: u32,
    ) -> NodeId {
        let taken = match registers {
            0 | 1 => [None; 2],
            _ => self.factors_taken(&node.name, factors),
        };
        let [a, b] = [0, 1].map(|k| taken[k].unwrap_or(factors[k]));
        let entry = node.stage;
        let (op, stage) = (Op::Mul(a, b), entry + registers.min(2));
        let pipelined = (registers > 2).then(|| {
            let name = self.unique(node.scope, &format!("{}_pipelined", node.name));
            let (register, named) = (Register::Data, false);
            self.push(Node { op, register, stage, name, named, ..node.clone() })
        });
        let register = if registers == 0 { Register::None } else { Register::Data };
        let product = match pipelined {
            None => self.push(Node { op, register, stage, ..node }),
            Some(before) => {
                let (op, stage) = (Op::Copy(before), stage + 1);
                self.push(Node { op, register, stage, ..node })
            }
        };
        self.multipliers.push(MultiplierBlock { factors, registers, taken, pipelined, product });
        product
    }

    /// The block's registers of the factors; a square has one, a constant none.
    fn factors_taken(&mut self, product: &str, factors: [NodeId; 2]) -> [Option<NodeId>; 2] {
        let mut taken = [None; 2];
        for (k, side) in ["a", "b"].into_iter().enumerate() {
            if k == 1 && factors[0] == factors[1] {
                return [taken[0]; 2];
            }
            let node = self.node(factors[k]).clone();
            if node.op.constant().is_none() {
                let scope = node.scope;
                let name = self.unique(scope, &format!("{product}_{side}"));
                let (op, register, stage) = (Op::Copy(factors[k]), Register::Data, node.stage + 1);
                let named = false;
                taken[k] = Some(self.push(Node { op, register, stage, name, named, ..node }));
            }
        }
        taken
    }
}
