//! Who calls what in golden::exact: sources are parsed, and a function counts as called only where
//! something does that is not a test.
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};

/// A free function of golden::exact: its module and its name.
pub type Function = (String, String);

/// The functions, and how those are reached that something outside of golden::exact reaches.
pub struct Calls {
    /// Every free function that is public beyond its file.
    pub functions: BTreeSet<Function>,
    /// Those that are reached from a method, a loop, a claim or a command.
    pub reached: BTreeSet<Function>,
}

/// Where calls count. Tests stand in folders of their own, or in modules that are left out.
const SOURCES: [&str; 4] = ["golden/src", "testbench/src", "experiments/src", "tools/src"];
const EXACT: &str = "golden/src/exact";

impl Calls {
    /// Reads the sources under `root`.
    pub fn read(root: &Path) -> Calls {
        let files: Vec<(PathBuf, syn::File)> =
            SOURCES.iter().flat_map(|folder| parsed(&root.join(folder))).collect();
        let is_exact = |path: &Path| path.starts_with(root.join(EXACT));
        let exact = || files.iter().filter(|(path, _)| is_exact(path));
        let of = |is_wanted: fn(&syn::ItemFn) -> bool| -> BTreeSet<Function> {
            exact()
                .flat_map(|(path, file)| free_functions(&module(path), file, is_wanted))
                .collect()
        };
        let (functions, all) = (of(is_public), of(|_| true));
        let mut callers: BTreeMap<Function, BTreeSet<Caller>> = BTreeMap::new();
        for (path, file) in &files {
            let own = is_exact(path).then(|| module(path));
            let mut scan = Scan::new(&all, own, file);
            scan.visit_file(file);
            scan.calls.into_iter().for_each(|(called, caller)| {
                callers.entry(called).or_default().insert(caller);
            });
        }
        let reached = reached(&callers);
        Calls { functions, reached }
    }
}

/// What calls: a free function of golden::exact, or anything else.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Caller {
    Exact(Function),
    Other,
}

/// What is called from outside, and what that calls.
fn reached(callers: &BTreeMap<Function, BTreeSet<Caller>>) -> BTreeSet<Function> {
    let mut reached = BTreeSet::new();
    loop {
        let is_reached = |caller: &Caller| match caller {
            Caller::Exact(function) => reached.contains(function),
            Caller::Other => true,
        };
        let next: BTreeSet<Function> = callers
            .iter()
            .filter(|(_, callers)| callers.iter().any(is_reached))
            .map(|(called, _)| called.clone())
            .collect();
        if next == reached {
            return reached;
        }
        reached = next;
    }
}

/// The name of a file's module: `mod.rs` is its folder's.
fn module(path: &Path) -> String {
    let name = |path: &Path| {
        path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default()
    };
    match name(path) {
        stem if stem == "mod" => path.parent().map(name).unwrap_or_default(),
        stem => stem,
    }
}

pub fn parsed(folder: &Path) -> Vec<(PathBuf, syn::File)> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            files.extend(parsed(&entry));
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            let text = std::fs::read_to_string(&entry).unwrap();
            let file = syn::parse_file(&text)
                .unwrap_or_else(|error| panic!("{}: {error}", entry.display()));
            files.push((entry, file));
        }
    }
    files
}

fn free_functions(
    module: &str,
    file: &syn::File,
    is_wanted: fn(&syn::ItemFn) -> bool,
) -> Vec<Function> {
    let free = |item: &syn::Item| match item {
        syn::Item::Fn(function) if is_wanted(function) => {
            Some((module.to_owned(), function.sig.ident.to_string()))
        }
        _ => None,
    };
    file.items.iter().filter_map(free).collect()
}

fn is_public(function: &syn::ItemFn) -> bool {
    !matches!(function.vis, syn::Visibility::Inherited)
}

/// Calls in one file.
struct Scan<'a> {
    functions: &'a BTreeSet<Function>,
    /// The module of golden::exact that the file is.
    own: Option<String>,
    /// Functions that `use` items name.
    imported: BTreeSet<Function>,
    /// Names of variables, which a function's name may be hidden by.
    variables: BTreeSet<String>,
    /// The free function that is being looked at.
    within: Option<String>,
    calls: Vec<(Function, Caller)>,
}

