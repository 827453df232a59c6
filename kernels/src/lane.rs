//! Lanes of 32 and 64 bits.

/// A lane: a two's complement number whose operations wrap around.
pub trait Lane: Copy + Default + Ord + Send + Sync + 'static {
    /// Width in bits.
    const BITS: u32;
    /// The low bits of a 64-bit number.
    fn from_i64(value: i64) -> Self;
    /// The number, sign extended.
    fn to_i64(self) -> i64;
    /// Sum.
    fn plus(self, other: Self) -> Self;
    /// Difference.
    fn minus(self, other: Self) -> Self;
    /// Product.
    fn times(self, other: Self) -> Self;
    /// Bitwise AND.
    fn and(self, other: Self) -> Self;
    /// Bitwise exclusive OR.
    fn xor(self, other: Self) -> Self;
    /// Arithmetic shift right: the sign is filled in.
    fn right(self, bits: u32) -> Self;
    /// Logical shift right: zeros are filled in.
    fn right_zero(self, bits: u32) -> Self;
}

macro_rules! lane {
    ($signed:ty, $unsigned:ty) => {
        impl Lane for $signed {
            const BITS: u32 = <$signed>::BITS;
            #[inline(always)]
            fn from_i64(value: i64) -> Self {
                value as $signed
            }
            #[inline(always)]
            fn to_i64(self) -> i64 {
                self as i64
            }
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            #[inline(always)]
            fn times(self, other: Self) -> Self {
                self.wrapping_mul(other)
            }
            #[inline(always)]
            fn and(self, other: Self) -> Self {
                self & other
            }
            #[inline(always)]
            fn xor(self, other: Self) -> Self {
                self ^ other
            }
            #[inline(always)]
            fn right(self, bits: u32) -> Self {
                self.wrapping_shr(bits)
            }
            #[inline(always)]
            fn right_zero(self, bits: u32) -> Self {
                (self as $unsigned).wrapping_shr(bits) as $signed
            }
        }
    };
}

lane!(i32, u32);
lane!(i64, u64);
