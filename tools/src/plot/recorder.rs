//! Records what `plotters` draws as marks of a sheet.
use std::convert::Infallible;

use plotters::style::RGBColor;
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontTransform,
};

use specula_drawing::{CAPITAL, CHARACTER, Ink, Mark, Point, light};

/// A drawing back end that records lines and text; axes consist of nothing else.
pub struct Recorder<'a> {
    size: (u32, u32),
    marks: &'a mut Vec<Mark>,
}

type Done = Result<(), DrawingErrorKind<Infallible>>;

impl<'a> Recorder<'a> {
    /// A back end of that size, which appends marks to `marks`.
    pub fn new(size: (u32, u32), marks: &'a mut Vec<Mark>) -> Recorder<'a> {
        Recorder { size, marks }
    }

    fn lines(&mut self, points: &[BackendCoord], colour: BackendColor) {
        if colour.alpha > 0.0 {
            let lines = points.windows(2).map(|ends| (point(ends[0]), point(ends[1]))).collect();
            self.marks.push(Mark::Lines(ink(colour), lines));
        }
    }
}

/// The colour by which [`Recorder`] recognises an ink of lines.
pub fn colour_of(ink: Ink) -> RGBColor {
    // Inks of lines have a stroke.
    let [red, green, blue] = light(ink).stroke.unwrap_or_default();
    RGBColor(red, green, blue)
}

/// The ink of a colour: the grid's, or else the axes'.
fn ink(colour: BackendColor) -> Ink {
    let RGBColor(red, green, blue) = colour_of(Ink::Grid);
    if colour.rgb == (red, green, blue) { Ink::Grid } else { Ink::Axis }
}

/// The middle of a pixel, where thin lines are crisp.
fn point((x, y): BackendCoord) -> Point {
    (f64::from(x) + 0.5, f64::from(y) + 0.5)
}

impl DrawingBackend for Recorder<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Done {
        Ok(())
    }

    fn present(&mut self) -> Done {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Done {
        self.lines(&[(x, y), (x + 1, y)], colour);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Done {
        self.lines(&[from, to], style.color());
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Done {
        self.lines(&path.into_iter().collect::<Vec<_>>(), style.color());
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &T,
        (x, y): BackendCoord,
    ) -> Done {
        let (x, y) = (f64::from(x), f64::from(y));
        let below = match style.anchor().v_pos {
            VPos::Top => CAPITAL,
            VPos::Center => CAPITAL / 2.0,
            VPos::Bottom => 0.0,
        };
        let words = text.to_owned();
        self.marks.push(match (style.transform(), style.anchor().h_pos) {
            (FontTransform::Rotate270, _) => Mark::TextUpwards(Ink::Aside, (x + below, y), words),
            (_, HPos::Left) => Mark::Text(Ink::Aside, (x, y + below), words),
            (_, HPos::Center) => Mark::TextCentred(Ink::Aside, (x, y + below), words),
            (_, HPos::Right) => Mark::TextEnding(Ink::Aside, (x, y + below), words),
        });
        Ok(())
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        _style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        Ok((text.chars().count() as u32 * CHARACTER as u32, CAPITAL as u32))
    }
}
