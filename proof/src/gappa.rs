//! Gappa: what it says of a script.
use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::ProofError;
use specula_datapath::bound::Interval;

/// The program.
pub const COMMAND: &str = "gappa";

/// What came of a script.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Every goal is proven; where goals were left open, here is where each lies.
    Proven(BTreeMap<String, Interval>),
    /// Some goal is not; here is what was found of open ones all the same.
    Unproven(BTreeMap<String, Interval>),
    /// It took too long.
    TimedOut,
}

/// What it says where it understands a script and does not prove it; the second where a goal has
/// nothing to do with any hypothesis.
const UNPROVEN: [&str; 2] = ["some properties were not satisfied", "no contradiction was found"];

/// How often a running script is looked at.
const LOOK: Duration = Duration::from_millis(2);

/// Asks Gappa.
///
/// # Errors
/// [`ProofError`] if it cannot be run, or does not understand the script.
pub fn asked(script: &str, limit: Duration) -> Result<Answer, ProofError> {
    let mut child = Command::new(COMMAND)
        .env("LC_ALL", "C")
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(ProofError::NotRun)?;
    let (stdin, stderr) = (child.stdin.take(), child.stderr.take());
    let reader = thread::spawn(move || {
        let mut text = String::new();
        // What cannot be read is not understood below.
        let _ = stderr.map(|mut stderr| stderr.read_to_string(&mut text));
        text
    });
    // One that ends early says why.
    let _ = stdin.map(|mut stdin| stdin.write_all(script.as_bytes()));
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().map_err(ProofError::NotRun)? {
            break status;
        }
        if begun.elapsed() > limit {
            // It may have ended in between.
            let _ = child.kill();
            child.wait().map_err(ProofError::NotRun)?;
            return Ok(Answer::TimedOut);
        }
        thread::sleep(LOOK);
    };
    let text = reader.join().unwrap_or_default();
    let found = found(&text);
    if status.success() {
        return Ok(Answer::Proven(found));
    }
    if UNPROVEN.iter().any(|said| text.contains(said)) {
        return Ok(Answer::Unproven(found));
    }
    let said = text.trim().to_owned();
    Err(ProofError::NotUnderstood { said, script: script.to_owned() })
}

/// Where expressions lie: lines such as `  x in [-5b-3 {-0.625, -2^(-0.678072)}, 1]`.
fn found(text: &str) -> BTreeMap<String, Interval> {
    let line = |line: &str| {
        let (name, rest) = line.strip_prefix("  ")?.split_once(" in [")?;
        Some((name.to_owned(), interval(rest.strip_suffix(']')?)?))
    };
    text.lines().filter_map(line).collect()
}

fn interval(text: &str) -> Option<Interval> {
    let plain = without_braces(text);
    let (low, high) = plain.split_once(',')?;
    // Figures to be shown: what is proven was compared by Gappa itself.
    Some(Interval::new(number(low.trim())?, number(high.trim())?))
}

fn without_braces(text: &str) -> String {
    let mut deep = 0;
    let mut kept = |c: char| {
        deep += i32::from(c == '{');
        let is_kept = deep == 0;
        deep -= i32::from(c == '}');
        is_kept
    };
    text.chars().filter(|&c| kept(c)).collect()
}

/// M, or MbE for M · 2^E.
fn number(text: &str) -> Option<f64> {
    let (mantissa, exponent) = text.split_once('b').unwrap_or((text, "0"));
    Some(mantissa.parse::<f64>().ok()? * 2f64.powi(exponent.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_gappa_prints_is_read() {
        let text = "Results:\n  x in [-5b-3 {-0.625, -2^(-0.678072)}, -1b-8 {-0.00390625, -2^(-8)}]\n  \
                    y in [-1, 1]\n";
        let expected = [("x", -0.625, -0.00390625), ("y", -1.0, 1.0)]
            .map(|(name, low, high)| (name.to_owned(), Interval::new(low, high)));
        assert_eq!(found(text), BTreeMap::from(expected));
        assert_eq!(
            found("Error: some properties were not satisfied:\n  BND(x), best: [0, inf]"),
            BTreeMap::new()
        );
    }
}
