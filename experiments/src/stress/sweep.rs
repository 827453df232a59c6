//! Trying the whole catalogue.
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use specula_spec::Method;

use super::catalogue::CATALOGUE;
use super::cell::Cell;
use super::draw::Draw;
use super::raw;
use super::requirement::Requirement;
use super::row::{CatalogueRow, Trial, TrialExtent};
use super::variant::Variant;

/// Tries the catalogue with `methods`, row by row; `progress` is called with the number of parts
/// done and the number of all parts.
pub fn sweep(
    seed: u64,
    methods: &[Method],
    extent: TrialExtent,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Cell> {
    let draws = |(number, row): (usize, &'static CatalogueRow)| {
        let draw = Draw::new(seed, number as u64);
        parts(row, methods).into_iter().map(move |part| (draw.clone(), row, part))
    };
    let parts: Vec<(Draw, &CatalogueRow, Option<Method>)> =
        CATALOGUE.iter().copied().enumerate().flat_map(draws).collect();
    let (done, all) = (AtomicUsize::new(0), parts.len() + methods.len());
    let count = || progress(done.fetch_add(1, Ordering::Relaxed) + 1, all);
    let one = |(mut draw, row, method): (Draw, &CatalogueRow, Option<Method>)| {
        let cell = tried(row, method, &mut draw, extent);
        count();
        cell
    };
    let mut cells: Vec<Cell> = parts.into_par_iter().map(one).collect();
    let patterns = |(number, &method): (usize, &Method)| {
        let cell =
            raw::cell(method, &mut Draw::new(seed, (CATALOGUE.len() + number) as u64), extent);
        count();
        cell
    };
    cells.extend(methods.par_iter().enumerate().map(patterns).collect::<Vec<Cell>>());
    cells
}

/// The parts of a row: one for each method, or one without a method for what the host does alone.
fn parts(row: &CatalogueRow, methods: &[Method]) -> Vec<Option<Method>> {
    match row.trial {
        Trial::Scenes { .. } => methods.iter().copied().map(Some).collect(),
        Trial::Host { .. } => vec![None],
    }
}

fn tried(row: &CatalogueRow, method: Option<Method>, draw: &mut Draw, extent: TrialExtent) -> Cell {
    let mut cell = Cell::empty(row.id, method);
    match (&row.trial, method) {
        (Trial::Host { what, check }, _) => {
            let error = check().err();
            cell.ask(
                "host",
                Requirement {
                    detail: error.clone(),
                    of_row: true,
                    ..Requirement::none_of(*what, u64::from(error.is_some()), None)
                },
            );
        }
        (Trial::Scenes { cases, variants }, Some(method)) => {
            let everywhere = if extent.every_option {
                Variant::all_of(method)
            } else {
                vec![Variant::default_of(method)]
            };
            let of_row = variants().into_iter().filter(|variant| variant.method == method);
            let variants: Vec<Variant> = everywhere.into_iter().chain(of_row).collect();
            for case in cases(draw, extent) {
                cell.try_case(&case, &variants);
            }
        }
        (Trial::Scenes { .. }, None) => {}
    }
    cell
}

#[cfg(test)]
mod tests {
    use super::super::limits::Reason;
    use super::super::requirement::RowVerdict;
    use super::*;

    /// A light a quarter of a unit from a wall: wrapped directions would have an error of 191 LSB, so
    /// that cores have true ones there, and wrapped ones where the light is far away.
    #[test]
    fn places_are_wrapped_only_where_that_serves() {
        let row = CATALOGUE.iter().find(|row| row.id == "40").expect("it is in the catalogue");
        let extent = TrialExtent { every_option: true, ..TrialExtent::SMALL };
        let cell = tried(row, Some(Method::Phong), &mut Draw::new(1, 0), extent);
        assert_ne!(cell.verdict(), Some(RowVerdict::Fault));
        let wrapped =
            cell.asked.iter().filter(|asked| asked.reasons.contains(&Reason::WrappedPlaces));
        let worst = wrapped.map(|asked| asked.came).fold(0.0, f64::max);
        assert!(worst < 4.0, "{worst}");
        let besides =
            cell.asked.iter().filter(|asked| asked.of_row).map(|asked| asked.what.as_str());
        let besides: Vec<&str> = besides.collect();
        assert!(besides.iter().any(|what| what.starts_with("wrapped directions") && what.contains("at both ends")), "{besides:?}");
    }
}
