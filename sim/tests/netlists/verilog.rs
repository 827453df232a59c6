//! Drawn netlists as Verilog.
