//! The section about a paper, and the pictures that belong to it.
use std::fs;
use std::io;
use std::path::Path;

use image::RgbImage;
use specula_experiments::reproduce::{ClaimVerdict, Paper};

use super::figures;
use crate::error::ToolError;
use crate::picture::write_line_drawing;
use crate::table;
use specula_drawing as drawing;

/// The folder of pictures next to the document.
pub const IMAGES: &str = "images";

/// A paper's section of the document.
pub struct Section {
    /// Its Markdown.
    pub text: String,
    /// The pictures that the text shows.
    pub files: Vec<File>,
    /// Whether every number is as it was when it was first measured.
    pub as_expected: bool,
}

/// A picture's file.
pub struct File {
    /// Its name with its extension.
    pub name: String,
    content: Content,
}

enum Content {
    Svg(String),
    Png(RgbImage),
}

impl File {
    /// Writes the file.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        match &self.content {
            Content::Svg(text) => fs::write(path, text),
            Content::Png(picture) => write_line_drawing(path, picture),
        }
    }
}

impl Section {
    /// A section with the paper's claims, a verdict each, and its plots.
    pub fn of(paper: Paper) -> Result<Section, ToolError> {
        let verdicts = paper.verdicts();
        let mut section = Section {
            text: String::new(),
            files: vec![],
            as_expected: verdicts.iter().all(|verdict| verdict.as_expected),
        };
        section.heading(2, paper.title());
        section.table(
            ["claim", "measured quantity", "on", "measured", "before", "verdict"],
            &rows(&verdicts),
        );
        for figure in paper.figures() {
            section.plot(
                &figure.title,
                figure.name,
                drawing::svg(&figures::plot(&figure).render()?),
            );
        }
        Ok(section)
    }

    /// Adds a heading.
    pub fn heading(&mut self, level: usize, words: &str) {
        self.paragraph(&format!("{} {words}", "#".repeat(level)));
    }

    /// Adds a paragraph, or any other block, and an empty line.
    pub fn paragraph(&mut self, text: &str) {
        self.text.push_str(text.trim_end());
        self.text.push_str("\n\n");
    }

    /// Adds a table.
    pub fn table<const N: usize>(&mut self, titles: [&str; N], rows: &[[String; N]]) {
        self.paragraph(&table::markdown(titles, rows));
    }

    /// Adds a plot.
    fn plot(&mut self, title: &str, name: &str, svg: String) {
        self.show(title, format!("{name}.svg"), Content::Svg(svg));
    }

    /// Adds a picture.
    pub fn picture(&mut self, title: &str, name: &str, picture: RgbImage) {
        self.show(title, format!("{name}.png"), Content::Png(picture));
    }

    fn show(&mut self, title: &str, name: String, content: Content) {
        self.paragraph(&format!("![{title}]({IMAGES}/{name})"));
        self.files.push(File { name, content });
    }
}

/// A row for each verdict. A claim is written once, and so is a verdict that is the same in the
/// following rows of its claim.
fn rows(verdicts: &[ClaimVerdict]) -> Vec<[String; 6]> {
    let before = std::iter::once(None).chain(verdicts.iter().map(Some));
    let row = |(verdict, before): (&ClaimVerdict, Option<&ClaimVerdict>)| {
        let before = before.filter(|before| before.claim == verdict.claim);
        let again = before.is_some_and(|before| before.ruling == verdict.ruling);
        let expected = written(verdict.expected);
        [
            before.map_or(verdict.claim, |_| "").to_owned(),
            verdict.quantity.to_owned(),
            verdict.on.name().to_owned(),
            written(verdict.measured),
            if verdict.as_expected { expected } else { format!("{expected}: DIFFERS") },
            if again { "″".to_owned() } else { verdict.ruling.words() },
        ]
    };
    verdicts.iter().zip(before).map(row).collect()
}

/// A number with five significant digits, which are the same on every machine. What rounding leaves
/// of 0 is not the same and is written as 0.
pub fn written(number: f64) -> String {
    if !number.is_finite() {
        return number.to_string();
    }
    if number.abs() < 1e-9 {
        return "0".to_owned();
    }
    let decimals = (4 - libm::floor(libm::log10(number.abs())) as i32).clamp(0, 12) as usize;
    let text = format!("{number:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn numbers_have_five_digits() {
        assert_eq!(
            [0.0126887123, 214.0004, 1e-12, -0.5, 123456.7, 1.00176].map(written),
            ["0.012689", "214", "0", "-0.5", "123457", "1.0018"]
        );
        assert_eq!(written(f64::NAN), "NaN");
    }
}
