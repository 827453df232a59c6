//! Products, and sums of them, with all steps that can follow them before they are stored.
use proptest::prelude::*;
use specula_kernels::{
    InstructionSet, Lane, Magnitude, Post, Products, Second, narrow_products,
    products_through_wide, wide_products,
};

use crate::arithmetic::{finished, fits, posts};
use crate::lanes::{LONGEST, column, in_lanes, instruction_sets, numbers, unfilled};

/// The factors of up to three products.
type Columns = [[Vec<i64>; 2]; 3];

fn columns(bits: u32) -> impl Strategy<Value = Columns> {
    let pair = move || [column(bits), column(bits)];
    [pair(), pair(), pair()]
}

fn sum(second: Second, products: &[i128]) -> i128 {
    let sign = |number: usize| if number == 1 && second == Second::Subtracted { -1 } else { 1 };
    products.iter().enumerate().map(|(number, product)| sign(number) * product).sum()
}

/// Compares a kernel that computes in so many bits with the exact results, at both instruction_sets. Lanes
/// whose sum does not fit are set to 0.
fn check<O: Lane, const N: usize>(
    kernel: impl Fn(Second, Post, InstructionSet) -> Products<O, N>,
    computed: u32,
    post: Post,
    lanes: usize,
    columns: &Columns,
) {
    for second in [Second::Added, Second::Subtracted] {
        let mut factors: [[Vec<i64>; 2]; N] = std::array::from_fn(|j| columns[j].clone());
        let mut expected = vec![];
        for lane in 0..lanes {
            let products =
                factors.each_ref().map(|[a, b]| i128::from(a[lane]) * i128::from(b[lane]));
            let result = |products: &[i128]| {
                finished(post, computed, sum(second, products))
                    .filter(|&result| fits(O::BITS, result))
            };
            expected.push(result(&products).unwrap_or_else(|| {
                factors.iter_mut().for_each(|[a, _]| a[lane] = 0);
                result(&[0; N]).expect("what becomes of 0 fits")
            }));
        }
        let factors = factors.map(|pair| pair.map(|column| in_lanes::<i32>(&column)));
        for instruction_set in instruction_sets() {
            let mut out = unfilled::<O>(lanes);
            kernel(second, post, instruction_set)
                .run(&mut out, factors.each_ref().map(|pair| pair.each_ref().map(Vec::as_slice)));
            let got: Vec<i128> = numbers(&out).into_iter().map(i128::from).collect();
            assert_eq!(got, expected, "{second:?} {post:?} {}", instruction_set.name());
        }
    }
}

fn through_wide<const N: usize>(magnitude: Magnitude, post: Post, lanes: usize, columns: &Columns) {
    check(
        |second, post, instruction_set| {
            products_through_wide::<N>(second, magnitude, post, instruction_set)
        },
        64,
        post,
        lanes,
        columns,
    );
}

fn wide<const N: usize>(magnitude: Magnitude, post: Post, lanes: usize, columns: &Columns) {
    check(
        |second, post, instruction_set| {
            wide_products::<N>(second, magnitude, post, instruction_set)
        },
        64,
        post,
        lanes,
        columns,
    );
}

proptest! {
    #[test]
    fn in_narrow_lanes(post in posts(32, 32), lanes in 0..=LONGEST, columns in prop_oneof![columns(15), columns(20), columns(32)]) {
        check(narrow_products::<1>, 32, post, lanes, &columns);
        check(narrow_products::<2>, 32, post, lanes, &columns);
        check(narrow_products::<3>, 32, post, lanes, &columns);
    }

    #[test]
    fn through_wide_lanes(post in posts(64, 32), lanes in 0..=LONGEST, columns in prop_oneof![columns(20), columns(32)]) {
        through_wide::<1>(Magnitude::Any, post, lanes, &columns);
        through_wide::<2>(Magnitude::Any, post, lanes, &columns);
        through_wide::<3>(Magnitude::Any, post, lanes, &columns);
    }

    #[test]
    fn in_wide_lanes(post in posts(64, 64), lanes in 0..=LONGEST, columns in prop_oneof![columns(20), columns(32)]) {
        wide::<1>(Magnitude::Any, post, lanes, &columns);
        wide::<2>(Magnitude::Any, post, lanes, &columns);
        wide::<3>(Magnitude::Any, post, lanes, &columns);
    }

    /// Three products of 25-bit numbers are 3 · 2^48 at most, less than the limit of 2^51.
    #[test]
    fn up_to_51_bits(narrow in posts(64, 32), stored in posts(64, 64), lanes in 0..=LONGEST, columns in prop_oneof![columns(20), columns(25)]) {
        through_wide::<1>(Magnitude::UpTo51Bits, narrow, lanes, &columns);
        through_wide::<2>(Magnitude::UpTo51Bits, narrow, lanes, &columns);
        through_wide::<3>(Magnitude::UpTo51Bits, narrow, lanes, &columns);
        wide::<1>(Magnitude::UpTo51Bits, stored, lanes, &columns);
        wide::<2>(Magnitude::UpTo51Bits, stored, lanes, &columns);
        wide::<3>(Magnitude::UpTo51Bits, stored, lanes, &columns);
    }
}

/// Tests the largest magnitudes for which floating point is used, and their neighbours.
#[test]
fn the_limit_of_51_bits() {
    let factors = [1 << 25, -(1 << 25), (1 << 25) - 1, 1 - (1 << 25), (1 << 24) + 1, 0, 1, -1];
    let pairs: Vec<[i64; 2]> = factors.iter().flat_map(|&a| factors.map(|b| [a, b])).collect();
    let side = |k: usize| pairs.iter().map(|pair| pair[k]).collect::<Vec<_>>();
    let columns: Columns = std::array::from_fn(|_| [side(0), side(1)]);
    // The sum or the difference of two products of 2^50 each is 2^51.
    wide::<1>(Magnitude::UpTo51Bits, Post::default(), pairs.len(), &columns);
    wide::<2>(Magnitude::UpTo51Bits, Post::default(), pairs.len(), &columns);
}
