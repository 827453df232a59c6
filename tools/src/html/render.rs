//! Renders Markdown as HTML, with pictures embedded.
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

/// The files next to a report; those that it shows are embedded.
pub trait ReportFiles {
    /// Why a file cannot be read.
    type Error;

    /// The content of the file `name`; `None` if there is no such file.
    ///
    /// # Errors
    /// If it cannot be read.
    fn content(&self, name: &str) -> Result<Option<Vec<u8>>, Self::Error>;
}

/// Renders a report's Markdown as HTML. Bitmaps become data, drawings become elements of the page.
/// Links to files next to it are removed, since the page stands alone.
///
/// # Errors
/// If a file cannot be read.
pub fn render<F: ReportFiles>(markdown: &str, files: &F) -> Result<String, F::Error> {
    let mut events = vec![];
    let mut parser = Parser::new_ext(markdown, Options::ENABLE_TABLES);
    while let Some(event) = parser.next() {
        match event {
            Event::Start(Tag::Link { .. }) | Event::End(TagEnd::Link) => {}
            Event::Start(Tag::Image { dest_url, .. }) => {
                let alternative = words(&mut parser);
                events.push(Event::Html(figure(&dest_url, &alternative, files)?.into()));
            }
            // No report contains HTML, but a name may look like it.
            Event::Html(text) | Event::InlineHtml(text) => events.push(Event::Text(text)),
            // A wide table scrolls by itself, so that the page does not have to.
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

/// Reads the alternative text of a picture, up to the picture's end.
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

fn figure<F: ReportFiles>(file: &str, alternative: &str, files: &F) -> Result<String, F::Error> {
    let alternative = attribute(alternative);
    Ok(match files.content(file)? {
        Some(bytes) if file.ends_with(".svg") => {
            format!("<span class=\"drawing\">{}</span>", String::from_utf8_lossy(&bytes))
        }
        Some(bytes) => format!("<img src=\"{}\" alt=\"{alternative}\">", data(&bytes)),
        None => format!("<em>{alternative}</em>"),
    })
}

/// A PNG as a data URL.
pub fn data(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// The text escaped for an attribute.
pub fn attribute(text: &str) -> String {
    specula_drawing::escaped(text).replace('"', "&quot;")
}
