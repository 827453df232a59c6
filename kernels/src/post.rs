//! What is done to a raw result before it is stored: bits are dropped on the left, on the right,
//! and on the left again.
use std::marker::PhantomData;

use crate::Lane;

/// Bits dropped on the right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shift {
    /// No bits are dropped.
    #[default]
    None,
    /// ⌊x / 2^k⌋.
    Floor(u32),
    /// ⌊(⌊x / 2^k⌋ + 1) / 2⌋, with k up to 61: k + 1 bits dropped, rounding to nearest with ties
    /// up.
    Round(u32),
}

/// Bits dropped on the left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// No bits are dropped.
    #[default]
    None,
    /// As many low bits as this stay, read in two's complement.
    Signed(u32),
    /// As many low bits as this stay, read as unsigned; fewer than the lane has.
    Unsigned(u32),
}

/// The steps between a raw result and what is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Post {
    /// First, a constant is added.
    pub plus: i64,
    /// Second, bits are dropped on the left.
    pub first: Wrap,
    /// Third, bits are dropped on the right.
    pub shift: Shift,
    /// Last, bits are dropped on the left.
    pub wrap: Wrap,
}

impl Shift {
    /// The shift as (half, bits) of ⌊(x + half) / 2^bits⌋: where it rounds, `half` is half a unit
    /// of the last place that stays.
    fn parts(self) -> (i64, u32) {
        match self {
            Shift::None => (0, 0),
            Shift::Floor(bits) => (0, bits),
            // ⌊(⌊x / 2^k⌋ + 1) / 2⌋ = ⌊(x + 2^k) / 2^(k+1)⌋.
            Shift::Round(bits) => (1 << bits, bits + 1),
        }
    }
}

impl Wrap {
    /// The mask of the bits that stay, and the one of them that counts as negative: the wrapped
    /// value is `((x & mask) ^ sign) - sign`.
    fn parts(self) -> (i64, i64) {
        let low = |width: u32| (u64::MAX >> (64 - width)) as i64;
        match self {
            Wrap::None => (-1, 0),
            Wrap::Signed(width) => (low(width), 1 << (width - 1)),
            Wrap::Unsigned(width) => (low(width), 0),
        }
    }
}

impl Post {
    /// What rounding adds to a result before bits are dropped: the lane that computes must have
    /// room for it.
    pub fn half(self) -> i64 {
        self.shift.parts().0
    }

    /// The kind of loop that takes these steps from lanes `C` to lanes `O`.
    pub(crate) fn kind<C: Lane, O: Lane>(self) -> Kind {
        let bits = self.shift.parts().1;
        if self.first == Wrap::None && self.shift == Shift::None && self.plus == 0 {
            return Kind::Plain;
        }
        // A narrower lane may store bits of the quotient alone; then it does not matter what is
        // filled in on the left, and zeros cost less.
        let fill =
            if O::BITS < C::BITS && bits <= C::BITS - O::BITS { Fill::Zero } else { Fill::Sign };
        if self.first == Wrap::None { Kind::Shifted(fill) } else { Kind::WrappedAndShifted(fill) }
    }

    pub(crate) fn wraps(self) -> bool {
        self.wrap != Wrap::None
    }

    pub(crate) fn amounts<C: Lane>(self) -> Amounts {
        let ((half, bits), (mask, sign), (last_mask, last_sign)) =
            (self.shift.parts(), self.first.parts(), self.wrap.parts());
        let plus = if self.first == Wrap::None { 0 } else { self.plus };
        Amounts {
            plus,
            mask,
            sign,
            offset: (self.plus - plus).wrapping_add(half).wrapping_sub(sign),
            // Shifting all bits out leaves the sign, as shifting all but one does; processors would
            // take the amount modulo the lane.
            bits: bits.min(C::BITS - 1),
            last_mask,
            last_sign,
        }
    }
}

/// What a shift fills in on the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fill {
    Sign,
    Zero,
}

/// A kind of loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Plain,
    Shifted(Fill),
    WrappedAndShifted(Fill),
}

/// The constants of a loop's steps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Amounts {
    plus: i64,
    mask: i64,
    sign: i64,
    /// What is added before the shift: half a unit where it rounds, plus the constant if nothing is
    /// wrapped before the shift, less the sign bit if something is.
    offset: i64,
    bits: u32,
    last_mask: i64,
    last_sign: i64,
}

/// The steps from a raw result in lanes `C` to what is stored in lanes `O`, as a type, so that each
/// kind has a loop of its own.
pub(crate) trait Finish {
    fn apply<C: Lane, O: Lane>(raw: C, amounts: &Amounts) -> O;
}

/// A shift as a type.
pub(crate) trait ShiftKind {
    fn apply<C: Lane>(value: C, bits: u32) -> C;
}

pub(crate) struct SignFilled;
pub(crate) struct ZeroFilled;
pub(crate) struct Plain;
pub(crate) struct Shifted<S>(PhantomData<S>);
pub(crate) struct WrappedAndShifted<S>(PhantomData<S>);
/// Wraps the result of `F`.
pub(crate) struct Wrapped<F>(PhantomData<F>);

impl ShiftKind for SignFilled {
    #[inline(always)]
    fn apply<C: Lane>(value: C, bits: u32) -> C {
        value.right(bits)
    }
}

impl ShiftKind for ZeroFilled {
    #[inline(always)]
    fn apply<C: Lane>(value: C, bits: u32) -> C {
        value.right_zero(bits)
    }
}

impl Finish for Plain {
    #[inline(always)]
    fn apply<C: Lane, O: Lane>(raw: C, _: &Amounts) -> O {
        O::from_i64(raw.to_i64())
    }
}

impl<S: ShiftKind> Finish for Shifted<S> {
    #[inline(always)]
    fn apply<C: Lane, O: Lane>(raw: C, amounts: &Amounts) -> O {
        O::from_i64(S::apply(raw.plus(C::from_i64(amounts.offset)), amounts.bits).to_i64())
    }
}

impl<S: ShiftKind> Finish for WrappedAndShifted<S> {
    #[inline(always)]
    fn apply<C: Lane, O: Lane>(raw: C, amounts: &Amounts) -> O {
        let low = raw
            .plus(C::from_i64(amounts.plus))
            .and(C::from_i64(amounts.mask))
            .xor(C::from_i64(amounts.sign));
        O::from_i64(S::apply(low.plus(C::from_i64(amounts.offset)), amounts.bits).to_i64())
    }
}

impl<F: Finish> Finish for Wrapped<F> {
    #[inline(always)]
    fn apply<C: Lane, O: Lane>(raw: C, amounts: &Amounts) -> O {
        let value: O = F::apply(raw, amounts);
        let sign = O::from_i64(amounts.last_sign);
        value.and(O::from_i64(amounts.last_mask)).xor(sign).minus(sign)
    }
}
