//! What an input may be, for people.
use specula_spec::InputPort;

/// From where to where an input's values reach, five places behind the point.
pub fn extent(port: &InputPort) -> String {
    let shown = |raw: i64| {
        let text = format!("{:.5}", port.format.value(raw));
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    format!("{} to {}", shown(port.range.0), shown(port.range.1))
}

#[cfg(test)]
mod tests {
    use specula_spec::Format;

    use super::*;

    #[test]
    fn values_are_short() {
        let whole = InputPort::whole("x", Format::signed(1, 14));
        let port = InputPort { range: (-1931, 16384), ..whole };
        assert_eq!(extent(&port), "-0.11786 to 1");
        assert_eq!(extent(&InputPort { range: (0, 8192), ..port }), "0 to 0.5");
    }
}
