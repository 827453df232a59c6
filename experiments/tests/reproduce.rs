//! docs/numerics.md's numbers come out of our own code, and the verdicts on claims are those it
//! gives.
use specula_experiments::reproduce::{ClaimVerdict, Paper, Ruling};

fn not_holding(paper: Paper) -> Vec<&'static str> {
    let refuted = |verdict: &ClaimVerdict| matches!(verdict.ruling, Ruling::DoesNotHold(_));
    let mut claims: Vec<&str> = paper
        .verdicts()
        .iter()
        .filter(|verdict| refuted(verdict))
        .map(|verdict| verdict.claim)
        .collect();
    claims.dedup();
    claims
}

#[test]
fn numbers_are_those_of_numerics() {
    let wrong: Vec<ClaimVerdict> = Paper::ALL
        .into_iter()
        .flat_map(Paper::verdicts)
        .filter(|verdict| !verdict.as_expected)
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Each by the words docs/numerics.md refutes it with.
#[test]
fn claims_that_do_not_hold_are_told() {
    assert_eq!(
        not_holding(Paper::Lyon),
        [
            "k = 2 is visually indistinguishable (half an LSB)",
            "Blinn's D2 is his D1 for large n",
            "Gouraud shading can have f_2 as well (an error no more than a tenth larger)",
            "1 % residual length error is good enough at n = 1000 (5 % of the peak)",
            "a span of 90 degrees halves the highlight in its middle, n = 1000, behind g2",
            "the overshoot is completely negligible (an LSB)",
            "10 fraction bits keep errors of directions below 0.001 radian",
            "figure 7's bit counts are plausible (an LSB), spans of 30 degrees",
            "figure 8's bit counts are plausible (an LSB), spans of 30 degrees",
        ]
    );
    assert_eq!(
        not_holding(Paper::Reshetov),
        [
            "3.3: which is usually not noticed, as the product is very small then",
            "0.06096 suffices for q, with the exponent 2 as printed",
            "figure 11: the difference is monotone or a dome in the third angle, so that it is least at an end",
            "figure 12: whatever u, the difference is least for normals 90 degrees apart",
            "the greedy repair, which is not guaranteed, remedies what can be remedied",
            "figure 9: the smoother a mesh, the more alike both shadings are (1 % of full scale)",
        ]
    );
    assert_eq!(not_holding(Paper::Hast).len(), 6);
}

/// A figure is drawn with what a core gives beside its formulas, and both agree to an LSB or so.
#[test]
fn figures_of_cores_lie_on_their_formulas() {
    use specula_experiments::reproduce::figure::CurveKind;
    for figure in Paper::ALL.into_iter().flat_map(Paper::figures) {
        let cores = figure.curves.iter().filter(|curve| curve.kind == CurveKind::Core);
        for core in cores {
            let formulas = figure
                .curves
                .iter()
                .filter(|curve| curve.kind == CurveKind::Formula && curve.colour == core.colour);
            let formula = &formulas
                .clone()
                .next()
                .unwrap_or_else(|| panic!("{}: no formula of colour {}", figure.name, core.colour))
                .points;
            for &(x, y) in &core.points {
                let after =
                    formula.partition_point(|point| point.0 < x).clamp(1, formula.len() - 1);
                let ((x0, y0), (x1, y1)) = (formula[after - 1], formula[after]);
                let between = y0 + (y1 - y0) * (x - x0) / (x1 - x0);
                assert!(
                    (y - between).abs() < 1.5 / 255.0,
                    "{} at {x}: {y} instead of {between}",
                    figure.name
                );
            }
        }
    }
}
