//! A sheet as SVG: one file, light or dark as the reader's system is.
use std::collections::HashSet;
use std::fmt::Write;

use super::palette::{Colour, Paint, dark, inks, light};
use super::{Ink, Mark, Point, Sheet};

/// Styles of shapes and text; [`colours`] adds their colours.
const STYLE: &str = "\
text{font:12px ui-monospace,SFMono-Regular,Menlo,Consolas,'DejaVu Sans Mono',monospace;white-space:pre}
.title,.unit,.highlight-value,.marker-number{font-weight:600}
path{stroke-width:1.3;stroke-linejoin:round}
.grid{stroke-width:.7}
.front{stroke-width:6}
";

/// The sheet as an SVG file.
pub fn svg(sheet: &Sheet) -> String {
    let Sheet { title, size: (width, height), marks } = sheet;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\n\
         <title>{}</title>\n<style>\n{STYLE}{}</style>\n<rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n",
        escaped(title),
        colours(sheet)
    );
    marks.iter().for_each(|mark| push(&mut text, mark));
    text.push_str("</svg>\n");
    text
}

/// The rules for colours on a light background, then those for readers who prefer dark. Programs
/// that do not know the media rule draw the light ones.
fn colours(sheet: &Sheet) -> String {
    let used: HashSet<Ink> = sheet.marks.iter().map(Mark::ink).chain([Ink::Paper]).collect();
    let rules = |paint: fn(Ink) -> Paint| -> String {
        inks().filter(|ink| used.contains(ink)).map(|ink| rule(ink, paint(ink))).collect()
    };
    format!("{}@media (prefers-color-scheme:dark){{\n{}}}\n", rules(light), rules(dark))
}

fn rule(ink: Ink, paint: Paint) -> String {
    let colour = |colour: Option<Colour>| {
        colour.map_or("none".to_owned(), |[red, green, blue]| {
            format!("#{red:02x}{green:02x}{blue:02x}")
        })
    };
    let stroke =
        paint.stroke.map(|rgb| format!(";stroke:{}", colour(Some(rgb)))).unwrap_or_default();
    format!(".{}{{fill:{}{stroke}}}\n", class(ink), colour(paint.fill))
}

fn push(svg: &mut String, mark: &Mark) {
    // Writing to a String cannot fail.
    let _ = match mark {
        Mark::Box(ink, (x, y), (width, height)) => {
            let (x, y, width, height) = (number(*x), number(*y), number(*width), number(*height));
            writeln!(
                svg,
                "<rect class=\"{}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>",
                class(*ink)
            )
        }
        Mark::Lines(ink, lines) => {
            path(svg, *ink, lines.iter().map(|(from, to)| through(&[*from, *to])))
        }
        Mark::Traces(ink, traces) => path(svg, *ink, traces.iter().map(|points| through(points))),
        Mark::Areas(ink, areas) => {
            path(svg, *ink, areas.iter().map(|points| through(points) + "Z"))
        }
        Mark::Text(ink, place, words) => text(svg, *ink, "start", *place, words),
        Mark::TextEnding(ink, place, words) => text(svg, *ink, "end", *place, words),
        Mark::TextCentred(ink, place, words) => text(svg, *ink, "middle", *place, words),
        Mark::TextUpwards(ink, place, words) => upwards(svg, *ink, *place, words),
        Mark::Dots(ink, places, radius) => places.iter().try_for_each(|&(x, y)| {
            writeln!(
                svg,
                "<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{radius}\"/>",
                class(*ink),
                number(x),
                number(y)
            )
        }),
    };
}

/// Writes one element for all pieces: a drawing has thousands of them.
fn path(svg: &mut String, ink: Ink, pieces: impl Iterator<Item = String>) -> std::fmt::Result {
    let pieces: String = pieces.collect();
    if pieces.is_empty() {
        Ok(())
    } else {
        writeln!(svg, "<path class=\"{}\" d=\"{pieces}\"/>", class(ink))
    }
}

fn text(svg: &mut String, ink: Ink, anchor: &str, (x, y): Point, words: &str) -> std::fmt::Result {
    let anchor =
        if anchor == "start" { String::new() } else { format!(" text-anchor=\"{anchor}\"") };
    writeln!(
        svg,
        "<text class=\"{}\" x=\"{}\" y=\"{}\"{anchor}>{}</text>",
        class(ink),
        number(x),
        number(y),
        escaped(words)
    )
}

/// Writes text that is turned about its place to run upwards.
fn upwards(svg: &mut String, ink: Ink, (x, y): Point, words: &str) -> std::fmt::Result {
    let (x, y) = (number(x), number(y));
    writeln!(
        svg,
        "<text class=\"{}\" text-anchor=\"middle\" transform=\"translate({x} {y}) rotate(-90)\">{}</text>",
        class(ink),
        escaped(words)
    )
}

fn through(points: &[Point]) -> String {
    let place = |&(x, y): &Point| format!("{} {}", number(x), number(y));
    format!("M{}", points.iter().map(place).collect::<Vec<_>>().join("L"))
}

/// A length, to a tenth of a pixel.
fn number(length: f64) -> String {
    let text = format!("{length:.1}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// The text with the characters escaped that XML reserves.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn class(ink: Ink) -> String {
    let name = match ink {
        Ink::SeriesLine(series) => return format!("line-{}", series.number()),
        Ink::Series(series) => return format!("series-{}", series.number()),
        Ink::Paper => "paper",
        Ink::Title => "title",
        Ink::Unit => "unit",
        Ink::Name => "name",
        Ink::Aside => "aside",
        Ink::Grid => "grid",
        Ink::Level => "level",
        Ink::High => "high",
        Ink::Cell => "cell",
        Ink::Unknown => "unknown",
        Ink::Highlight => "highlight",
        Ink::Value => "value",
        Ink::HighlightValue => "highlight-value",
        Ink::Marker => "marker",
        Ink::MarkerNumber => "marker-number",
        Ink::Axis => "axis",
        Ink::Front => "front",
    };
    name.to_owned()
}
