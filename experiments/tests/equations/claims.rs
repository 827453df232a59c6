//! Every claim that `specula reproduce` gives a verdict on has a row, whose verdict is the one it
//! gives, and the other way about.
use std::collections::BTreeMap;

use specula_experiments::reproduce::{ClaimVerdict, Paper, Ruling, gates, project};

use super::figures::numbers;
use super::table;

/// What papers number in their text, as they state it, and how many of it they have: §2.1 of
/// Reshetov, Soupikov and Mark.
const NUMBERED: [(&str, &str, u32); 1] = [("Reshetov", "goal", 7)];

/// A claim's paper and text, with its verdict and the command that gives it.
type Rows = BTreeMap<[String; 2], [String; 2]>;

fn rows() -> Rows {
    let mut rows = Rows::new();
    for cells in table("| paper | where in it | claim | verdict | given by |") {
        let [paper, _, claim, verdict, command] = cells.try_into().expect("five columns");
        let twice = rows.insert([paper, claim], [verdict, command]);
        assert_eq!(twice, None);
    }
    rows
}

/// What papers are called in tables.
fn name(paper: Paper) -> String {
    match paper {
        Paper::Lyon => "Lyon",
        Paper::Hast => "Hast",
        Paper::Lecture => "lecture",
        Paper::Reshetov => "Reshetov",
    }
    .to_owned()
}

fn in_words(ruling: Ruling) -> &'static str {
    match ruling {
        Ruling::Holds => "holds",
        Ruling::HoldsWithin(_) => "holds within limits",
        Ruling::DoesNotHold(_) => "does not hold",
    }
}

/// The claims that are measured on this machine alone, each verdict once.
fn measured() -> Rows {
    let mut claims: BTreeMap<[String; 2], Vec<&str>> = BTreeMap::new();
    for ClaimVerdict { paper, claim, ruling, .. } in
        Paper::ALL.into_iter().flat_map(Paper::verdicts)
    {
        let verdicts = claims.entry([name(paper), claim.to_owned()]).or_default();
        if !verdicts.contains(&in_words(ruling)) {
            verdicts.push(in_words(ruling));
        }
    }
    let row = |([paper, claim], verdicts): ([String; 2], Vec<&str>)| {
        let command = format!("`specula reproduce {}`", paper.to_lowercase());
        ([paper, claim], [verdicts.join(", "), command])
    };
    claims.into_iter().map(row).collect()
}

/// Those that take a clock or a synthesiser. Lyon's conclusion is what gates are counted for, and
/// what he does not claim of them has no paper.
fn of_other_commands() -> Rows {
    let speeds = project::CLAIMS.iter().map(|claim| {
        let verdict = "in [project.md](project.md)".to_owned();
        let command = "`specula reproduce project`".to_owned();
        ([name(claim.paper), claim.what.to_owned()], [verdict, command])
    });
    let sizes = gates::CLAIMS.iter().filter(|claim| !claim.what.is_empty()).map(|claim| {
        let verdict = "in [gates.md](gates.md)".to_owned();
        let command = "`specula reproduce gates`".to_owned();
        let paper = if claim.what.contains("not a claim") { "–" } else { "Lyon" };
        ([paper.to_owned(), claim.what.to_owned()], [verdict, command])
    });
    speeds.chain(sizes).collect()
}

#[test]
fn every_claim_has_a_row_with_its_verdict() {
    let mut given = measured();
    given.extend(of_other_commands());
    let there = rows();
    let absent: Vec<_> = given.iter().filter(|(claim, _)| !there.contains_key(*claim)).collect();
    assert!(absent.is_empty(), "docs/equations.md has no row for {absent:#?}");
    let beyond: Vec<_> = there.keys().filter(|claim| !given.contains_key(*claim)).collect();
    assert!(beyond.is_empty(), "nothing gives a verdict on {beyond:#?}");
    let other: Vec<_> = given.iter().filter(|(claim, row)| there[*claim] != **row).collect();
    assert!(other.is_empty(), "docs/equations.md has another verdict or command for {other:#?}");
}

#[test]
fn every_numbered_claim_has_a_row() {
    let rows = rows();
    for (paper, kind, last) in NUMBERED {
        let of_paper = rows.keys().filter(|[of, _]| of == paper);
        let there: Vec<u32> = of_paper.flat_map(|[_, claim]| numbers(kind, claim)).collect();
        let absent: Vec<u32> = (1..=last).filter(|number| !there.contains(number)).collect();
        assert!(absent.is_empty(), "{paper}: no row for {kind} {absent:?}");
    }
}
