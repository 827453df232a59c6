//! A spec with any formats and options that may be asked for.
use specula_scene::Needs;
use specula_spec::{CoreOptions, CoreSpec, Format, Method, NarrowingPoint, SpecError};

/// A spec that [`CoreSpec::check`] accepts; `between` draws a number from its first argument to its
/// second.
pub fn any_spec(
    needs: &Needs,
    method: Method,
    mut between: impl FnMut(u32, u32) -> u32,
) -> CoreSpec {
    let mut option = |choice: &specula_spec::Choice| {
        let value = choice.values[between(0, choice.values.len() as u32 - 1) as usize];
        format!("{} = {value}", choice.key)
    };
    let mut options: Vec<String> = method.choices().iter().map(&mut option).collect();
    if needs.uneven_shininess.is_some() {
        // Squaring does not reach every exponent.
        options.retain(|option| !option.starts_with("power"));
    }
    // Which narrowing points there are depends on the options.
    let chosen = CoreSpec::for_scene(needs, Some(&table(method, &options, &[])), Some(method))
        .expect("choices are those there are");
    let any = |point: &NarrowingPoint| {
        let fraction_bits = between(point.fewest_fraction_bits, point.most_fraction_bits);
        (point.name, Format { fraction_bits, ..point.format })
    };
    let mut formats: Vec<(&str, Format)> = chosen.narrowing_points().iter().map(any).collect();
    loop {
        match CoreSpec::for_scene(needs, Some(&table(method, &options, &formats)), Some(method)) {
            // Formats depend on one another: what is out of line with the others is brought into
            // line.
            Err(SpecError::WrongFormat {
                name, fewest_fraction_bits, most_fraction_bits, ..
            }) => {
                let wrong = formats
                    .iter_mut()
                    .find(|(point, _)| *point == name)
                    .expect("every format is drawn");
                wrong.1.fraction_bits =
                    wrong.1.fraction_bits.clamp(fewest_fraction_bits, most_fraction_bits);
            }
            drawn => return drawn.expect("choices are those there are"),
        }
    }
}

fn table(method: Method, options: &[String], formats: &[(&str, Format)]) -> CoreOptions {
    let formats: Vec<String> =
        formats.iter().map(|(name, format)| format!("formats.{name} = \"{format}\"")).collect();
    let table = format!("[{}]\n{}\n{}", method.name(), options.join("\n"), formats.join("\n"));
    table.parse().expect("options and formats are TOML")
}
