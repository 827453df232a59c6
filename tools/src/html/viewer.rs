//! Pictures of one size, side by side or one over another.
use super::render::{attribute, data};

/// A picture.
pub struct Picture {
    /// What it shows, in a word or two.
    pub name: &'static str,
    /// What it shows.
    pub about: &'static str,
    /// As a PNG file.
    pub png: Vec<u8>,
}

/// Two of the pictures in one place, divided where the reader wants, and all of them below. Without
/// scripts only these are shown.
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
    let about = attribute(picture.about);
    let name = attribute(picture.name);
    format!(
        "<figure><img src=\"{}\" alt=\"{about}\"><figcaption><b>{name}</b>: {about}</figcaption></figure>\n",
        data(&picture.png)
    )
}
