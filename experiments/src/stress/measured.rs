//! Measurements of a core that has shaded a scene, and the requirements on them.
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_spec::FULL_SCALE;

use super::limits::{EXACT, Limits, Reason, Rounding};
use super::requirement::{QUANTISATION, Requirement};
use super::row::{PixelPlace, RowRequirement, Shaded};
use specula_testbench::{Bench, Outcome};

/// A number of things, and the first of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counted {
    /// How many exist.
    pub number: u64,
    /// The place of the first one.
    pub first: Option<PixelPlace>,
    /// Further information about the first one.
    pub detail: Option<String>,
}

/// A pixel that is farther than [`EXACT`] from exact shading.
#[derive(Clone, Debug, PartialEq)]
pub struct Far {
    /// The difference in LSBs.
    pub lsb: f64,
    /// The allowed difference in LSBs.
    pub limit: f64,
    /// The reasons for which it is allowed.
    pub reasons: Vec<Reason>,
    /// The place of the pixel.
    pub place: PixelPlace,
}

/// An error in LSBs and its place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Largest {
    /// The error.
    pub lsb: f64,
    /// The place of its pixel.
    pub place: PixelPlace,
}

/// The measurements of one core.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measurements {
    /// Number of pixels shaded.
    pub pixels: u64,
    /// Codes that differ from the bit-true model's.
    pub mismatches: Counted,
    /// Clocks with a pixel that is not due, or without one that is due.
    pub wrong_clocks: Counted,
    /// Stated facts that do not hold; only the first is recorded.
    pub broken_facts: Counted,
    /// Shades of the method or of exact shading that are not numbers from 0 to 255.
    pub no_shades: Counted,
    /// Total error.
    pub total: Largest,
    /// Error of the method in exact arithmetic.
    pub method: Largest,
    /// Error of quantisation.
    pub quantisation: Largest,
    /// The proven bound of that error; 255 LSB and more say nothing.
    pub bound: f64,
    /// Of the pixels beyond 1 LSB, the one that is closest to its limit, or farthest beyond it.
    pub nearest: Option<Far>,
    /// The farthest pixel of those without a limit.
    pub unlimited: Option<Far>,
    /// The row's requirements on this core, and how often each is not met (0 or 1).
    pub of_row: Vec<(&'static str, Counted)>,
}

impl Measurements {
    /// Measures every pixel.
    pub fn new(
        bench: &Bench,
        outcome: &Outcome,
        requirements: &[RowRequirement],
        figure: Option<f64>,
    ) -> Measurements {
        let shaded = Shaded { spec: bench.spec, frame: bench.frame, outcome };
        let bound = bench.design.error_bound();
        let mut measured =
            Measurements { pixels: outcome.pixels, bound, ..Measurements::default() };
        measured.agreement(bench, outcome);
        measured.survey(&shaded, Rounding { bound, figure });
        let of_core =
            requirements.iter().filter(|requirement| (requirement.applies_to)(bench.spec));
        measured.of_row = of_core
            .map(|requirement| (requirement.what, Counted::of((requirement.fails)(&shaded))))
            .collect();
        measured
    }

    /// Counts pixels that differ from the model's, wrong clocks, and facts that do not hold.
    fn agreement(&mut self, bench: &Bench, outcome: &Outcome) {
        let first = outcome.comparison.first_mismatch.as_ref();
        self.mismatches = Counted {
            number: outcome.comparison.mismatches,
            first: first.map(|wrong| PixelPlace { span: wrong.span, pixel: wrong.pixel }),
            detail: first.map(|wrong| {
                format!(
                    "the code {:?}, and the bit-true model has {:?}",
                    wrong.simulated, wrong.expected
                )
            }),
        };
        let clock = outcome.wrong_clocks.first();
        self.wrong_clocks = Counted {
            number: outcome.wrong_clocks.len() as u64,
            first: clock.map(|&clock| pixel_of(bench, clock)),
            detail: clock.map(|clock| format!("clock {clock}")),
        };
        let fact = outcome.violation.as_ref().map(|fact| (fact.clock, fact.in_words()));
        let moved = || outcome.moved_input.as_ref().map(|moved| (moved.clock, moved.in_words()));
        let broken = fact.or_else(moved);
        self.broken_facts = Counted {
            number: u64::from(broken.is_some()),
            first: broken.as_ref().map(|(clock, _)| pixel_of(bench, *clock)),
            detail: broken.map(|(_, detail)| detail),
        };
    }

