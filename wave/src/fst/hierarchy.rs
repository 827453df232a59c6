//! Scopes and variables of an FST file.
use fst_reader::{FstHierarchyEntry, FstVarDirection, FstVarType};

use super::super::variables::{
    Enumerations, Kind, MAX_VARIABLES, ScopeId, Scopes, ValueNames, Variable, split_name,
};
use super::super::warnings::Warnings;

/// Collects scopes and variables while a hierarchy is read.
pub struct Hierarchy<'a> {
    /// The scopes.
    pub scopes: Scopes,
    /// The variables, in the order of the file.
    pub variables: Vec<Variable>,
    open: Vec<ScopeId>,
    enumerations: Enumerations,
    warnings: &'a mut Warnings,
}

impl<'a> Hierarchy<'a> {
    /// A collector that has read nothing yet.
    pub fn new(warnings: &'a mut Warnings) -> Hierarchy<'a> {
        let (scopes, enumerations) = (Scopes::new(), Enumerations::default());
        Hierarchy { scopes, variables: vec![], open: vec![], enumerations, warnings }
    }

    /// Takes the next entry of the hierarchy.
    pub fn take(&mut self, entry: FstHierarchyEntry) {
        match entry {
            FstHierarchyEntry::Scope { name, .. } => self.scope(&name),
            FstHierarchyEntry::UpScope => self.upscope(),
            FstHierarchyEntry::EnumTable { handle, mapping, .. } => {
                self.enumerations.declare(handle, ValueNames::new(mapping));
            }
            FstHierarchyEntry::EnumTableRef { handle } => self.enumerations.announce(handle),
            FstHierarchyEntry::Var { tpe, direction, name, length, handle, .. } => {
                let signal = handle.get_index() as u32;
                self.variable(&tpe, direction, &name, length, signal);
            }
            _ => {}
        }
    }

    fn scope(&mut self, name: &str) {
        let around = self.around();
        let inner = self.scopes.child(around, name);
        if inner.is_none() {
            self.warnings.of_file("deep", || {
                "scopes are too many or nest too deep: what is inside is taken for the outer's"
                    .to_owned()
            });
        }
        self.open.push(inner.unwrap_or(around));
    }

    fn upscope(&mut self) {
        if self.open.pop().is_none() {
            self.warnings.of_file("upscope", || "a scope ends that never began".to_owned());
        }
    }

    fn variable(
        &mut self,
        of: &FstVarType,
        direction: FstVarDirection,
        name: &str,
        length: u32,
        signal: u32,
    ) {
        let next_names = self.enumerations.take_next();
        if self.variables.len() >= MAX_VARIABLES {
            let said = || {
                format!("there are more than {MAX_VARIABLES} variables: the others are left out")
            };
            return self.warnings.of_file("many", said);
        }
        let (name, range) = split_name(name);
        let kind = match of {
            FstVarType::Event => Kind::Event,
            FstVarType::GenericString => Kind::Other,
            of if of.is_real() => Kind::Other,
            _ => Kind::Bits,
        };
        let width = Some(length).filter(|&length| kind == Kind::Bits && length > 0);
        let port = matches!(
            direction,
            FstVarDirection::Input | FstVarDirection::Output | FstVarDirection::InOut
        );
        let (scope, names) = (self.around(), next_names);
        self.variables.push(Variable { scope, name, range, kind, width, port, signal, names });
    }

    fn around(&self) -> ScopeId {
        self.open.last().copied().unwrap_or(Scopes::NONE)
    }
}

/// The unit of time for a power of ten of a second, such as `10 ps`.
pub fn time_unit(exponent: i8) -> Option<String> {
    const UNITS: [&str; 8] = ["s", "ms", "us", "ns", "ps", "fs", "as", "zs"];
    let thousandths = i32::from(exponent).div_euclid(3);
    let unit = match thousandths {
        0.. => UNITS[0],
        _ => UNITS.get(usize::try_from(-thousandths).ok()?)?,
    };
    match i32::from(exponent) - 3 * thousandths.min(0) {
        0 => Some(unit.to_owned()),
        zeros => Some(format!("{} {unit}", 10u64.checked_pow(zeros.try_into().ok()?)?)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_time_are_those_of_vcd() {
        let cases = [
            (0, "s"),
            (-9, "ns"),
            (-8, "10 ns"),
            (-10, "100 ps"),
            (-1, "100 ms"),
            (2, "100 s"),
            (-21, "zs"),
        ];
        for (exponent, unit) in cases {
            assert_eq!(time_unit(exponent).as_deref(), Some(unit), "{exponent}");
        }
        assert_eq!((time_unit(-22), time_unit(127), time_unit(-128)), (None, None, None));
    }
}
