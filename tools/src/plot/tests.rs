//! Plots of made-up numbers.
use super::labels::{Area, placed};
use super::*;
use specula_drawing::{self as drawing, CAPITAL, CHARACTER, Series};

fn axis(title: &str, scale: AxisScale) -> Axis {
    Axis { title: title.to_owned(), scale }
}

fn plot(scale: AxisScale, places: Vec<PlotPoint>) -> Plot {
    let front = specula_experiments::pareto_front(&places).into_iter().map(|k| places[k]).collect();
    let label =
        |&at: &PlotPoint| Label { at, words: format!("{} {}", at.0, at.1), colour: Series::new(0) };
    Plot {
        title: "Error against <size>".to_owned(),
        x: axis("size in bits", scale),
        y: axis("error in LSB", scale),
        labels: places.iter().map(label).collect(),
        series: vec![PlotSeries {
            colour: Series::new(0),
            places,
            style: SeriesStyle::LineWithDots,
        }],
        front,
        notes: vec!["A note.".to_owned()],
    }
}

#[test]
fn a_plot_is_drawn() {
    let places = vec![(100.0, 8.0), (250.0, 2.0), (1000.0, 0.5), (4000.0, 0.6)];
    let svg = drawing::svg(&plot(AxisScale::Logarithmic, places).render().expect("it has room"));
    insta::assert_snapshot!(svg);
}

/// Plots with numbers that an axis cannot show, with no numbers, with one number, and with equal
/// numbers.
#[test]
fn odd_numbers_do_no_harm() {
    for scale in [AxisScale::Linear, AxisScale::Logarithmic] {
        for places in [
            vec![],
            vec![(0.0, 0.0)],
            vec![(1.0, 1.0)],
            vec![(5.0, 5.0); 9],
            vec![(f64::NAN, 1.0), (1.0, f64::INFINITY), (-1.0, 2.0)],
            vec![(1e-300, 1e300), (1e300, 1e-300)],
        ] {
            let sheet = plot(scale, places).render().expect("it has room");
            let svg = drawing::svg(&sheet);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            assert!(drawing::png(&sheet).is_some());
        }
    }
}

#[test]
fn labels_do_not_overlap() {
    let within = Area { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };
    let labels: Vec<((f64, f64), &str)> =
        (0..24).map(|k| ((200.0 + f64::from(k % 5), 150.0 + f64::from(k / 5)), "label")).collect();
    let areas: Vec<Area> = placed(&labels, &[], &within)
        .into_iter()
        .flatten()
        .map(|label| Area {
            left: label.begin.0,
            top: label.begin.1 - CAPITAL,
            right: label.begin.0 + 5.0 * CHARACTER,
            bottom: label.begin.1,
        })
        .collect();
    assert!(areas.len() > 12, "{} of 24 have room", areas.len());
    for (k, one) in areas.iter().enumerate() {
        for other in &areas[..k] {
            let apart = one.right <= other.left
                || other.right <= one.left
                || one.bottom <= other.top
                || other.bottom <= one.top;
            assert!(apart, "{one:?} {other:?}");
        }
    }
}

#[test]
fn ticks_are_round_and_few() {
    let ticks = |scale: AxisScale, low: f64, high: f64| -> Vec<String> {
        let range = scale.place(low).unwrap_or(0.0)..scale.place(high).unwrap_or(1.0);
        scale.ticks(&range).into_iter().map(|place| axis::written(scale.number(place))).collect()
    };
    assert_eq!(ticks(AxisScale::Linear, 0.0, 10.0), ["0", "2", "4", "6", "8", "10"]);
    assert_eq!(
        ticks(AxisScale::Logarithmic, 0.9, 250.0),
        ["1", "2", "5", "10", "20", "50", "100", "200"]
    );
    assert_eq!(ticks(AxisScale::Logarithmic, 0.25, 0.45), ["0.3", "0.4"]);
    assert!(ticks(AxisScale::Logarithmic, 1e-300, 1e300).len() <= 9);
}
