//! Markdown as HTML, with the files it shows put into it.
use std::fs;
use std::io;
use std::path::PathBuf;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

/// Where a report's files are: those that it shows are put into it.
pub trait Beside {
    /// The place of the file `name`.
    fn file(&self, name: &str) -> Option<PathBuf>;
}

/// A report's Markdown as HTML. Pictures become data, drawings elements of the page; links to files
/// beside it are left out, since the page stands alone.
///
/// # Errors
/// What the system says of a file that cannot be read.
pub fn render(markdown: &str, beside: &impl Beside) -> io::Result<String> {
    let mut events = vec![];
    let mut parser = Parser::new_ext(markdown, Options::ENABLE_TABLES);
    while let Some(event) = parser.next() {
        match event {
            Event::Start(Tag::Link { .. }) | Event::End(TagEnd::Link) => {}
            Event::Start(Tag::Image { dest_url, .. }) => {
                let alternative = words(&mut parser);
                events.push(Event::Html(figure(&dest_url, &alternative, beside)?.into()));
            }
            // No report has HTML in it; a name may look like some.
            Event::Html(text) | Event::InlineHtml(text) => events.push(Event::Text(text)),
            // Wide tables are scrolled, not the page.
            Event::Start(Tag::Table(alignments)) => {
                events.extend([
                    Event::Html(CowStr::from("<div class=\"scroll\">")),
                    Event::Start(Tag::Table(alignments)),
                ]);
            }
            Event::End(TagEnd::Table) => {
                events.extend([Event::End(TagEnd::Table), Event::Html(CowStr::from("</div>\n"))])
            }
            other => events.push(other),
        }
    }
    let mut text = String::new();
    html::push_html(&mut text, events.into_iter());
    Ok(text)
}

/// The words that stand for a picture, up to its end.
fn words<'a>(events: &mut impl Iterator<Item = Event<'a>>) -> String {
    let until_end = events.take_while(|event| !matches!(event, Event::End(TagEnd::Image)));
    until_end
        .filter_map(|event| {
            if let Event::Text(text) | Event::Code(text) = event {
                Some(text.to_string())
            } else {
                None
            }
        })
        .collect()
}

fn figure(file: &str, alternative: &str, beside: &impl Beside) -> io::Result<String> {
    let place = beside.file(file).filter(|place| place.is_file());
    let alternative = attribute(alternative);
    match place {
        Some(place) if file.ends_with(".svg") => {
            Ok(format!("<span class=\"drawing\">{}</span>", fs::read_to_string(place)?))
        }
        Some(place) => {
            Ok(format!("<img src=\"{}\" alt=\"{alternative}\">", data(&fs::read(place)?)))
        }
        None => Ok(format!("<em>{alternative}</em>")),
    }
}

/// A PNG as an address that holds it.
pub fn data(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// As attributes take it.
pub fn attribute(text: &str) -> String {
    specula_drawing::escaped(text).replace('"', "&quot;")
}
