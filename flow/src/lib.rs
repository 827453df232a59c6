//! What stands around a core on its way into a device. So far that is synthesis with
//! place-and-route: what a core takes of a device, and the clock that it reaches there.
pub mod synth;
