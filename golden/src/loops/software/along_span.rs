//! A light along a span.
use super::surface::Reflected;
use crate::loops::{Phong, Scheme, power};

/// A light along a span.
pub trait AlongSpan: Copy {
    /// Adds its reflection to every pixel.
    fn add(self, shininess: u32, reflected: &Reflected, out: &mut [[f32; 3]]);
}

impl<S: Scheme<f32>> AlongSpan for S {
    #[inline]
    fn add(mut self, shininess: u32, reflected: &Reflected, out: &mut [[f32; 3]]) {
        let exponent = S::exponent(shininess);
        for pixel in out {
            let amounts = self.pixel();
            let specular = power(amounts.base.clamp(0.0, 1.0), exponent);
            reflected.add(amounts.diffuse.clamp(0.0, 1.0), specular, pixel);
        }
    }
}

/// A light of which a share arrives.
#[derive(Clone, Copy, Debug)]
pub struct Dimmed<A> {
    /// The light.
    pub light: A,
    /// The shares of its diffuse and of its specular light, 0 to 1.
    pub shares: [f32; 2],
}

impl<A: AlongSpan> AlongSpan for Dimmed<A> {
    fn add(self, shininess: u32, reflected: &Reflected, out: &mut [[f32; 3]]) {
        self.light.add(shininess, &reflected.dimmed(self.shares), out);
    }
}

/// A scheme, or Phong's where the scheme cannot shade the span.
#[derive(Clone, Copy, Debug)]
pub enum OrPhong<S> {
    /// The scheme.
    Scheme(S),
    /// Phong's.
    Phong(Phong<f32>),
}

impl<S: Scheme<f32>> AlongSpan for OrPhong<S> {
    fn add(self, shininess: u32, reflected: &Reflected, out: &mut [[f32; 3]]) {
        match self {
            OrPhong::Scheme(scheme) => scheme.add(shininess, reflected, out),
            OrPhong::Phong(phong) => phong.add(shininess, reflected, out),
        }
    }
}
