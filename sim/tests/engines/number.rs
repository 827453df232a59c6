//! Fixed-point numbers as they are meant, in 128 bits: the operators' meaning, written without
//! looking at the hardware's.

/// `raw` · 2^-`fraction_bits`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Number {
    pub raw: i128,
    pub fraction_bits: u32,
}

impl Number {
    pub fn integer(value: i64) -> Number {
        Number { raw: value.into(), fraction_bits: 0 }
    }

    pub fn bit(set: bool) -> Number {
        Number::integer(set.into())
    }

    pub fn is_set(self) -> bool {
        self.raw != 0
    }

    /// Both raw numbers, counted in the finer unit of the two, and that unit's fraction bits.
    fn in_one_unit(self, other: Number) -> (i128, i128, u32) {
        let fraction_bits = self.fraction_bits.max(other.fraction_bits);
        let raw = |n: Number| n.raw * (1 << (fraction_bits - n.fraction_bits));
        (raw(self), raw(other), fraction_bits)
    }

    pub fn plus(self, other: Number) -> Number {
        let (a, b, fraction_bits) = self.in_one_unit(other);
        Number { raw: a + b, fraction_bits }
    }

    pub fn minus(self, other: Number) -> Number {
        let (a, b, fraction_bits) = self.in_one_unit(other);
        Number { raw: a - b, fraction_bits }
    }

    pub fn times(self, other: Number) -> Number {
        Number {
            raw: self.raw * other.raw,
            fraction_bits: self.fraction_bits + other.fraction_bits,
        }
    }

    pub fn times_power_of_two(self, exponent: i32) -> Number {
        let fraction_bits = self.fraction_bits as i32 - exponent;
        match u32::try_from(fraction_bits) {
            Ok(fraction_bits) => Number { fraction_bits, ..self },
            Err(_) => Number { raw: self.raw * (1 << -fraction_bits), fraction_bits: 0 },
        }
    }

    /// The largest number of `fraction_bits` that is not above it.
    pub fn floor(self, fraction_bits: u32) -> Number {
        match self.fraction_bits.checked_sub(fraction_bits) {
            Some(dropped) => Number { raw: self.raw.div_euclid(1 << dropped), fraction_bits },
            None => self,
        }
    }

    /// The nearest number of `fraction_bits`, ties up.
    pub fn nearest(self, fraction_bits: u32) -> Number {
        let half = Number { raw: 1, fraction_bits: fraction_bits + 1 };
        if self.fraction_bits > fraction_bits { self.plus(half).floor(fraction_bits) } else { self }
    }

    pub fn less_than(self, other: Number) -> bool {
        let (a, b, _) = self.in_one_unit(other);
        a < b
    }

    /// The larger, in the unit of `self`; `limit` is an integer.
    pub fn at_least(self, limit: i64) -> Number {
        let limit = i128::from(limit) * (1 << self.fraction_bits);
        Number { raw: self.raw.max(limit), ..self }
    }

    /// The smaller, in the unit of `self`; `limit` is an integer.
    pub fn at_most(self, limit: i64) -> Number {
        let limit = i128::from(limit) * (1 << self.fraction_bits);
        Number { raw: self.raw.min(limit), ..self }
    }

    /// One of the two, in the finer unit of both.
    pub fn either(first: bool, a: Number, b: Number) -> Number {
        let (a, b, fraction_bits) = a.in_one_unit(b);
        Number { raw: if first { a } else { b }, fraction_bits }
    }

    /// The number with these low bits: in 0..2^width, or in -2^(width-1)..2^(width-1) if signed.
    pub fn low_bits(self, width: u32, signed: bool) -> Number {
        let modulus = 1i128 << width;
        let lowest = if signed { -(modulus / 2) } else { 0 };
        Number { raw: (self.raw - lowest).rem_euclid(modulus) + lowest, ..self }
    }
}
