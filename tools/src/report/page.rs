//! The report for browsers: that for people, with pictures to be laid one over another.
use std::fs;
use std::io;

use super::markdown;
use crate::html::{Picture, page, render, viewer};
use crate::output::Staging;
use crate::picture;
use crate::run::{Run, Written};

/// `report.html`, made of the files that have been written. `shown` are names, files and meanings
/// of the pictures.
///
/// # Errors
/// What the system says of a file that cannot be read.
pub fn html(
    run: &Run,
    written: &Written,
    staging: &Staging,
    shown: &[[&'static str; 3]],
) -> io::Result<String> {
    let title = format!("{}, shaded by {}", run.name(), run.bench.spec.method().name());
    let pictures = pictures(run, staging, shown)?;
    let body = [
        render(&markdown::head(run), staging)?,
        "<h2>Pictures</h2>\n".to_owned(),
        viewer(&pictures),
        render(markdown::HEAT_MAP, staging)?,
        render(&markdown::rest(run, written), staging)?,
    ];
    Ok(page(&title, &body.concat()))
}

fn pictures(run: &Run, staging: &Staging, shown: &[[&'static str; 3]]) -> io::Result<Vec<Picture>> {
    let read = |&[name, file, about]: &[&'static str; 3]| {
        Ok(Picture { name, about, png: fs::read(staging.file(file))? })
    };
    let mut pictures: Vec<Picture> = shown.iter().map(read).collect::<io::Result<_>>()?;
    let png = picture::png(&picture::heat_picture(&run.outcome.comparison))?;
    pictures.push(Picture {
        name: "error",
        about: "total error of each pixel, in the colours of the scale below",
        png,
    });
    Ok(pictures)
}
