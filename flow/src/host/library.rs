//! Libraries of functions, of which a program takes those that it needs.
use super::expression::{Token, tokens};

/// The functions of a language: texts under headings `=== NAME`, each behind those that it calls.
pub struct Library(Vec<(&'static str, &'static str)>);

impl Library {
    /// Those of C.
    pub fn c() -> Library {
        Library::parse(include_str!("templates/functions.h"))
    }

    /// Those of Python.
    pub fn python() -> Library {
        Library::parse(include_str!("templates/functions.py"))
    }

    fn parse(text: &'static str) -> Library {
        let sections = text.split("=== ").filter_map(|section| section.split_once('\n'));
        Library(sections.collect())
    }

    /// The texts of the functions that texts call, and of those that these call, in the library's
    /// order.
    pub fn called<'t>(&self, texts: impl IntoIterator<Item = &'t str>) -> Vec<&'static str> {
        let mut wanted = vec![false; self.0.len()];
        texts.into_iter().for_each(|text| self.mark(text, &mut wanted));
        let kept = self.0.iter().zip(wanted).filter(|(_, wanted)| *wanted);
        kept.map(|((_, text), _)| *text).collect()
    }

    fn mark(&self, text: &str, wanted: &mut [bool]) {
        for token in tokens(text) {
            let Token::Function(name) = token else { continue };
            let known = self.0.iter().position(|(known, _)| *known == name);
            if let Some(place) = known.filter(|&place| !wanted[place]) {
                wanted[place] = true;
                self.mark(self.0[place].1, wanted);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both languages have the same functions, and each function stands behind those that it calls.
    #[test]
    fn both_languages_have_the_same_functions() {
        let names = |library: &Library| library.0.iter().map(|(name, _)| *name).collect::<Vec<_>>();
        let (c, python) = (Library::c(), Library::python());
        let own = ["load"];
        let of_c: Vec<_> = names(&c).into_iter().filter(|name| !own.contains(name)).collect();
        assert_eq!(of_c, names(&python));
        for (place, (name, text)) in c.0.iter().enumerate() {
            for token in tokens(text) {
                let Token::Function(called) = token else { continue };
                let at = c.0.iter().position(|(known, _)| *known == called);
                assert!(at.is_none_or(|at| at <= place), "{name} calls {called}");
            }
        }
    }

    #[test]
    fn a_program_gets_what_it_calls() {
        let texts = Library::c().called(["@halfway(light)"]);
        assert!(texts.len() > 4 && texts.iter().all(|text| !text.contains("@cross")));
    }
}
