//! What a row names is used: by code that is no test, in the crates that may reach it. Sources are
//! parsed, so that a word of a comment or of a string, a definition, an import and a call of a function
//! by itself count for nothing.
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use syn::buffer::{Cursor, TokenBuffer};
use syn::visit::{self, Visit};

use super::calls::{is_test, parsed};
use super::{FOLDERS, ROOT, is_file, quoted, rows};

const CRATES: [&str; 8] =
    ["scene", "core-spec", "golden", "hdl", "testbench", "flow", "experiments", "tools"];

/// Names that the code of each crate uses.
type Uses = BTreeMap<&'static str, BTreeSet<String>>;

fn uses() -> Uses {
    let used = |name: &'static str| {
        let mut uses = Scan::default();
        parsed(&Path::new(ROOT).join(name).join("src"))
            .iter()
            .for_each(|(_, file)| uses.visit_file(file));
        (name, uses.names)
    };
    CRATES.into_iter().map(used).collect()
}

/// The crates that may use what a file defines: `golden::fixed` and `hdl` are reached through what
/// makes models and cores alone.
fn users(file: &str) -> &'static [&'static str] {
    match file {
        file if file.starts_with("golden/src/fixed/") => &["golden"],
        file if file.starts_with("hdl/") => &["hdl"],
        file if file.starts_with("golden/") => &["golden", "testbench", "experiments", "tools"],
        _ => &CRATES,
    }
}

/// Names that code uses: what paths, calls of methods and macros name.
#[derive(Default)]
struct Scan {
    names: BTreeSet<String>,
    /// The functions and the type whose definition is being looked at, which do not use themselves.
    within: Vec<String>,
}

impl Scan {
    fn add(&mut self, name: String) {
        if !self.within.contains(&name) {
            self.names.insert(name);
        }
    }

    fn inside(&mut self, name: String, visit: impl FnOnce(&mut Scan)) {
        self.within.push(name);
        visit(self);
        self.within.pop();
    }

    /// Names among a macro's tokens that it does not define.
    fn tokens(&mut self, mut rest: Cursor) {
        let mut is_defined = false;
        while !rest.eof() {
            if let Some((name, behind)) = rest.ident() {
                let name = name.to_string();
                let defines = ["struct", "enum", "fn"].contains(&name.as_str());
                if !is_defined && !defines {
                    self.add(name);
                }
                (is_defined, rest) = (defines, behind);
            } else if let Some((inside, _, _, behind)) = rest.any_group() {
                self.tokens(inside);
                rest = behind;
            } else if let Some((_, behind)) = rest.token_tree() {
                rest = behind;
            }
        }
    }
}

impl<'ast> Visit<'ast> for Scan {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.inside(item.sig.ident.to_string(), |scan| visit::visit_item_fn(scan, item));
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.inside(item.sig.ident.to_string(), |scan| visit::visit_impl_item_fn(scan, item));
    }

    /// What is implemented is no use of it.
    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let own = match &*item.self_ty {
            syn::Type::Path(of) => of.path.segments.last().map(|last| last.ident.to_string()),
            _ => None,
        };
        let of_items = |scan: &mut Scan| {
            item.items.iter().for_each(|part| scan.visit_impl_item(part));
        };
        self.inside(own.unwrap_or_default(), of_items);
    }

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        path.segments.iter().for_each(|segment| self.add(segment.ident.to_string()));
        visit::visit_path(self, path);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        self.add(call.method.to_string());
        visit::visit_expr_method_call(self, call);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        self.tokens(TokenBuffer::new2(called.tokens.clone()).begin());
    }
}

#[test]
fn everything_that_is_named_is_used() {
    let uses = uses();
    let (mut named, mut unused) = (0, Vec::new());
    for cell in rows().iter().flat_map(|row| &row.cells) {
        let folder = FOLDERS.iter().find(|(title, _)| cell.is(title)).map(|(_, folder)| *folder);
        let Some(folder) = folder else { continue };
        let mut file = None;
        for name in quoted(&cell.title).into_iter().chain(quoted(&cell.text)) {
            match (is_file(name), &file) {
                (true, _) => {
                    let is_from_the_root = Path::new(ROOT).join(name).is_file();
                    let of_column = || format!("{folder}/{name}");
                    file = Some(if is_from_the_root { name.to_owned() } else { of_column() });
                }
                (false, Some(own)) => {
                    named += 1;
                    if !users(own).iter().any(|user| uses[user].contains(name)) {
                        unused.push(format!("{own}: {name}"));
                    }
                }
                (false, None) => (),
            }
        }
    }
    assert!(named > 200 && unused.is_empty(), "{named} names, of which nothing uses {unused:#?}");
}

/// A name in a comment, in a string, in a longer name, in an import, in its own definition or in a
/// test counts for nothing.
#[test]
fn uses_are_told_from_names() {
    let names = |source: &str| {
        let mut scan = Scan::default();
        scan.visit_file(&syn::parse_file(source).unwrap());
        scan.names
    };
    for source in [
        "/// wrap(1)\npub fn f() { wrapped(1) } // wrap(2)",
        "fn f() -> &'static str { \"wrap(1)\" }",
        "fn f() { println!(\"wrap(1)\") }",
        "use a::wrap; pub use b::{wrap, c}; mod wrap;",
        "fn wrap() { wrap() }",
        "struct Walk; impl Walk { fn new() -> Walk { Walk } fn wrap(&self) { self.wrap() } }",
        "impl Scheme for Walk { type Of = u32; }",
        "formats! { pub struct wrap { x: Format } }",
        "#[cfg(test)] mod tests { fn t() { wrap(1); Walk::new(); } }",
    ] {
        let names = names(source);
        assert!(!["wrap", "Walk"].iter().any(|name| names.contains(*name)), "{source}: {names:?}");
    }
    for source in [
        "fn f() { wrap(1) }",
        "fn f() { a::wrap(1) }",
        "fn f() { x.map(wrap) }",
        "fn f() { x.wrap() }",
        "fn f() { assert_eq!(1, wrap(1)) }",
        "fn f(x: wrap) {}",
    ] {
        assert!(names(source).contains("wrap"), "{source}");
    }
}
