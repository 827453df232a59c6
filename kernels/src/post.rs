//! What happens to a raw result before it is stored: bits dropped on the right, then bits dropped on the left.
use crate::Lane;

/// Bits dropped on the right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shift {
    /// None.
    #[default]
    None,
    /// ⌊x / 2^k⌋.
    Floor(u32),
    /// ⌊(⌊x / 2^k⌋ + 1) / 2⌋: k + 1 bits dropped, rounding to nearest with ties up.
    Round(u32),
}

/// Bits dropped on the left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// None.
    #[default]
    None,
    /// The low bits, as many as this, in two's complement.
    Signed(u32),
    /// The low bits, as many as this, not negative; fewer than the lane has.
    Unsigned(u32),
}

/// What happens to a raw result before it is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Post {
    /// First, bits dropped on the right.
    pub shift: Shift,
    /// Then, bits dropped on the left.
    pub wrap: Wrap,
}

/// A kind of [`Shift`] as a type, so that each kind has a loop of its own.
pub(crate) trait ShiftKind {
    fn apply<L: Lane>(value: L, bits: u32) -> L;
}

/// A kind of [`Wrap`] as a type.
pub(crate) trait WrapKind {
    fn apply<L: Lane>(value: L, unused: u32) -> L;
}

pub(crate) struct Keep;
pub(crate) struct Floor;
pub(crate) struct Round;
pub(crate) struct Signed;
pub(crate) struct Unsigned;

impl ShiftKind for Keep {
    #[inline(always)]
    fn apply<L: Lane>(value: L, _: u32) -> L {
        value
    }
}

impl ShiftKind for Floor {
    #[inline(always)]
    fn apply<L: Lane>(value: L, bits: u32) -> L {
        value.right(bits)
    }
}

impl ShiftKind for Round {
    #[inline(always)]
    fn apply<L: Lane>(value: L, bits: u32) -> L {
        value.right(bits).plus(L::from_i64(1)).right(1)
    }
}

impl WrapKind for Keep {
    #[inline(always)]
    fn apply<L: Lane>(value: L, _: u32) -> L {
        value
    }
}

impl WrapKind for Signed {
    #[inline(always)]
    fn apply<L: Lane>(value: L, unused: u32) -> L {
        value.left(unused).right(unused)
    }
}

impl WrapKind for Unsigned {
    #[inline(always)]
    fn apply<L: Lane>(value: L, unused: u32) -> L {
        value.left(unused).right_zero(unused)
    }
}

/// The numbers that go with the kinds.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Amounts {
    pub shift: u32,
    /// Bits of the computing lane that wrapping does not keep.
    pub unused: u32,
}

impl Post {
    pub(crate) fn amounts(self, lane_bits: u32) -> Amounts {
        let shift = match self.shift {
            Shift::None => 0,
            // Shifting all bits out leaves the sign, as shifting all but one does; processors would take the amount modulo the lane.
            Shift::Floor(bits) | Shift::Round(bits) => bits.min(lane_bits - 1),
        };
        let unused = match self.wrap {
            Wrap::None => 0,
            Wrap::Signed(width) | Wrap::Unsigned(width) => lane_bits - width,
        };
        Amounts { shift, unused }
    }
}
