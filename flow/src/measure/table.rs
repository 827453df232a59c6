//! Measured delays as a target's table has them.
use std::fmt::Write;

use super::{Delays, Way};

/// The part of a table that is measured, as TOML.
pub fn text(delays: &Delays) -> String {
    let Delays { register, net, lut, carry, carry_bit, .. } = delays;
    let mut text = format!(
        "[fabric]\nregister = {register:.2}\nlut = {lut:.2}\nnet = {net:.2}\ncarry = {carry:.2}\n\
         carry_bit = {carry_bit:.4}\n"
    );
    let into = |way: &Way| way.into - register - net;
    for (name, ways) in
        [("multiplier.pipeline", &delays.multiplier), ("table.pipeline", &delays.memory)]
    {
        for way in ways {
            // Writing to a String cannot fail.
            let _ = write!(
                text,
                "\n[[{name}]]\nclocks = {}\ninto = {:.2}\nout = {:.2}\n",
                way.clocks,
                into(way),
                way.out
            );
        }
    }
    if let Some(read) = delays.delay_line {
        let _ = write!(text, "\n[delay_line]\nread = {read:.2}\n");
    }
    text
}