    /// Measures the difference of every pixel from the method and from exact shading.
    fn survey(&mut self, shaded: &Shaded, rounding: Rounding) {
        let image = &shaded.outcome.simulated;
        for (number, span) in shaded.frame.spans.iter().enumerate() {
            let (method, exact) = (
                MethodSpan::new(shaded.spec, shaded.frame, span),
                PhongSpan::new(shaded.frame, span),
            );
            let mut limits = None;
            for i in 0..span.length {
                let place = PixelPlace { span: number, pixel: i };
                let code =
                    image.pixels[(span.y * image.width + span.x + i) as usize].map(f64::from);
                let (method, exact) = (method.pixel(i), exact.pixel(i));
                if !method.iter().chain(&exact).all(|lsb| (0.0..=FULL_SCALE).contains(lsb)) {
                    self.no_shades.add(place);
                }
                let off = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|c| f64::abs(a[c] - b[c]));
                let total: [f64; 3] = off(code, exact);
                self.total.add(total, place);
                self.method.add(off(method, exact), place);
                self.quantisation.add(off(code, method), place);
                if total.iter().any(|&lsb| lsb > EXACT) {
                    let limits = limits.get_or_insert_with(|| {
                        Limits::new(shaded.spec, shaded.frame, span, rounding)
                    });
                    let limit = limits.at_pixel(i);
                    for (lsb, limit_lsb) in
                        total.into_iter().zip(limit.lsb).filter(|(lsb, _)| *lsb > EXACT)
                    {
                        self.add_far(Far {
                            lsb,
                            limit: limit_lsb,
                            reasons: limit.reasons.clone(),
                            place,
                        });
                    }
                }
            }
        }
    }

    fn add_far(&mut self, far: Far) {
        if far.limit >= FULL_SCALE {
            if self.unlimited.as_ref().is_none_or(|before| far.lsb > before.lsb) {
                self.unlimited = Some(far);
            }
        } else if self
            .nearest
            .as_ref()
            .is_none_or(|before| far.lsb / far.limit > before.lsb / before.limit)
        {
            self.nearest = Some(far);
        }
    }

    /// All requirements on this core, and their results.
    pub fn asked(&self) -> Vec<Requirement> {
        let none_of = |what: &str, of: &Counted| Requirement {
            detail: of.detail.clone(),
            ..Requirement::none_of(what, of.number, of.first)
        };
        let everywhere = [
            none_of("pixels other than the bit-true model's", &self.mismatches),
            none_of("clocks without their pixel", &self.wrong_clocks),
            none_of("stated facts that do not hold", &self.broken_facts),
            none_of("shades that are no number from 0 to 255", &self.no_shades),
            self.quantisation(),
        ];
        let of_row =
            self.of_row.iter().map(|(what, of)| Requirement { of_row: true, ..none_of(what, of) });
        everywhere.into_iter().chain(self.distances()).chain(of_row).collect()
    }

    fn quantisation(&self) -> Requirement {
        let (came, place) = (self.quantisation.lsb, Some(self.quantisation.place));
        if self.bound < FULL_SCALE {
            Requirement::within(QUANTISATION, Some(self.bound), came, place)
        } else {
            Requirement::within("LSB of quantisation, of cores without a bound", None, came, place)
        }
    }

    /// The requirements on the difference from exact shading.
    fn distances(&self) -> Vec<Requirement> {
        let far = |what: &str, far: &Far, most: Option<f64>| Requirement {
            reasons: far.reasons.clone(),
            ..Requirement::within(what, most, far.lsb, Some(far.place))
        };
        let nearest = self
            .nearest
            .as_ref()
            .map(|near| far("LSB off, within the method's limit", near, Some(near.limit)));
        let unlimited = self
            .unlimited
            .as_ref()
            .map(|most| far("LSB off, where the method has no limit", most, None));
        let all: Vec<Requirement> = nearest.into_iter().chain(unlimited).collect();
        if all.is_empty() {
            return vec![Requirement::within(
                "LSB off",
                Some(EXACT),
                self.total.lsb,
                Some(self.total.place),
            )];
        }
        all
    }
}

impl Counted {
    fn of(first: Option<PixelPlace>) -> Counted {
        Counted { number: u64::from(first.is_some()), first, detail: None }
    }

    fn add(&mut self, place: PixelPlace) {
        self.number += 1;
        self.first.get_or_insert(place);
    }
}

impl Largest {
    fn add(&mut self, channels: [f64; 3], place: PixelPlace) {
        let lsb = channels.into_iter().fold(0.0, f64::max);
        if lsb > self.lsb {
            *self = Largest { lsb, place };
        }
    }
}

/// The pixel that leaves in a clock, or the last one before it.
fn pixel_of(bench: &Bench, clock: u64) -> PixelPlace {
    let mut left = clock.saturating_sub(u64::from(bench.design.latency()));
    let interval = u64::from(bench.design.interval);
    for (span, clocks) in
        bench.frame.spans.iter().map(|span| u64::from(span.length) * interval).enumerate()
    {
        match left.checked_sub(clocks) {
            Some(rest) => left = rest,
            // The difference is less than a span's length.
            None => return PixelPlace { span, pixel: (left / interval) as u32 },
        }
    }
    PixelPlace { span: bench.frame.spans.len().saturating_sub(1), pixel: 0 }
}

#[cfg(test)]
mod tests {
    use specula_scene::{Needs, parse};
    use specula_spec::{CoreSpec, Method};

    use super::super::draw::tilted;
    use super::super::requirement::RowVerdict;
    use super::super::row::all;
    use super::super::scene::{RawSpan, SpanScene, lit};
    use super::super::variant::Variant;
    use super::*;
    use specula_testbench::EngineKind;

