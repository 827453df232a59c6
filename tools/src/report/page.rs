//! The report for browsers: the report for people, with pictures that can be laid over one another.
use std::fs;
use std::io;

use super::pictures::{LAYERED_PICTURES, LayeredPicture};
use super::{Report, markdown};
use crate::html::{Picture, page, render, viewer};
use crate::output::Staging;
use crate::picture;

/// The text of `report.html`, made from the files that have been written.
///
/// # Errors
/// The system's error if a file cannot be read.
pub fn html(report: &Report, staging: &Staging) -> io::Result<String> {
    let title = format!("{}, shaded by {}", report.scene, report.method);
    let body = [
        render(&markdown::head(report), staging)?,
        "<h2>Pictures</h2>\n".to_owned(),
        viewer(&pictures(report, staging)?),
        render(&markdown::heat_map(), staging)?,
        render(&markdown::rest(report), staging)?,
    ];
    Ok(page(&title, &body.concat()))
}

fn pictures(report: &Report, staging: &Staging) -> io::Result<Vec<Picture>> {
    let read = |&LayeredPicture { name, file, description }: &LayeredPicture| {
        Ok(Picture { name, description, png: fs::read(staging.file(file))? })
    };
    let mut pictures: Vec<Picture> =
        LAYERED_PICTURES.iter().map(read).collect::<io::Result<_>>()?;
    pictures.push(Picture {
        name: "error",
        description: "total error of each pixel, in the colours of the scale below",
        png: picture::png(&picture::heat_picture(&report.run.outcome.comparison))?,
    });
    Ok(pictures)
}
