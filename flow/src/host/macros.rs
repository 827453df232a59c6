//! Groups of inputs that several methods have: what is linear or quadratic in the pixel number, by
//! start value and differences.

/// The statements that a group stands for, a line each: `WORD NAME = ARGUMENTS`. None if
/// there is no such group.
///
/// - `components NAME = m, k`: m + k i, component by component;
/// - `linear NAME = m, k, u`: (m + k i).u;
/// - `squared NAME = m, k`: the squared length of m + k i;
/// - `product NAME = m, k, x, y`: (m + k i).(x + y i);
/// - `through NAME = FIRST, HALF, LAST`: these at the first pixel, half-way and at the last;
/// - `reflected NAME = m, k, n, l`: 2(x.n)(x.l) - (n.l)(x.x) with x = m + k i.
pub fn expanded(word: &str, name: &str, arguments: &str) -> Option<String> {
    let mut arguments = arguments.split(", ");
    let (template, names): (&str, &[&str]) = match word {
        "components" => (COMPONENTS, &["M", "K"]),
        "linear" => (LINEAR, &["M", "K", "U"]),
        "squared" => (SQUARED, &["M", "K"]),
        "product" => (PRODUCT, &["M", "K", "X", "Y"]),
        "through" => (THROUGH, &["FIRST", "HALF", "LAST"]),
        "reflected" => (REFLECTED, &["M", "K", "N", "L"]),
        _ => return None,
    };
    let mut text = template.replace("{NAME}", name);
    for parameter in names {
        text = text.replace(&format!("{{{parameter}}}"), arguments.next()?);
    }
    arguments.next().is_none().then_some(text)
}

const COMPONENTS: &str = "\
real {NAME}_x_start = @component_x({M})
real {NAME}_x_step = @from(1, steps, @component_x({K}))
real {NAME}_y_start = @component_y({M})
real {NAME}_y_step = @from(1, steps, @component_y({K}))
real {NAME}_z_start = @component_z({M})
real {NAME}_z_step = @from(1, steps, @component_z({K}))
";

const LINEAR: &str = "\
real {NAME}_start = @dot({M}, {U})
real {NAME}_step = @from(1, steps, @dot({K}, {U}))
";

/// Hast et al., eq. 20 to 26, of c + b i + a i^2: the differences are a + b and 2 a.
const SQUARED: &str = "\
real {NAME}_start = @dot({M}, {M})
real {NAME}_b = 2 * @dot({K}, {M})
real {NAME}_a = @dot({K}, {K})
real {NAME}_first_difference = @from(1, steps, {NAME}_a + {NAME}_b)
real {NAME}_second_difference = @from(2, steps, 2 * {NAME}_a)
";

const PRODUCT: &str = "\
real {NAME}_start = @dot({M}, {X})
real {NAME}_b = @dot({M}, {Y}) + @dot({K}, {X})
real {NAME}_a = @dot({K}, {Y})
real {NAME}_first_difference = @from(1, steps, {NAME}_a + {NAME}_b)
real {NAME}_second_difference = @from(2, steps, 2 * {NAME}_a)
";

const THROUGH: &str = "\
real {NAME}_start = {FIRST}
real {NAME}_bend = 2 * ({FIRST} - 2 * {HALF} + {LAST})
real {NAME}_b = @per_step({LAST} - {FIRST} - {NAME}_bend, steps)
real {NAME}_a = @per_step(@per_step({NAME}_bend, steps), steps)
real {NAME}_first_difference = @from(1, steps, {NAME}_a + {NAME}_b)
real {NAME}_second_difference = @from(2, steps, 2 * {NAME}_a)
";

/// Hast et al., eq. 10, 18 to 26 and 29.
const REFLECTED: &str = "\
real {NAME}_nl = @dot({N}, {L})
real {NAME}_mn = @dot({M}, {N})
real {NAME}_ml = @dot({M}, {L})
real {NAME}_kn = @dot({K}, {N})
real {NAME}_kl = @dot({K}, {L})
real {NAME}_start = 2 * {NAME}_mn * {NAME}_ml - {NAME}_nl * @dot({M}, {M})
real {NAME}_cross = {NAME}_mn * {NAME}_kl + {NAME}_kn * {NAME}_ml
real {NAME}_b = 2 * {NAME}_cross - 2 * {NAME}_nl * @dot({K}, {M})
real {NAME}_a = 2 * {NAME}_kn * {NAME}_kl - {NAME}_nl * @dot({K}, {K})
real {NAME}_first_difference = @from(1, steps, {NAME}_a + {NAME}_b)
real {NAME}_second_difference = @from(2, steps, 2 * {NAME}_a)
";
