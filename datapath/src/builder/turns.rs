//! Components that take turns: the three products of vectors through one multiplier, in three clocks
//! of a pixel [Lyon, TR 43, fig. 7: "parallelism versus serialization"].
//!
//! A pixel's values are there in the last of its time slots. In that clock the first two factors are
//! multiplied, and in the clocks behind it the others, which wait for their turn in registers:
//!
//! ```text
//! clock                 c        c + 1    c + 2
//! begins                1        0        0
//! a = begins ? x        x
//!   : begins' ? y'               y'
//!   : z''                                 z''           with v' = v a clock later
//! a b                   x u      y v      z w
//! ```
//!
//! No pixel begins before the three are through, since its own last time slot is at least three
//! clocks later; and pauses between time slots are no matter, since nothing here waits for one. So
//! the three products are as they would be of three multipliers, later by two clocks.
use super::state::SignalInfo;
use super::{Builder, Control, Sig, TimeSlots};
use crate::design::{NodeId, Op, Range, WideRange};
use crate::graph::{Pace, RealId, Rule};

/// The factors of three products.
pub(super) type Pairs<'a> = [[&'a Sig; 2]; 3];

/// Which products.
#[derive(Clone, Copy)]
pub(super) enum Products {
    /// Of two values each.
    Mixed,
    /// Of values with themselves; the second factor is the first.
    Squares,
}

impl Products {
    fn parallel(self, [a, b]: [&Sig; 2]) -> Sig {
        match self {
            Products::Mixed => a * b,
            Products::Squares => a.squared(),
        }
    }

    fn range(self, [a, b]: [Range; 2]) -> WideRange {
        match self {
            Products::Mixed => a.times(b),
            Products::Squares => a.squared(),
        }
    }

    fn rule(self, [a, b]: [RealId; 2]) -> Rule {
        match self {
            Products::Mixed => Rule::Product(a, b),
            Products::Squares => Rule::Square(a),
        }
    }

    /// The three products of these pairs.
    pub fn of(self, pairs: Pairs<'_>) -> ThreeProducts<'_> {
        let builder = &pairs[0][0].builder;
        let turns: Vec<usize> = (0..3).filter(|&k| builder.takes_a_turn(pairs[k])).collect();
        let begins = builder.state.borrow().begins();
        let mut in_turns = [None, None, None];
        if let Some(begins) = begins.filter(|_| turns.len() > 1) {
            let products = builder.in_turns(self, pairs, &turns, begins);
            turns.into_iter().zip(products).for_each(|(k, product)| in_turns[k] = Some(product));
        }
        ThreeProducts { products: self, pairs, in_turns }
    }
}

/// Three products: in turns where components take turns, or each of a multiplier of its own that is
/// there when the product is asked for.
pub(super) struct ThreeProducts<'a> {
    products: Products,
    pairs: Pairs<'a>,
    in_turns: [Option<Sig>; 3],
}

impl ThreeProducts<'_> {
    /// Product number `k`.
    pub fn get(&self, k: usize) -> Sig {
        self.in_turns[k].clone().unwrap_or_else(|| self.products.parallel(self.pairs[k]))
    }
}

impl Builder {
    /// Gives every pixel three clocks, in which the components of vectors take turns: from here on
    /// their products share a multiplier. All else is as of a pixel of one clock.
    pub fn component_turns(&self, control: &Control) -> TimeSlots {
        let [first_pixel, last] = self.third_slot(control);
        let valid_in_last_slot = self.without_registers(|| control.valid.and(&last));
        let valid_in_last_slot = valid_in_last_slot.named("valid_at_last");
        let mut state = self.state.borrow_mut();
        state.graph.interval = 3;
        state.graph.last_slot_only = true;
        state.graph.steps = valid_in_last_slot.id();
        state.begin_turns(valid_in_last_slot.id());
        drop(state);
        TimeSlots::one(first_pixel, valid_in_last_slot)
    }

