//! The variables of a dump, and the scopes they are in.
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use super::warnings::clean;

/// A variable of a dump.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// The scope it is in.
    pub scope: ScopeId,
    /// Its name in its scope, as it stands in the file, without the range of its bits.
    pub name: String,
    /// The range of its bits, such as `[7:0]`, if the file states one.
    pub range: Option<String>,
    /// The kind of its values.
    pub kind: Kind,
    /// Width in bits; `None` for text, real numbers and events, and where the file does not state
    /// it.
    pub width: Option<u32>,
    /// Whether the file says that it is a port.
    pub port: bool,
    /// The number of the source of its values: variables with the same number have the same values.
    pub signal: u32,
    /// Names of its values, for an enumeration.
    pub names: Option<Rc<ValueNames>>,
}

/// The kind of a variable's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Bits.
    Bits,
    /// Text or real numbers.
    Other,
    /// Only the times at which something happens.
    Event,
}

/// Names of an enumeration's values. The keys are bits without leading zeros.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ValueNames(BTreeMap<String, String>);

impl ValueNames {
    /// Makes the names from pairs of bits and name.
    pub fn new(pairs: impl IntoIterator<Item = (String, String)>) -> ValueNames {
        let pair = |(bits, name): (String, String)| (significant(&bits).to_owned(), clean(&name));
        ValueNames(pairs.into_iter().map(pair).collect())
    }

    /// The name of a value.
    pub fn name(&self, bits: &str) -> Option<&str> {
        self.0.get(significant(bits)).map(String::as_str)
    }
}

fn significant(bits: &str) -> &str {
    bits.trim_start_matches('0')
}

/// The enumerations of a file, and the one that the next variable has.
#[derive(Clone, Debug, Default)]
pub struct Enumerations {
    tables: HashMap<u64, Rc<ValueNames>>,
    next: Option<Rc<ValueNames>>,
}

impl Enumerations {
    /// Adds an enumeration with its number in the file.
    pub fn declare(&mut self, number: u64, names: ValueNames) {
        self.tables.insert(number, Rc::new(names));
    }

    /// Says that the next variable has the enumeration with that number.
    pub fn announce(&mut self, number: u64) {
        self.next = self.tables.get(&number).cloned();
    }

    /// The enumeration that was announced for the current variable.
    pub fn take_next(&mut self) -> Option<Rc<ValueNames>> {
        self.next.take()
    }
}

/// A scope's number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScopeId(u32);

/// The scopes of a dump, as a tree.
#[derive(Clone, Debug)]
pub struct Scopes {
    scopes: Vec<Scope>,
    numbers: HashMap<(ScopeId, String), ScopeId>,
}

#[derive(Clone, Debug)]
struct Scope {
    name: String,
    parent: ScopeId,
    depth: u32,
    /// Bytes of the scope's full name.
    length: usize,
}

/// Largest number of variables of a dump.
pub const MAX_VARIABLES: usize = 1 << 22;
/// Largest number of scopes of a dump.
const MAX_SCOPES: usize = 1 << 20;
/// Largest number of scopes around a variable, and largest length of their full name in bytes:
/// files state how deep scopes nest.
const DEEPEST: u32 = 256;
const LONGEST: usize = 4096;

impl Scopes {
    /// The root, which holds what is in no scope.
    pub const NONE: ScopeId = ScopeId(0);

    /// A tree with the root only.
    pub fn new() -> Scopes {
        let none = Scope { name: String::new(), parent: Scopes::NONE, depth: 0, length: 0 };
        Scopes { scopes: vec![none], numbers: HashMap::new() }
    }

    /// The scope with that name in `parent`, which is added unless it exists. The result is `None`
    /// if scopes nest too deep.
    pub fn child(&mut self, parent: ScopeId, name: &str) -> Option<ScopeId> {
        let key = (parent, clean(name));
        if let Some(&scope) = self.numbers.get(&key) {
            return Some(scope);
        }
        let (depth, length) = (self.depth(parent) + 1, self.scope(parent).length + key.1.len() + 1);
        if self.scopes.len() >= MAX_SCOPES || depth > DEEPEST || length > LONGEST {
            return None;
        }
        let new = ScopeId(self.scopes.len() as u32);
        self.scopes.push(Scope { name: key.1.clone(), parent, depth, length });
        self.numbers.insert(key, new);
        Some(new)
    }

    /// The number of scopes around the contents of this one.
    pub fn depth(&self, scope: ScopeId) -> u32 {
        self.scope(scope).depth
    }

    /// A scope's own name.
    pub fn name(&self, scope: ScopeId) -> &str {
        &self.scope(scope).name
    }

    /// The names of a scope and of those around it, joined by dots.
    pub fn path(&self, scope: ScopeId) -> String {
        let mut names: Vec<&str> = self.ancestors(scope).map(|scope| self.name(scope)).collect();
        names.reverse();
        names.join(".")
    }

    /// The scope, its parent, and so on.
    pub fn ancestors(&self, scope: ScopeId) -> impl Iterator<Item = ScopeId> {
        let known = |scope: ScopeId| Some(scope).filter(|&scope| scope != Scopes::NONE);
        std::iter::successors(known(scope), move |&inner| known(self.scope(inner).parent))
    }

