//! What keeps a bound from being smaller.
use specula_spec::CoreSpec;

use super::Wanted;
use super::model::Model;
use super::trials::{State, Trials};

/// The smallest share of a bound that is worth naming, in LSBs.
const LEAST_SHARE: f64 = 0.01;

/// The narrowing point that has the largest share of a bound that finer formats cannot lower, in
/// words.
pub(super) fn in_words(start: &CoreSpec, wanted: &Wanted, finest: Option<State>) -> String {
    let Some(finest) = finest else {
        return "no core in finer formats can be built".to_owned();
    };
    // Those that are kept may be in the way, too.
    let trials = Trials::new(start, &Wanted { kept: &[], ..wanted.clone() });
    let (points, formats) = (start.narrowing_points(), finest.formats.clone());
    let model = Model::around(&trials, finest);
    let shares = (0..model.points()).map(|point| (point, model.share(point)));
    let largest = shares.reduce(|best, next| if next.1 > best.1 { next } else { best });
    match largest.filter(|(_, share)| *share >= LEAST_SHARE) {
        Some((point, share)) => {
            let (name, value) = (points[point].name, points[point].value);
            let is_kept = wanted.kept.iter().any(|kept| kept == name);
            let why = if is_kept { "which are asked for" } else { "the most that were possible" };
            let bits = formats[point];
            format!(
                "`{name}` ({value}) is in the way: with {bits} fraction bits, {why}, {share:.3} LSB of it are rounded there"
            )
        }
        None => "it comes from no format, but from constants, tables and the rounding to 8 bits"
            .to_owned(),
    }
}
