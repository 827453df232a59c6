//! Mistakes in using the builder are errors that name the unit and the signal.

use specula_datapath::builder::{BuildError, Builder, LoopInvariant, Sig};
use specula_datapath::{Format, InputPort};

const FORMAT: Format = Format::signed(1, 6);

fn opened() -> (Builder, Sig, Sig, Sig) {
    let builder = Builder::new("bench", "");
    let control = builder.control();
    let x = builder.input(&InputPort::whole("x", FORMAT));
    (builder, control.valid, control.start, x)
}

#[track_caller]
fn says(result: Result<impl Sized, BuildError>, text: &str) {
    assert_eq!(result.err().map(|error| error.to_string()).as_deref(), Some(text));
}

#[test]
fn a_signal_is_no_wider_than_63_bits() {
    let (builder, valid, _, x) = opened();
    let mut power = x;
    for _ in 0..4 {
        power = builder.unit("square", "x x", (("x", &power),), |_, (x,)| x.squared());
    }
    let result = builder.finish(&valid, &[("power", power)]);
    says(
        result,
        "signal `bench.square_4.product_1` needs 113 bits, and the most is 63: give the narrowing \
         points before it fewer fraction bits",
    );
}

#[test]
fn a_unit_takes_no_value_out_of_another_unit() {
    let (builder, valid, _, x) = opened();
    let mut smuggled = None;
    let y = builder.unit("inner", "x + x x", (("x", &x),), |_, (x,)| {
        let square = x.squared().named("square");
        smuggled = Some(square.clone());
        square + x
    });
    let z = smuggled.map(|square| builder.unit("outer", "", (("s", &square),), |_, (s,)| -s));
    let result = builder.finish(&valid, &[("y", y), ("z", z.expect("the unit was opened"))]);
    says(
        result,
        "input `s` of unit `bench.outer` is `bench.inner.square`, which belongs to another unit: \
         make it an output of that unit first",
    );
}

#[test]
fn a_unit_gives_no_value_from_around_it() {
    let (builder, valid, _, x) = opened();
    let square = x.squared().named("square");
    let y = builder.unit("identity", "", (("x", &x),), |_, _| square.clone());
    says(
        builder.finish(&valid, &[("y", y)]),
        "unit `bench.identity` gives `bench.square`, which belongs to another unit: make it an \
         input of the unit first",
    );
}

#[test]
fn an_address_is_not_negative() {
    let (builder, valid, _, x) = opened();
    let entry = x.looked_up(vec![1, 2, 3], 0, 0.0);
    says(
        builder.finish(&valid, &[("entry", entry)]),
        "a table is read at `bench.x`, which can be negative: addresses are unsigned",
    );
}

#[test]
fn a_loop_keeps_its_binary_point() {
    let (builder, valid, start, x) = opened();
    let invariant = LoopInvariant { limits: (-2.0, 2.0), fact: "it stays", error: 1.0 };
    let [y] = builder.recurrence(&start, [&x], 6, &invariant, |[y]| [y.halved()]);
    says(
        builder.finish(&valid, &[("y", y)]),
        "the loop through `bench.state` begins with 6 fraction bits and goes on with 7: round what \
         follows",
    );
}

#[test]
fn a_loop_reads_nothing_that_comes_after_its_clock() {
    let (builder, valid, start, x) = opened();
    let late = x.squared().rounded(6).clamped_above(1);
    let invariant = LoopInvariant { limits: (-2.0, 2.0), fact: "it stays", error: 1.0 };
    let [y] = builder.recurrence(&start, [&x], 6, &invariant, |[y]| {
        [(y + &late).clamped_above(1).clamped_below(-1)]
    });
    let error = builder.finish(&valid, &[("y", y)]).err().map(|error| error.to_string());
    let error = error.expect("the loop is late");
    assert!(error.starts_with("the loop through `bench.state` reads a value that is"), "{error}");
}
