//! The variables of a dump, and the scopes they are in.
use wellen::{Hierarchy, ItemRef, ScopeRef, SignalRef, VarDirection, VarRef};

/// A variable of a dump.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Names of the scopes it is in, from the outside in.
    pub scopes: Vec<String>,
    /// Its name in its scope.
    pub name: String,
    /// Width in bits; none for text, real numbers and events.
    pub width: Option<u32>,
    /// Whether the file says that it is a port.
    pub port: bool,
    /// Its number in the reader.
    pub signal: SignalRef,
}

impl Variable {
    /// The scopes' names, joined by dots.
    pub fn unit(&self) -> String {
        self.scopes.join(".")
    }

    /// Full name: scopes and all, joined by dots.
    pub fn full_name(&self) -> String {
        self.scopes.iter().chain([&self.name]).map(String::as_str).collect::<Vec<_>>().join(".")
    }
}

/// Every variable, scope by scope, those of a scope before the scopes inside it.
pub fn variables(hierarchy: &Hierarchy) -> Vec<Variable> {
    let mut found = vec![];
    let items: Vec<ItemRef> = hierarchy.items().collect();
    // Not recursive: files say how deep scopes nest.
    let mut open: Vec<(ItemRef, Vec<String>)> = items.into_iter().rev().map(|item| (item, vec![])).collect();
    while let Some((item, scopes)) = open.pop() {
        match item {
            ItemRef::Var(variable) => found.push(variable_of(hierarchy, variable, scopes)),
            ItemRef::Scope(scope) => open.extend(inside(hierarchy, scope, &scopes)),
        }
    }
    found
}

/// What is in a scope, last first: variables, then inner scopes.
fn inside(hierarchy: &Hierarchy, scope: ScopeRef, outer: &[String]) -> Vec<(ItemRef, Vec<String>)> {
    let scope = &hierarchy[scope];
    let path: Vec<String> = outer.iter().cloned().chain([clean(scope.name(hierarchy))]).collect();
    let (variables, scopes): (Vec<_>, Vec<_>) = scope.items(hierarchy).partition(|item| matches!(item, ItemRef::Var(_)));
    variables.into_iter().chain(scopes).rev().map(|item| (item, path.clone())).collect()
}

fn variable_of(hierarchy: &Hierarchy, variable: VarRef, scopes: Vec<String>) -> Variable {
    let variable = &hierarchy[variable];
    let vector = variable.is_bit_vector(hierarchy) || variable.is_1bit(hierarchy);
    Variable {
        scopes,
        name: clean(variable.name(hierarchy)),
        width: variable.length(hierarchy).filter(|&width| vector && width > 0),
        port: matches!(variable.direction(), VarDirection::Input | VarDirection::Output | VarDirection::InOut),
        signal: variable.signal_ref(),
    }
}

/// Without control characters, which a terminal would obey and XML does not allow.
pub fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}
