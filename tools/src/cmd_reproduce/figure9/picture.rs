//! The figure, labelled with its rows' numbers, titles and exponents.
use image::{Rgb, RgbImage};
use specula_experiments::figure9::{Balls, EXPONENTS, ROWS};
use specula_testbench::Image;

use specula_drawing::canvas::{CHARACTER, Canvas};

const PAPER: Rgb<u8> = Rgb([255, 255, 255]);
const INK: Rgb<u8> = Rgb([40, 40, 40]);

/// Adds titles on the left of `figure` and exponents below it.
pub fn labelled(balls: Balls, figure: &Image) -> RgbImage {
    let titles: Vec<String> =
        ROWS.iter().zip(1..).map(|(row, number)| format!("{number}. {}", row.title)).collect();
    let widest = titles.iter().map(|title| Canvas::text_width(title, 1)).max().unwrap_or(0);
    let (left, top) = (widest + 3 * CHARACTER, CHARACTER);
    let size = (left + figure.width + CHARACTER, top + figure.height + 3 * CHARACTER);
    let mut canvas = Canvas::new(size.0, size.1, PAPER, 1);
    for (place, &colour) in (0..).zip(&figure.pixels) {
        canvas.put(left + place % figure.width, top + place / figure.width, Rgb(colour));
    }
    for (title, number) in titles.iter().zip(0..) {
        let middle = top + figure.height - number * balls.apart() - balls.radius;
        canvas.write((CHARACTER, middle - CHARACTER / 2), title, INK);
    }
    for (n, ball) in EXPONENTS.iter().zip(1..) {
        let word = if ball == 1 { format!("n = {n}") } else { n.to_string() };
        let middle = left + ball * balls.radius;
        canvas.write(
            (middle - Canvas::text_width(&word, 1) / 2, top + figure.height + CHARACTER),
            &word,
            INK,
        );
    }
    canvas.finish()
}
