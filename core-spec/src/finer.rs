//! Cores with finer or coarser formats.
use specula_datapath::Format;

use crate::core_spec::CoreSpec;
use crate::narrowing::NarrowingPoint;

impl CoreSpec {
    /// The same core for any scene with all formats finer by `added` fraction bits, or coarser
    /// where that is negative, but for those that are `kept`, and each as far as it may be. None
    /// where nothing changes or no such core can be described.
    pub fn finer(&self, added: i32, kept: &[&str]) -> Option<CoreSpec> {
        let finer = |point: NarrowingPoint| {
            let bits = point.format.fraction_bits.saturating_add_signed(added);
            let fraction_bits = bits.clamp(
                point.fewest_fraction_bits,
                point.most_fraction_bits.max(point.fewest_fraction_bits),
            );
            (point.name, Format { fraction_bits, ..point.format })
        };
        let points =
            self.narrowing_points().into_iter().filter(|point| !kept.contains(&point.name));
        let formats: Vec<(&str, Format)> = points.map(finer).collect();
        let changed = self.with_formats(&formats).ok()?;
        (added == 0 || changed != *self).then_some(changed)
    }

    /// The same core for any scene with these numbers of fraction bits at its narrowing points, in
    /// their order, each as near as the others let it be; none where no such core can be described.
    pub fn with_fraction_bits(&self, wanted: &[u32]) -> Option<CoreSpec> {
        let mut spec = self.general();
        // Limits depend on other formats, along chains no longer than the list of all.
        for _ in wanted {
            let points = spec.narrowing_points();
            let formats = points.iter().zip(wanted).map(|(point, &wanted)| {
                let most = point.most_fraction_bits.max(point.fewest_fraction_bits);
                let fraction_bits = wanted.clamp(point.fewest_fraction_bits, most);
                (point.name, Format { fraction_bits, ..point.format })
            });
            let near = spec.changed(formats)?;
            if near == spec {
                break;
            }
            spec = near;
        }
        spec.check().ok()?;
        Some(spec)
    }

    /// The same core in the formats with which a search for others begins; those that are `kept` stay.
    pub fn in_search_formats(&self, kept: &[String]) -> CoreSpec {
        let points = self.narrowing_points();
        let is_open = |name: &str| kept.iter().all(|kept| kept != name);
        let formats = points.iter().filter(|point| is_open(point.name)).filter_map(|point| {
            let fraction_bits = point.search_begins_with?;
            Some((point.name, Format { fraction_bits, ..point.format }))
        });
        self.changed(formats).unwrap_or_else(|| self.clone())
    }

    /// The same core with other formats at these narrowing points, whether or not they may be; none
    /// where there is no such point.
    fn changed<'a>(&self, formats: impl Iterator<Item = (&'a str, Format)>) -> Option<CoreSpec> {
        let mut spec = self.clone();
        for (name, format) in formats {
            *spec.format_mut(name)? = format;
        }
        Some(spec)
    }
}

#[cfg(test)]
mod tests {
    use specula_scene::{Needs, load};

    use crate::{CoreOptions, CoreSpec, Method, NarrowingPoint};

    fn points(needs: &Needs, brightest_coefficient: f64, method: Method) -> Vec<NarrowingPoint> {
        let needs = Needs { brightest_coefficient, ..needs.clone() };
        CoreSpec::for_scene(&needs, None, Some(method)).unwrap().narrowing_points()
    }

    #[test]
    fn formats_are_finer_where_colours_are_brighter_than_full_scale() {
        let needs = Needs::of(&load("teapot", Some((40, 30))).unwrap().frame);
        for method in Method::ALL {
            let full = points(&needs, 1.0, method);
            for (brightest, added) in [(0.3, 0), (1.01, 1), (2.0, 1), (3.9, 2), (100.0, 2)] {
                for (full, bright) in full.iter().zip(points(&needs, brightest, method)) {
                    let wanted = (full.format.fraction_bits + added).min(full.most_fraction_bits);
                    assert_eq!(
                        bright.format.fraction_bits,
                        wanted,
                        "{} {} {brightest}",
                        method.name(),
                        full.name
                    );
                }
            }
        }
    }

    #[test]
    fn fraction_bits_are_as_near_as_others_let_them_be() {
        let needs = Needs::of(&load("teapot", Some((40, 30))).unwrap().frame);
        for method in Method::ALL {
            let spec = CoreSpec::for_scene(&needs, None, Some(method)).unwrap();
            let bits = |spec: &CoreSpec| -> Vec<u32> {
                spec.narrowing_points().iter().map(|point| point.format.fraction_bits).collect()
            };
            assert_eq!(spec.with_fraction_bits(&bits(&spec)).as_ref(), Some(&spec));
            let finer: Vec<u32> = bits(&spec).iter().map(|bits| bits + 1).collect();
            assert_eq!(bits(&spec.with_fraction_bits(&finer).unwrap()), finer, "{}", method.name());
            for wanted in [0, 99] {
                let spec = spec.with_fraction_bits(&vec![wanted; finer.len()]).unwrap();
                for point in spec.narrowing_points() {
                    let limits = [point.fewest_fraction_bits, point.most_fraction_bits];
                    let limit = limits[usize::from(wanted > 0)];
                    assert_eq!(
                        point.format.fraction_bits,
                        limit,
                        "{} {}",
                        method.name(),
                        point.name
                    );
                }
            }
        }
    }

    #[test]
    fn formats_that_are_asked_for_stay() {
        let needs = Needs::of(&load("teapot", Some((40, 30))).unwrap().frame);
        let bright = Needs { brightest_coefficient: 2.0, ..needs };
        let asked: CoreOptions = "[lyon.formats]\nvector = \"S1.13\"".parse().unwrap();
        let spec = CoreSpec::for_scene(&bright, Some(&asked), Some(Method::Lyon)).unwrap();
        for (unasked, got) in points(&bright, 2.0, Method::Lyon).iter().zip(spec.narrowing_points())
        {
            let wanted = if got.name == "vector" { 13 } else { unasked.format.fraction_bits };
            assert_eq!(got.format.fraction_bits, wanted, "{}", got.name);
        }
    }
}
