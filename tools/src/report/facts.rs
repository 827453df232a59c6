//! The facts that a core rests on, for people.
use specula_hdl::Design;
use specula_hdl::design::Assumption;

/// Rows of fact, signals and range. The same fact in units of the same kind shares a row.
pub fn rows(design: &Design) -> Vec<[String; 3]> {
    let mut kinds: Vec<(&Assumption, usize)> = vec![];
    for assumption in &design.assumptions {
        match kinds.iter_mut().find(|(first, _)| is_same(design, first, assumption)) {
            Some((_, number)) => *number += 1,
            None => kinds.push((assumption, 1)),
        }
    }
    kinds.into_iter().map(|(first, number)| row(design, first, number)).collect()
}

fn is_same(design: &Design, one: &Assumption, other: &Assumption) -> bool {
    let unit = |assumption: &Assumption| &design.scope(design.node(assumption.node).scope).unit;
    one.fact == other.fact && one.range == other.range && unit(one) == unit(other)
}

fn row(design: &Design, first: &Assumption, number: usize) -> [String; 3] {
    let format = design.node(first.node).format();
    let others = if number == 1 { String::new() } else { format!(" and {} more", number - 1) };
    let bound = |raw: i64| format.value(raw);
    [
        first.fact.clone(),
        format!("`{}`{others}", design.full_name(first.node)),
        format!("{:.6} to {:.6}", bound(first.range.low), bound(first.range.high)),
    ]
}
