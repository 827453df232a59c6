//! Reports as one HTML file that needs no other file: pictures are embedded in it, and it is light
//! or dark as the reader's system is.
//!
//! The text is that of the Markdown report, rendered by `pulldown-cmark`. What looks like HTML, for
//! example in a name, is shown as it is written. A policy in the file keeps browsers from loading
//! anything from elsewhere.
mod render;
mod viewer;

pub use render::{ReportFiles, render};
pub use viewer::{Picture, viewer};

use specula_drawing::escaped;

/// The file name of the HTML report.
pub const FILE: &str = "report.html";

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("viewer.js");
/// Browsers may load only what is in the file.
const POLICY: &str =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

/// A page with this title and body.
pub fn page(title: &str, body: &str) -> String {
    let title = escaped(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n{body}</main>\n<script>\n{SCRIPT}</script>\n\
         </body>\n</html>\n"
    )
}

#[cfg(test)]
mod tests;
