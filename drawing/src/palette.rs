//! Colours of the inks on light and on dark backgrounds.
use super::{Ink, SERIES, Series};

/// A colour: red, green and blue.
pub type Colour = [u8; 3];

/// How an ink paints: areas and text are filled, lines and borders are stroked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Paint {
    /// Colour of an area or of text.
    pub fill: Option<Colour>,
    /// Colour of lines.
    pub stroke: Option<Colour>,
}

/// Every ink, those of areas before those of text.
pub fn inks() -> impl Iterator<Item = Ink> {
    let series = (0..usize::from(SERIES)).map(Series::new);
    let of_series = series.flat_map(|series| [Ink::SeriesLine(series), Ink::Series(series)]);
    INKS.into_iter().chain(of_series)
}

/// Every ink except those of series.
const INKS: [Ink; 17] = [
    Ink::Paper,
    Ink::Marker,
    Ink::Grid,
    Ink::High,
    Ink::Level,
    Ink::Cell,
    Ink::Unknown,
    Ink::Highlight,
    Ink::Title,
    Ink::Unit,
    Ink::Name,
    Ink::Aside,
    Ink::Value,
    Ink::HighlightValue,
    Ink::MarkerNumber,
    Ink::Axis,
    Ink::Front,
];

/// Colours of series on light and on dark backgrounds. They can be told apart with any kind of
/// colour vision, and contrast with the background enough for text.
const OF_SERIES: [[u32; 2]; SERIES as usize] = [
    [0x05_50ae, 0x79_c0ff],
    [0xbc_4c00, 0xff_a657],
    [0x1a_7f37, 0x56_d364],
    [0xa4_0e26, 0xff_7b72],
    [0x6f_42c1, 0xd2_a8ff],
    [0x7d_4e00, 0xe3_b341],
    [0x0a_6a73, 0x4c_d7e0],
    [0xbf_3989, 0xff_9bce],
    [0x4d_555e, 0xb1_bac4],
];

/// Thickness of an ink's lines in pixels.
pub fn thickness(ink: Ink) -> f32 {
    match ink {
        Ink::Grid => 0.65,
        Ink::Front => 6.0,
        _ => 1.3,
    }
}

/// The paint of an ink on a light background.
pub fn light(ink: Ink) -> Paint {
    match ink {
        Ink::Paper => fill(0xff_ffff),
        Ink::Marker => fill(0xff_f3cd),
        Ink::Grid => stroke(0xd8_dee4),
        Ink::High => fill(0xe3_f6e7),
        Ink::Level => stroke(0x1a_7f37),
        Ink::Cell => both(0xf3_f6f9, 0x6e_7781),
        Ink::Unknown => both(0xff_d8d3, 0xc4_432b),
        Ink::Highlight => both(0xff_df8e, 0x9a_6700),
        Ink::Title | Ink::Name | Ink::Value => fill(0x1f_2328),
        Ink::Unit => fill(0x05_50ae),
        Ink::Aside => fill(0x59_636e),
        Ink::HighlightValue => fill(0x3d_2a00),
        Ink::MarkerNumber => fill(0x7d_4e00),
        Ink::Axis => stroke(0x6e_7781),
        Ink::Front => stroke(0xff_c83d),
        Ink::SeriesLine(series) => stroke(OF_SERIES[series.number()][0]),
        Ink::Series(series) => fill(OF_SERIES[series.number()][0]),
    }
}

/// The paint of an ink on a dark background.
pub fn dark(ink: Ink) -> Paint {
    match ink {
        Ink::Paper => fill(0x0d_1117),
        Ink::Marker => fill(0x2b_230d),
        Ink::Grid => stroke(0x26_2c36),
        Ink::High => fill(0x12_2b1a),
        Ink::Level => stroke(0x56_d364),
        Ink::Cell => both(0x1a_212b, 0x8b_949e),
        Ink::Unknown => both(0x5a_1e17, 0xff_7b72),
        Ink::Highlight => both(0x7a_5600, 0xe3_b341),
        Ink::Title | Ink::Name | Ink::Value => fill(0xe6_edf3),
        Ink::Unit => fill(0x79_c0ff),
        Ink::Aside => fill(0x91_98a1),
        Ink::HighlightValue => fill(0xff_f8e6),
        Ink::MarkerNumber => fill(0xe3_b341),
        Ink::Axis => stroke(0x8b_949e),
        Ink::Front => stroke(0x9a_6f00),
        Ink::SeriesLine(series) => stroke(OF_SERIES[series.number()][1]),
        Ink::Series(series) => fill(OF_SERIES[series.number()][1]),
    }
}

fn fill(rgb: u32) -> Paint {
    Paint { fill: Some(colour(rgb)), stroke: None }
}

fn stroke(rgb: u32) -> Paint {
    Paint { fill: None, stroke: Some(colour(rgb)) }
}

fn both(area: u32, border: u32) -> Paint {
    Paint { fill: Some(colour(area)), stroke: Some(colour(border)) }
}

fn colour(rgb: u32) -> Colour {
    let [_, red, green, blue] = rgb.to_be_bytes();
    [red, green, blue]
}
