//! Random netlists in every engine, on every signal and clock, against a plain interpreter.
//!
//! Netlists are drawn as `Design`s, not through the builder, so that engines see whatever the type
//! allows: operands of different stages, registers that read later signals, ranges looser than need
//! be. What fails is made small and printed as text; as a file in `sim/tests/regressions/` it is
//! replayed first from then on.
mod case;
mod check;
mod draw;
mod interpret;
mod minimise;
mod profile;
mod regressions;
mod text;
mod verilog;

use specula_fixtures::Draw;

use case::{Case, Subject};
use profile::Profile;

/// Draws so many netlists and checks each in several ways; what fails is made small and shown.
fn hunt(seed: u64, netlists: u64, profile: impl Fn(u64) -> Profile) {
    let (mut nodes, mut clocks, mut runs) = (0, 0, 0);
    for number in 0..netlists {
        let own_seed = seed.wrapping_mul(1_000_003).wrapping_add(number);
        let mut draw = Draw::new(own_seed);
        let case = draw::case(&mut draw, profile(number));
        let expected = case.expected().unwrap_or_else(|untrue| {
            panic!("netlist {number}: the drawn netlist is wrong: {untrue}")
        });
        let views = check::views(&case, &mut draw);
        (nodes, clocks, runs) =
            (nodes + case.design.nodes.len(), clocks + expected[0].len(), runs + views.len());
        for view in views {
            if let Some(failure) = check::failure(&view) {
                let small = minimise::minimised(view);
                let now = check::failure(&small).map_or_else(String::new, |f| f.to_string());
                panic!("seed {own_seed}: {failure}\nmade small: {now}\n\n{}", text::print(&small));
            }
        }
    }
    println!("{netlists} netlists, {nodes} signals, {clocks} clocks, {runs} runs");
}

/// The seed to begin with: the same every time, unless `SPECULA_SEED` names another to hunt
/// further.
fn seed(usual: u64) -> u64 {
    std::env::var("SPECULA_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

#[test]
fn small_netlists_give_what_the_interpreter_gives() {
    hunt(seed(20_260_101), 4000, Profile::small);
}

#[test]
fn large_netlists_give_what_the_interpreter_gives() {
    hunt(seed(7), 300, Profile::large);
}

/// Runs that cross the borders of the largest batches.
#[test]
fn long_runs_give_what_the_interpreter_gives() {
    hunt(seed(1993), 150, Profile::long);
}

#[test]
fn known_failures_do_not_come_back() {
    regressions::replay(|case: &Case| check::failure(case).map(|failure| failure.to_string()));
}

/// The text of a netlist gives the same netlist.
#[test]
fn text_is_read_as_it_was_written() {
    for seed in 0..200 {
        let mut draw = Draw::new(seed);
        let case =
            Case { subject: Subject::RustHdl, ..draw::case(&mut draw, Profile::small(seed)) };
        let written = text::print(&case);
        let read = text::parse(&written).unwrap();
        assert_eq!(text::print(&read), written, "seed {seed}");
        assert_eq!(
            (read.expected(), read.design.tables),
            (case.expected(), case.design.tables),
            "seed {seed}"
        );
    }
}
