//! Products with constants as sums of shifted values, by signed digits: those of the canonical form,
//! of which no two neighbours are there, and of which there are on average as many as a third of the
//! constant's bits [Reitwiesner 1960].
use super::{Lowering, Place, narrowed};
use crate::design::{NodeId, Op, Range};

/// A part of the sum: a value times 2^shift, added or subtracted.
#[derive(Clone, Copy)]
struct Term {
    value: NodeId,
    /// The value is the variable times this.
    factor: i64,
    shift: u32,
    negative: bool,
}

impl Lowering<'_> {
    /// The variable times a constant that is not 0; none if a partial sum were too wide.
    pub(super) fn times_constant(
        &mut self,
        at: Place,
        variable: NodeId,
        constant: i64,
        range: Range,
    ) -> Option<Op> {
        let fits = range.times(Range::single(1)).width() < 60;
        let mut terms: Vec<Term> = digits(constant)
            .into_iter()
            .map(|(shift, negative)| Term { value: variable, factor: 1, shift, negative })
            .collect();
        while terms.len() > 2 && fits {
            let pairs: Vec<Vec<Term>> = terms.chunks(2).map(<[Term]>::to_vec).collect();
            terms = pairs
                .into_iter()
                .map(|pair| match pair[..] {
                    [low, high] => self.combined(at, variable, low, high),
                    _ => pair[0],
                })
                .collect();
        }
        match terms[..] {
            [only] => Some(self.signed(at, only, range)),
            [low, high] if fits && low.negative && !high.negative => {
                Some(self.difference(at, [high, low], range))
            }
            [low, high] if fits => {
                let sum = self.combined(at, variable, low, high);
                Some(self.signed(at, sum, range))
            }
            _ => None,
        }
    }

    /// A term with its shift and its sign.
    fn signed(&mut self, at: Place, term: Term, range: Range) -> Op {
        let shifted = self.shifted(at, term.value, term.shift);
        if !term.negative {
            return Op::Copy(shifted);
        }
        let zero = self.integer(at, 0);
        Op::Copy(self.new_sum(at, Op::Sub(zero, shifted), range, "negative"))
    }

    /// A term less another of a smaller shift: an adder of all bits, but none for the sign behind it.
    fn difference(&mut self, at: Place, terms: [Term; 2], range: Range) -> Op {
        let [a, b] = terms.map(|term| self.shifted(at, term.value, term.shift));
        Op::Copy(self.new_sum(at, Op::Sub(a, b), range, "digits"))
    }

    /// Two terms as one, the first of which has the smaller shift.
    fn combined(&mut self, at: Place, variable: NodeId, low: Term, high: Term) -> Term {
        let distance = high.shift - low.shift;
        let shifted = self.shifted(at, high.value, distance);
        let signed = |term: &Term| if term.negative { -term.factor } else { term.factor };
        let sum = signed(&low) + (signed(&high) << distance);
        let (op, factor, negative) = match (low.negative, high.negative) {
            (false, false) => (Op::Add(low.value, shifted), sum, false),
            (true, true) => (Op::Add(low.value, shifted), -sum, true),
            (false, true) => (Op::Sub(low.value, shifted), sum, false),
            (true, false) => (Op::Sub(low.value, shifted), -sum, true),
        };
        let shift = low.shift;
        // Constants of one variable share what they have in common.
        if let Some(&value) = self.multiples.get(&(at.scope, variable, factor)) {
            return Term { value, factor, shift, negative };
        }
        // A part of a product that fits 60 bits.
        let range = narrowed(self.range(variable).times(Range::single(factor)));
        let value = self.new_sum(at, op, range, "digits");
        self.multiples.insert((at.scope, variable, factor), value);
        Term { value, factor, shift, negative }
    }
}

/// The canonical signed digits of a number that are not 0: place, and whether negative, from the
/// lowest on.
pub(super) fn digits(number: i64) -> Vec<(u32, bool)> {
    let (mut rest, mut place, mut digits) = (i128::from(number), 0, vec![]);
    while rest != 0 {
        if rest & 1 == 1 {
            // 1 where the next bit is 0, -1 where it is 1.
            let digit = 2 - (rest & 3);
            digits.push((place, digit < 0));
            rest -= digit;
        }
        rest >>= 1;
        place += 1;
    }
    digits
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn signed_digits_make_the_number_and_have_no_neighbours() {
        for number in -5000..=5000_i64 {
            let digits = digits(number);
            let sum: i64 =
                digits.iter().map(|&(at, minus)| if minus { -(1 << at) } else { 1 << at }).sum();
            assert_eq!(sum, number);
            assert!(digits.windows(2).all(|pair| pair[1].0 > pair[0].0 + 1), "{number}");
        }
    }
}
