//! The text that `compare` prints.
use std::path::Path;

use super::markdown;
use super::result::Compared;
use super::tables::{self, SOFTWARE_TITLES, SUMMARY_TITLES};
use crate::output::JOURNAL;
use crate::table;

/// The tables, and where the files are.
pub fn text(compared: &Compared, folder: &Path) -> String {
    let cores = with_titles(SUMMARY_TITLES, tables::summary(compared));
    let known = compared.cores.iter().filter(|core| core.measurement.known).count();
    let all = compared.cores.len();
    let heading = format!(
        "{} x {} pixels of {}, cores at {}; fronts of rms error against size (s) and against time (t)",
        compared.size.0,
        compared.size.1,
        compared.scene,
        compared.clocks.in_words()
    );
    let mut text = format!("{}\n\n{cores}", table::paragraphs(&heading));
    text.extend(compared.refusals.iter().map(|refusal| format!("not built: {refusal}\n")));
    if !compared.software.is_empty() {
        text += &format!("\n{}", with_titles(SOFTWARE_TITLES, tables::software(compared)));
    }
    text.extend(compared.cores.iter().filter_map(|core| {
        Some(format!("DISAGREES: {}: {}\n", core.configuration, core.measured().disagreement()?))
    }));
    text += &format!("\n{}", table::paragraphs(markdown::SET_UP));
    if known > 0 {
        text += &format!(
            "{known} of {all} cores were known from {}; --fresh measures them again\n",
            JOURNAL
        );
    }
    text + &format!("tables and plots in {}\n", folder.display())
}

fn with_titles<const N: usize>(titles: [&str; N], rows: Vec<[String; N]>) -> String {
    let rows: Vec<[String; N]> = [titles.map(str::to_owned)].into_iter().chain(rows).collect();
    table::shown(&rows)
}
