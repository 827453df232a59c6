//! The table of a core's units and their sizes.
use specula_datapath::Design;
use specula_datapath::design::{Scope, Size, UnitSize};

/// Rows of name, number, and for each one latency, multipliers, multiplier bits, adders,
/// multiplexers, register bits. Equal units that follow each other share a row.
pub fn rows(design: &Design) -> Vec<[String; 8]> {
    let sizes = design.unit_sizes();
    let units: Vec<(&Scope, &UnitSize)> = design.scopes.iter().zip(&sizes).collect();
    let groups = units.chunk_by(|(scope, unit), (next_scope, next_unit)| {
        let same_kind = scope.unit == next_scope.unit && scope.parent == next_scope.parent;
        same_kind && unit.latency == next_unit.latency && unit.size == next_unit.size
    });
    let group = |group: &[(&Scope, &UnitSize)]| {
        let unit = group[0].1;
        row(format!("`{}`", unit.path), group.len(), unit.latency, &unit.size)
    };
    let mut rows: Vec<[String; 8]> = groups.map(group).collect();
    rows.push(row("**whole core**".to_owned(), 1, design.latency(), &design.size()));
    rows
}

fn row(name: String, number: usize, latency: u32, size: &Size) -> [String; 8] {
    [
        name,
        number.to_string(),
        latency.to_string(),
        size.multipliers.to_string(),
        size.multiplier_bits.to_string(),
        size.adders.to_string(),
        size.multiplexers.to_string(),
        size.register_bits.to_string(),
    ]
}