    /// The measurements of a span on which every method has something to compute; `tamper` may
    /// change the outcome beforehand.
    fn measured(method: Method, tamper: impl FnOnce(&mut Outcome)) -> Measurements {
        let span = RawSpan::between([tilted(-20.0), tilted(25.0)], 40, lit(16));
        let frame = parse("span.toml", SpanScene::new(&[tilted(10.0)], vec![span]).text(""))
            .expect("it is a scene")
            .frame;
        let spec: CoreSpec =
            Variant::default_of(method).core_spec(&Needs::of(&frame)).expect("it has a core");
        let bench = Bench::new(&frame, &spec, "core").expect("it can be built");
        let mut outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).expect("it runs");
        tamper(&mut outcome);
        let requirement = RowRequirement {
            what: "no black pixel",
            applies_to: all,
            fails: Box::new(shaded_black),
        };
        Measurements::new(&bench, &outcome, &[requirement], None)
    }

    fn shaded_black(shaded: &Shaded) -> Option<PixelPlace> {
        let black = shaded.outcome.simulated.pixels.iter().position(|&pixel| pixel == [0; 3])?;
        Some(PixelPlace { span: 0, pixel: black as u32 })
    }

    fn faults(measured: &Measurements) -> Vec<String> {
        let asked = measured.asked();
        asked
            .iter()
            .filter(|asked| asked.verdict() == RowVerdict::Fault)
            .map(|asked| asked.what.clone())
            .collect()
    }

    #[test]
    fn what_came_of_an_honest_core_is_no_fault() {
        for method in Method::ALL {
            assert_eq!(
                faults(&measured(method, |_| ())),
                Vec::<String>::new(),
                "{}",
                method.name()
            );
        }
    }

    /// The picture is corrupted: one code is farther from the method than the bound, and from exact
    /// shading than an exact method may be.
    #[test]
    fn a_code_that_is_off_is_a_fault() {
        for method in Method::ALL {
            let honest = measured(method, |_| ());
            let is_exact = honest.nearest.is_none() && honest.unlimited.is_none();
            let changed = measured(method, |outcome| {
                let code = &mut outcome.simulated.pixels[20][1];
                *code = if *code > 127 { 1 } else { 254 };
            });
            let faults = faults(&changed);
            assert!(faults.contains(&QUANTISATION.to_owned()), "{}: {faults:?}", method.name());
            let is_far = faults.iter().any(|what| what.starts_with("LSB off"));
            assert!(is_far || !is_exact, "{}: {faults:?}", method.name());
        }
    }

    /// A pixel that is wrong by two codes is enough to fail an exact method.
    #[test]
    fn two_codes_are_enough_of_an_exact_method() {
        let changed = measured(Method::Phong, |outcome| outcome.simulated.pixels[20][1] += 2);
        assert_eq!(faults(&changed), [QUANTISATION, "LSB off, within the method's limit"]);
        let black = measured(Method::Phong, |outcome| outcome.simulated.pixels[7] = [0; 3]);
        assert!(faults(&black).contains(&"no black pixel".to_owned()));
    }

    type Tamper<'a> = &'a dyn Fn(&mut Measurements);

    /// Each requirement can fail by itself.
    #[test]
    fn whatever_is_tampered_with_is_a_fault() {
        let honest = measured(Method::Lyon, |_| ());
        let one =
            || Counted { number: 1, first: Some(PixelPlace { span: 0, pixel: 3 }), detail: None };
        let tamper: [(&str, Tamper); 7] = [
            ("pixels other than the bit-true model's", &|m| m.mismatches = one()),
            ("clocks without their pixel", &|m| m.wrong_clocks = one()),
            ("stated facts that do not hold", &|m| m.broken_facts = one()),
            ("shades that are no number from 0 to 255", &|m| m.no_shades = one()),
            (QUANTISATION, &|m| m.quantisation.lsb = m.bound + 1e-9),
            ("LSB off, within the method's limit", &|m| {
                let limit = m.nearest.as_ref().map_or(1.0, |far| far.limit);
                let place = PixelPlace::default();
                m.nearest =
                    Some(Far { lsb: limit + 1e-9, limit, reasons: vec![Reason::Lobe], place });
            }),
            ("no black pixel", &|m| m.of_row = vec![("no black pixel", one())]),
        ];
        for (what, change) in tamper {
            let mut measured = honest.clone();
            change(&mut measured);
            assert_eq!(faults(&measured), [what]);
        }
        let nan = Measurements {
            quantisation: Largest { lsb: f64::NAN, ..honest.quantisation },
            ..honest
        };
        assert_eq!(faults(&nan), [QUANTISATION]);
    }

    /// A bound of 255 LSB says nothing: it is reported as no bound, and never as one that holds.
    #[test]
    fn a_bound_of_full_scale_is_none() {
        let unbounded = Measurements { bound: FULL_SCALE, ..measured(Method::Phong, |_| ()) };
        let asked = unbounded.asked();
        let of = asked
            .iter()
            .find(|asked| asked.what.starts_with("LSB of quantisation"))
            .expect("it is asked everywhere");
        assert_eq!(
            (of.what.as_str(), of.most),
            ("LSB of quantisation, of cores without a bound", None)
        );
    }
}
