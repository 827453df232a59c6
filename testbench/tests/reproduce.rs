//! NUMERICS.md's numbers come out of our own code, and the verdicts on claims are those it gives.
use specula_testbench::reproduce::Paper;

#[test]
fn numbers_are_those_of_numerics() {
    let wrong: Vec<_> = Paper::ALL.into_iter().flat_map(Paper::verdicts).filter(|verdict| !verdict.as_expected).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn claims_that_do_not_hold_are_told() {
    let refuted = |paper: Paper| paper.verdicts().into_iter().filter(|v| !v.holds).map(|v| v.claim).collect::<Vec<_>>();
    assert_eq!(refuted(Paper::Lyon), ["k = 2 is visually indistinguishable (half an LSB)"]);
    assert!(refuted(Paper::Reshetov).is_empty());
    assert_eq!(refuted(Paper::Hast).len(), 2);
}
