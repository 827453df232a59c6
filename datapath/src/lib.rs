//! Pipelined fixed-point datapaths, described at run time: proven ranges and error bounds,
//! automatic pipelining, rust-hdl blocks and Verilog. It knows nothing of shading.
//!
//! # In five minutes
//!
//! A [`Builder`] is what a datapath is described with. A value is a
//! [`Sig`](builder::Sig): it has a format, a *proven range* of raw values and a *proven bound* on
//! |fixed − real|. Operators derive the result's from the operands'; nothing is rounded unless it
//! is asked for, and no unit counts its own registers.
//!
//! ```
//! use specula_datapath::{Builder, Format, InputPort};
//!
//! // A linear interpolation of bytes: a + t (b - a), rounded to a whole number.
//! let builder = Builder::new("lerp", "a + t (b - a)");
//! let control = builder.control();
//! let byte = Format::unsigned(8, 0);
//! let [a, b] = ["a", "b"].map(|name| builder.input(&InputPort::whole(name, byte)));
//! let t = builder.input(&InputPort::whole("t", Format::unsigned(0, 8)));
//!
//! let exact = &a + &t * (&b - &a); //  b - a: 9 bits, S8.0; the product 17 bits, S8.8
//! let lerp = exact.rounded(0);
//!
//! // t is rounded by who sends it: half a unit of 2^-8, times |b - a| ≤ 255; then 1/2 for rounding.
//! assert_eq!(lerp.error_value(), 0.5 / 256.0 * 255.0 + 0.5);
//!
//! let design = builder.finish(&control.valid, &[("lerp", lerp)])?;
//! assert_eq!(design.latency(), 4); // difference, product, sum, and the rounding's sum
//! # Ok::<(), specula_datapath::BuildError>(())
//! ```
//!
//! **Narrowing** is always explicit: [`rounded`](builder::Sig::rounded),
//! [`truncated`](builder::Sig::truncated), [`clamped_above`](builder::Sig::clamped_above). A fact
//! that intervals cannot see is stated with [`assumed`](builder::Sig::assumed): the bits that it
//! makes superfluous are dropped, and a simulation checks it in every clock. A bound that rules
//! cannot find is stated with [`tighten_error`](builder::Sig::tighten_error), or with
//! [`override_error`](builder::Sig::override_error) where rules see nothing, and names its proof; a
//! proof takes a [`Bound`](bound::Bound), which is plain numbers.
//!
//! **Units** are modules with ports ([`Builder::unit`](builder::Builder::unit)): a function that
//! reads like its formula. All inputs of a unit are taken at one stage, all outputs leave at one.
//!
//! **Loops** go from pixel to pixel: an accumulator ([`Sig::accumulated`](builder::Sig::accumulated)),
//! or any step that fits one clock ([`Builder::recurrence`](builder::Builder::recurrence),
//! [`Builder::carried`](builder::Builder::carried)). The first pixel of a *span*, a run of pixels
//! with the same inputs, loads them. They step with a valid pixel only, so that a span may pause in
//! any clock: `valid` is then low, inputs stay, and `start` means nothing.
//!
//! **Inputs** are held while their span goes in. One that holds for a *frame* ([`Hold::Frame`]) is
//! quasi-static: it may change only while no pixel is under way, that is, after the clock in which
//! the last one leaves, and has then to stand for [`settling`](Design::settling) clocks before the
//! next pixel enters. What is computed of such inputs alone, outside loops, is *still*: it is there
//! at any time, moves no other value's stage, and is read without any delay register.
//!
//! # What comes of it
//!
//! ```text
//! Builder ──► Graph ─┬─► schedule ──► registers ──► dead code ─┬─► Design ─┬─► rust-hdl blocks ──► Verilog
//!         no clocks  └─► bounds ────────────────────────────────┘           └─► engines (specula-sim)
//! ```
//!
//! A [`Graph`](graph::Graph) has no clocks, and knows which real value each of its values stands for:
//! [`bounds`](pass::bounds()) says how far both are apart. The other [passes](pass) say for a
//! [`Target`](target::Target) in which clock each operator runs, and put the delays in that make
//! what belongs together arrive together. A [`Design`] is a flat list of signals with proven ranges;
//! [`Design::to_block`] makes rust-hdl modules of it, and [`verilog::print`] prints those. A mistake
//! in using the builder is a [`BuildError`] that names unit and signal.
//!
//! `examples/` has a lerp, a filter, a reciprocal and a complex product: each proves its bound,
//! prints its Verilog, is simulated, and compared with f64.
pub mod block;
pub mod bound;
pub mod builder;
pub mod design;
pub mod format;
pub mod graph;
mod names;
mod packet;
pub mod pass;
mod port;
pub mod resources;
pub mod stages;
pub mod target;
pub mod timing;
pub mod verilog;

pub use builder::{BuildError, Builder};
pub use design::Design;
pub use format::{Format, FormatError};
pub use packet::SpanPacket;
pub use port::{Hold, InputPort};