impl<'a> Scan<'a> {
    fn new(functions: &'a BTreeSet<Function>, own: Option<String>, file: &syn::File) -> Scan<'a> {
        let mut names = Names::default();
        names.visit_file(file);
        let Names { imported, variables } = names;
        Scan { functions, own, imported, variables, within: None, calls: Vec::new() }
    }

    /// The function that a path of an expression names; a bare name is one of the file's own, or
    /// imported.
    fn named(&self, path: &syn::Path) -> Option<Function> {
        let mut segments = path.segments.iter().rev().map(|segment| segment.ident.to_string());
        let name = segments.next()?;
        let function = match segments.next() {
            Some(module) => (module, name),
            None => {
                let imported =
                    self.imported.iter().find(|(_, imported)| *imported == name).cloned();
                imported.or_else(|| self.own.clone().map(|own| (own, name)))?
            }
        };
        self.functions.contains(&function).then_some(function)
    }

    fn add(&mut self, called: Function) {
        let caller = match (&self.own, &self.within) {
            (Some(own), Some(within)) => Caller::Exact((own.clone(), within.clone())),
            _ => Caller::Other,
        };
        if caller != Caller::Exact(called.clone()) {
            self.calls.push((called, caller));
        }
    }

    /// A function that is handed on. A variable of its name could be meant as well, and then counts
    /// for nothing.
    fn handed_on(&mut self, argument: &syn::Expr) {
        if let syn::Expr::Path(path) = argument {
            let is_variable = path
                .path
                .get_ident()
                .is_some_and(|name| self.variables.contains(&name.to_string()));
            if let Some(function) = self.named(&path.path).filter(|_| !is_variable) {
                self.add(function);
            }
        }
    }
}

impl<'ast> Visit<'ast> for Scan<'_> {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        let before = self.within.replace(item.sig.ident.to_string());
        visit::visit_item_fn(self, item);
        self.within = before;
    }

    fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
        if let syn::Expr::Path(path) = &*call.func
            && let Some(function) = self.named(&path.path)
        {
            self.add(function);
        }
        call.args.iter().for_each(|argument| self.handed_on(argument));
        visit::visit_expr_call(self, call);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        call.args.iter().for_each(|argument| self.handed_on(argument));
        visit::visit_expr_method_call(self, call);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        let arguments =
            called.parse_body_with(Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated);
        for argument in arguments.into_iter().flatten() {
            Scan::visit_owned(self, &argument);
        }
    }
}

impl Scan<'_> {
    fn visit_owned(&mut self, expression: &syn::Expr) {
        self.visit_expr(expression);
    }
}

pub fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.parse_args::<syn::Path>().is_ok_and(|what| what.is_ident("test"))
    })
}

/// Names that a file brings in.
#[derive(Default)]
struct Names {
    imported: BTreeSet<Function>,
    variables: BTreeSet<String>,
}

impl Names {
    fn import(&mut self, module: &str, tree: &syn::UseTree) {
        match tree {
            syn::UseTree::Path(path) => self.import(&path.ident.to_string(), &path.tree),
            syn::UseTree::Name(name) => {
                self.imported.insert((module.to_owned(), name.ident.to_string()));
            }
            syn::UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.import(module, tree))
            }
            syn::UseTree::Rename(_) | syn::UseTree::Glob(_) => (),
        }
    }
}

impl<'ast> Visit<'ast> for Names {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.import("", &item.tree);
    }

    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        self.variables.insert(pattern.ident.to_string());
        visit::visit_pat_ident(self, pattern);
    }
}

/// The scan finds what it must, and nothing else.
#[test]
fn calls_are_told_from_names() {
    let source = "
        use crate::exact::formula::wrap::{error, wrap};
        use crate::exact::formula::shape;
        pub fn claim() { let _ = f(error); shape::power(1.0, 2); hidden(chord); let chord = 1; }
        /// wrap(1)
        fn text() -> &'static str { \"wrap(2)\" }
        #[cfg(test)] mod tests { use super::wrap; fn t() { wrap(3); } }";
    let file = syn::parse_file(source).unwrap();
    let all = ["error", "wrap", "chained"].map(|name| ("wrap".to_owned(), name.to_owned()));
    let functions: BTreeSet<Function> =
        all.into_iter().chain([("shape".to_owned(), "power".to_owned())]).collect();
    let mut scan = Scan::new(&functions, None, &file);
    scan.visit_file(&file);
    let called: Vec<String> =
        scan.calls.into_iter().map(|((module, name), _)| format!("{module}::{name}")).collect();
    assert_eq!(called, ["wrap::error", "shape::power"]);
}
