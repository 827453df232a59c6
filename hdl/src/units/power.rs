//! Powers by squaring.
use super::shape::square;
use crate::builder::{Builder, Sig};

/// base^(2^j) for j = `log2_exponent`, 0 to `most_squarings`: each stage squares where j asks for it, else passes on.
/// [Hast et al.; METHODS C3]
///
/// Each squaring doubles the error of a base in [0, 1] and adds half a unit of the last place.
pub fn power(b: &Builder, base: &Sig, log2_exponent: &Sig, most_squarings: u32, fraction_bits: u32) -> Sig {
    b.unit("power", "f = b^n, n = 2^j, by squaring", (("base", base), ("j", log2_exponent)), |b, (base, j)| {
        let mut f = base;
        for done in 0..most_squarings {
            let squared = square(b, &f, fraction_bits);
            f = b.integer(i64::from(done)).less_than(&j).choose(&squared, &f);
        }
        f.named("f")
    })
}
