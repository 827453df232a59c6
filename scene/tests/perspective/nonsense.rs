//! Cameras where none should be.
