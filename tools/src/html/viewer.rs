//! A viewer for pictures of one size, next to each other or one over another.
use super::render::{attribute, data};

/// A picture.
pub struct Picture {
    /// Its title, a word or two.
    pub name: &'static str,
    /// A sentence that describes it.
    pub description: &'static str,
    /// The contents of its PNG file.
    pub png: Vec<u8>,
}

/// Shows two of the pictures in one place, divided where the reader wants, and below them all
/// pictures. Browsers without scripts show only these.
pub fn viewer(pictures: &[Picture]) -> String {
    let figures: String = pictures.iter().map(figure).collect();
    let side = |side: &str, chosen: usize| {
        let option = |(number, picture): (usize, &Picture)| {
            let selected = if number == chosen { " selected" } else { "" };
            format!("<option value=\"{number}\"{selected}>{}</option>", attribute(picture.name))
        };
        let options: String = pictures.iter().enumerate().map(option).collect();
        format!("<label>{side} <select data-side=\"{side}\">{options}</select></label>\n")
    };
    format!(
        "<div class=\"viewer\" hidden>\n<div class=\"choice\">\n{}<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" \
         aria-label=\"where the left picture ends\">\n{}</div>\n\
         <div class=\"stage\"><img data-side=\"right\" alt=\"\"><img data-side=\"left\" alt=\"\"><i></i></div>\n</div>\n\
         <div class=\"pictures\">\n{figures}</div>\n",
        side("left", 0),
        side("right", pictures.len().saturating_sub(1))
    )
}

fn figure(picture: &Picture) -> String {
    let description = attribute(picture.description);
    let name = attribute(picture.name);
    format!(
        "<figure><img src=\"{}\" alt=\"{description}\"><figcaption><b>{name}</b>: {description}</figcaption></figure>\n",
        data(&picture.png)
    )
}