    /// Every scope's name, in the order of the file.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.scopes.iter().skip(1).map(|scope| scope.name.as_str())
    }

    /// The rank of each scope in an order where each stands before the scopes inside it.
    fn ranks(&self) -> Vec<usize> {
        let mut inner: Vec<Vec<u32>> = vec![vec![]; self.scopes.len()];
        for (number, scope) in self.scopes.iter().enumerate().skip(1) {
            // `child` made the number from a u32.
            inner[scope.parent.0 as usize].push(number as u32);
        }
        let (mut ranks, mut open, mut next) = (vec![0; self.scopes.len()], vec![0], 0);
        while let Some(scope) = open.pop() {
            ranks[scope as usize] = next;
            next += 1;
            open.extend(inner[scope as usize].iter().rev());
        }
        ranks
    }

    fn scope(&self, scope: ScopeId) -> &Scope {
        &self.scopes[scope.0 as usize]
    }
}

/// Sorts variables by scope, those of a scope before those of the scopes inside it. Where parts of
/// one vector stand in a scope under one name, their ranges become part of their names.
pub fn arrange(variables: &mut [Variable], scopes: &Scopes) {
    let ranks = scopes.ranks();
    variables.sort_by_key(|variable| ranks[variable.scope.0 as usize]);
    let mut ranges: HashMap<(ScopeId, &str), Vec<Option<&str>>> = HashMap::new();
    for variable in variables.iter() {
        let ranges = ranges.entry((variable.scope, &variable.name)).or_default();
        if !ranges.contains(&variable.range.as_deref()) && ranges.len() < 2 {
            ranges.push(variable.range.as_deref());
        }
    }
    let parts: Vec<bool> = variables
        .iter()
        .map(|variable| ranges[&(variable.scope, variable.name.as_str())].len() > 1)
        .collect();
    for (variable, _) in variables.iter_mut().zip(parts).filter(|(_, part)| *part) {
        variable.name.push_str(variable.range.as_deref().unwrap_or_default());
    }
}

/// A name as files state it is split into the name and the range of its bits: `m[0] [3:0]` is
/// `m[0]` and `[3:0]`. A single index belongs to the name; the blank before it is removed.
pub fn split_name(stated: &str) -> (String, Option<String>) {
    let stated = stated.trim();
    let range = stated.strip_suffix(']').and_then(|name| name.rsplit_once('['));
    let bounds = range.and_then(|(name, range)| Some((name.trim_end(), range.split_once(':')?)));
    let is_number = |text: &str| text.trim().parse::<i64>().is_ok();
    match bounds {
        Some((name, (high, low))) if !name.is_empty() && is_number(high) && is_number(low) => {
            (joined(name), Some(format!("[{}:{}]", high.trim(), low.trim())))
        }
        _ => (joined(stated), None),
    }
}

/// The name without blanks before its indices.
fn joined(name: &str) -> String {
    let mut joined = clean(&name.split_whitespace().collect::<Vec<_>>().join(" "));
    if joined.ends_with(']') {
        joined = joined.replace(" [", "[");
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_their_indices_and_lose_their_ranges() {
        let cases = [
            ("d", "d", None),
            ("d [7:0]", "d", Some("[7:0]")),
            ("d\t[7:0]", "d", Some("[7:0]")),
            ("d[7 : 0]", "d", Some("[7:0]")),
            ("m[0] [3:0]", "m[0]", Some("[3:0]")),
            ("m [0][3:0]", "m[0]", Some("[3:0]")),
            ("d [3]", "d[3]", None),
            ("\\a.b[1] [2:-1]", "\\a.b[1]", Some("[2:-1]")),
            ("my signal", "my signal", None),
            ("[3:0]", "[3:0]", None),
            ("a[x:y]", "a[x:y]", None),
            ("]", "]", None),
        ];
        for (stated, name, range) in cases {
            assert_eq!(split_name(stated), (name.to_owned(), range.map(str::to_owned)), "{stated}");
        }
    }

    #[test]
    fn scopes_of_one_name_are_one_and_nest_only_so_deep() {
        let mut scopes = Scopes::new();
        let top = scopes.child(Scopes::NONE, "top").expect("it is the first");
        let inner = scopes.child(top, "inner").expect("it is the second");
        assert_eq!(scopes.child(Scopes::NONE, "top"), Some(top));
        assert_eq!((scopes.path(inner), scopes.depth(inner)), ("top.inner".to_owned(), 2));
        let deepest = (0..1000).try_fold(top, |scope, _| scopes.child(scope, "s").ok_or(scope));
        assert_eq!(deepest.map_err(|scope| scopes.depth(scope)), Err(DEEPEST));
    }

    #[test]
    fn values_are_named_whatever_their_leading_zeros() {
        let names = ValueNames::new([
            ("00".to_owned(), "idle".to_owned()),
            ("01".to_owned(), "run".to_owned()),
        ]);
        assert_eq!(
            (names.name("0"), names.name("0001"), names.name("10")),
            (Some("idle"), Some("run"), None)
        );
    }
}
