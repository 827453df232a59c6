//! Material libraries of `.obj` files, `.mtl` [Wavefront, *Object Files*, appendix B].
//!
//! Nothing in a library is an error: what cannot be shown is skipped with a warning.
use super::{name, named_line};
use crate::limits::LARGEST_SHININESS;
use crate::mesh::lines::{Lines, Words, words};
use crate::mesh::number::{number, whole};
use crate::mesh::text::unmarked;
use crate::mesh::warning::{Notices, quoted};
use crate::{Colour, PartialMaterial};

/// Keywords that are ignored without a warning: they matter only to what is transparent.
const SKIPPED: [&[u8]; 3] = [b"Ni", b"Tf", b"sharpness"];

/// The largest illumination model without reflections and transparency.
const HIGHLIGHTS: i64 = 2;

/// The materials of a library with their names, in the order of the file.
pub fn parse(bytes: &[u8], notices: &mut Notices) -> Vec<(Vec<u8>, PartialMaterial)> {
    let mut library = Library { notices, entries: Vec::new() };
    for (index, line) in Lines::new(&unmarked(bytes)).enumerate() {
        library.line(index + 1, named_line(line));
    }
    library.entries.into_iter().map(|entry| (entry.name.clone(), entry.material())).collect()
}

struct Library<'n> {
    notices: &'n mut Notices,
    entries: Vec<Entry>,
}

/// A material as its lines state it.
#[derive(Default)]
struct Entry {
    name: Vec<u8>,
    given: PartialMaterial,
    /// The illumination model.
    model: Option<i64>,
}

impl Entry {
    /// The material under its illumination model: ambient light has its own colour from model 1 on,
    /// and highlights are shown from model 2 on.
    fn material(self) -> PartialMaterial {
        let model = self.model.unwrap_or(HIGHLIGHTS);
        PartialMaterial {
            ambient: self.given.ambient.filter(|_| model > 0),
            specular: if model < HIGHLIGHTS { Some([0.0; 3]) } else { self.given.specular },
            ..self.given
        }
    }
}

impl Library<'_> {
    fn line(&mut self, line: usize, text: &[u8]) {
        let mut words = words(text);
        let Some(keyword) = words.next() else { return };
        if keyword == b"newmtl" {
            let name = name(words.rest()).to_vec();
            self.entries.push(Entry { name, ..Entry::default() });
        } else if self.entries.is_empty() {
            self.notices.add("no material", Some(line), || {
                "lines before the first `newmtl` are passed over".into()
            });
        } else {
            self.statement(line, keyword, words);
        }
    }

    /// A statement about the last material.
    fn statement(&mut self, line: usize, keyword: &[u8], words: Words<'_>) {
        match keyword {
            b"Ka" => self.set(line, keyword, words, |given| &mut given.ambient),
            b"Kd" => self.set(line, keyword, words, |given| &mut given.diffuse),
            b"Ks" => self.set(line, keyword, words, |given| &mut given.specular),
            b"Ns" => self.shininess(line, words),
            b"illum" => self.model(line, words),
            b"d" if states(words.clone(), 1.0) => {}
            b"Tr" | b"Ke" if states(words.clone(), 0.0) => {}
            b"d" | b"Tr" => self.notices.add("transparent", Some(line), || {
                "a material is transparent; it is shown as opaque".into()
            }),
            b"Ke" => self.notices.add("emissive", Some(line), || {
                "a material shines by itself; it is shown without that".into()
            }),
            keyword if SKIPPED.contains(&keyword) => {}
            keyword => {
                let what = quoted(keyword);
                self.notices.add(&what, Some(line), || {
                    format!(
                        "lines {what} are passed over; only `Ka`, `Kd`, `Ks`, `Ns` and `illum` are shown"
                    )
                });
            }
        }
    }

    fn last(&mut self) -> Option<&mut Entry> {
        self.entries.last_mut()
    }

    fn set(
        &mut self,
        line: usize,
        keyword: &[u8],
        words: Words<'_>,
        of: fn(&mut PartialMaterial) -> &mut Option<Colour>,
    ) {
        let Some(stated) = colour(words) else {
            return self.skip(line, keyword, "three numbers are expected");
        };
        let colour = stated.map(|x| x.clamp(0.0, 1.0));
        if let Some(k) = (0..3).find(|&k| stated[k] != colour[k]) {
            self.notices.add("range", Some(line), || {
                format!(
                    "{} has the component {:?}; components are 0 to 1, and it is taken as {:?}",
                    quoted(keyword),
                    stated[k],
                    colour[k]
                )
            });
        }
        if let Some(entry) = self.last() {
            *of(&mut entry.given) = Some(colour);
        }
    }

    fn shininess(&mut self, line: usize, mut words: Words<'_>) {
        let stated = words.next().and_then(number).filter(|n| !n.is_nan());
        let Some(stated) = stated else { return self.skip(line, b"Ns", "a number is expected") };
        let largest = f64::from(LARGEST_SHININESS);
        if !(0.0..=largest).contains(&stated) {
            self.notices.add("exponent", Some(line), || {
                format!("`Ns` is {stated:?}; exponents from 1 to {LARGEST_SHININESS} are shown, and the nearest is taken")
            });
        }
        if let Some(entry) = self.last() {
            // It is within the range of u32.
            entry.given.shininess = Some((stated + 0.5).floor().clamp(1.0, largest) as u32);
        }
    }

    fn model(&mut self, line: usize, mut words: Words<'_>) {
        let Some(model) = words.next().and_then(whole) else {
            return self.skip(line, b"illum", "a whole number is expected");
        };
        let shown = match model {
            0 => Some("is a colour that no light changes; it is shown as model 1"),
            1 | HIGHLIGHTS => None,
            _ => Some("has more than diffuse light and highlights; it is shown as model 2"),
        };
        if let Some(shown) = shown {
            self.notices.add(&format!("model {model}"), Some(line), || {
                format!("the illumination model {model} {shown}")
            });
        }
        if let Some(entry) = self.last() {
            entry.model = Some(if model < 0 { HIGHLIGHTS } else { model });
        }
    }

    fn skip(&mut self, line: usize, keyword: &[u8], right: &str) {
        let what = quoted(keyword);
        self.notices.add(&format!("form of {what}"), Some(line), || {
            format!("a line {what} is passed over: {right} there")
        });
    }
}

/// The colour that words state: red, green and blue, or one number for all three; `None` for a
/// spectrum, CIE coordinates and what is no number.
fn colour(mut words: Words<'_>) -> Option<Colour> {
    let red = number(words.next()?)?;
    let other = |word: Option<&[u8]>| word.map_or(Some(red), number);
    let colour = [red, other(words.next())?, other(words.next())?];
    (!colour.iter().any(|x| x.is_nan())).then_some(colour)
}

/// Whether words state only this number.
fn states(words: Words<'_>, value: f64) -> bool {
    let mut words = words.peekable();
    words.peek().is_some() && words.all(|word| number(word) == Some(value))
}