    /// In a pixel's last time slot: whether the pixel is the first of its span; and whether this slot
    /// is a pixel's last. Bits move on with each clock in which something enters:
    ///
    /// ```text
    /// first ← last    second ← start or first    last ← second    begun ← start    first_pixel ← begun
    /// ```
    ///
    /// where what a span before has left is cleared by `start`.
    fn third_slot(&self, control: &Control) -> [Sig; 2] {
        let round = self.group([&control.start]);
        let bit = (Range::new(0, 1), 0);
        let registers = ["first", "second", "last", "begun", "first_pixel"].map(|name| {
            let register = self.loop_register(Pace::Slots, bit, round);
            (register, self.sig(register, Rule::Exact).named(name))
        });
        let [first, second, last, begun, first_pixel] =
            registers.each_ref().map(|(_, bit)| bit.clone());
        let start = &control.start;
        self.without_registers(|| {
            let zero = self.integer(0);
            let next = [
                start.choose(&zero, &last),
                start.or(&first),
                start.choose(&zero, &second),
                start.clone(),
                begun,
            ];
            registers.iter().zip(&next).for_each(|((of, _), next)| self.close_loop(*of, next));
        });
        [first_pixel, last]
    }

    /// Whether a product is worth a turn: that with a constant is none, and what is still has all
    /// the time there is.
    fn takes_a_turn(&self, pair: [&Sig; 2]) -> bool {
        let state = self.state.borrow();
        let constant = pair.iter().any(|factor| state.is_constant(factor.id()).is_some());
        let still = pair.iter().all(|factor| state.graph.is_still(factor.id()));
        !constant && !still && state.pace == Pace::Target
    }

    /// The products whose turns these are.
    fn in_turns(
        &self,
        products: Products,
        pairs: Pairs,
        turns: &[usize],
        begins: NodeId,
    ) -> Vec<Sig> {
        let points = [0, 1].map(|factor| {
            let points = turns.iter().map(|&turn| pairs[turn][factor].fraction_bits());
            points.max().unwrap_or(0)
        });
        let pairs: Vec<[Sig; 2]> = turns
            .iter()
            .map(|&turn| [0, 1].map(|k| pairs[turn][k].with_fraction_bits(points[k])))
            .collect();
        let factor = |k: usize| pairs.iter().map(|pair| pair[k].clone()).collect::<Vec<Sig>>();
        let first = self.in_turn(&factor(0), begins);
        let second = match products {
            Products::Mixed => self.in_turn(&factor(1), begins),
            Products::Squares => first,
        };
        let fraction_bits = points[0] + points[1];
        let own_ranges = pairs.iter().map(|pair| products.range(pair.each_ref().map(Sig::range)));
        let own_ranges: Vec<WideRange> = own_ranges.collect();
        let mut state = self.state.borrow_mut();
        let ranges = [first, second].map(|id| state.graph.value(id).range);
        let info = SignalInfo { range: products.range(ranges), fraction_bits, kind: "product" };
        let mut product = state.emit(Op::Mul(first, second), Pace::Target, info);
        let mut ids = vec![];
        for (turn, range) in own_ranges.into_iter().enumerate() {
            if turn > 0 {
                product = state.emit(Op::Copy(product), Pace::Ahead, info);
            }
            let info = SignalInfo { range, ..info };
            ids.push(state.emit(Op::Wrap(product), Pace::Wire, info));
        }
        drop(state);
        let of = |(id, pair): (NodeId, &[Sig; 2])| {
            Sig::new(self, (id, fraction_bits), products.rule([pair[0].real(), pair[1].real()]))
        };
        ids.into_iter().zip(&pairs).map(of).collect()
    }

    /// The value whose turn it is, of two or three.
    fn in_turn(&self, values: &[Sig], begins: NodeId) -> NodeId {
        let mut state = self.state.borrow_mut();
        let waiting: Vec<NodeId> = values
            .iter()
            .zip(0..)
            .map(|(value, clocks)| state.waiting(value.id(), clocks))
            .collect();
        let fraction_bits = values[0].fraction_bits();
        let (last, others) = waiting.split_last().expect("there are two or three");
        let mut chosen = *last;
        for (turn, &value) in others.iter().enumerate().rev() {
            let begins = state.waiting(begins, turn as u32);
            let ranges = [value, chosen].map(|id| state.graph.value(id).range);
            let range = ranges[0].hull(ranges[1]).into();
            let info = SignalInfo { range, fraction_bits, kind: "turn" };
            let pace = if turn == 0 { Pace::Target } else { Pace::Wire };
            chosen = state.emit(Op::Select(begins, value, chosen), pace, info);
        }
        chosen
    }
}
