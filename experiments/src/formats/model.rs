//! What bits more or fewer at narrowing points would make of a core, from what one bit at each of
//! them makes of it.
//!
//! A rounding of 2^-f adds to the bound in proportion, as far as first-order terms go, so with d
//! bits more at a point its share s of the bound becomes s 2^-d. Widths of operands, and bits of
//! adders, registers and tables, are taken to be linear in d. Both are exact for one bit at one
//! point and good enough for a few bits at several of them; what is found so is tried.
use rayon::prelude::*;

use super::products::ProductCells;
use super::trials::{Formats, State, Trials, Tried};

/// Bits by which a point's format is looked at to be finer or coarser.
const REACH: i32 = 4;
/// Changes of the bound below this are none, in LSBs.
const NO_CHANGE: f64 = 1e-9;

/// Fraction bits more at each narrowing point, or fewer where negative.
pub(super) type Added = Vec<i32>;

/// A core near which others are looked at.
pub(super) struct Model<'a> {
    center: State,
    points: Vec<Point>,
    products: &'a ProductCells,
}

/// What a bit more at a narrowing point changes.
struct Point {
    /// The share of the bound that is rounded here, in LSBs.
    share: f64,
    /// Bits by which it may be finer, at least and at most.
    limits: [i32; 2],
    /// The products whose factors become wider, and by how much.
    wider: Vec<(usize, [i32; 2])>,
    /// Cells more that are no products'.
    cells: i64,
}

/// Formats near the center's, and what they are expected to come to.
#[derive(Clone, Debug)]
pub(super) struct Near {
    pub added: Added,
    /// The expected bound, in LSBs.
    pub bound: f64,
    /// The expected size, in cells.
    pub cells: i64,
    widths: Vec<[i32; 2]>,
}

impl<'a> Model<'a> {
    /// The model of a core, for which a bit more (or fewer, where it may not have more) is tried at
    /// each point.
    pub fn around(trials: &'a Trials, center: State) -> Model<'a> {
        let limits = trials.limits(&center.formats);
        let points = limits.into_par_iter().enumerate();
        let points = points.map(|(point, limits)| Point::tried(trials, &center, point, limits));
        Model { points: points.collect(), products: trials.products(), center }
    }

    /// The number of narrowing points.
    pub fn points(&self) -> usize {
        self.points.len()
    }

    /// The share of the bound that is rounded at a point, in LSBs.
    pub fn share(&self, point: usize) -> f64 {
        self.points[point].share
    }

    /// The center itself.
    pub fn center(&self) -> Near {
        let widths = self.center.tried.extent.factors.iter();
        Near {
            added: vec![0; self.points.len()],
            bound: self.center.tried.bound,
            cells: self.center.tried.cells,
            widths: widths.map(|of| of.widths.map(|width| width as i32)).collect(),
        }
    }

    /// The formats of a core near the center.
    pub fn formats(&self, near: &Near) -> Formats {
        let bits = self.center.formats.iter().zip(&near.added);
        bits.map(|(&bits, &added)| bits.saturating_add_signed(added)).collect()
    }

    /// With bits more at a point, as far as it may have them.
    pub fn with_all(&self, from: &Near, bits: i32) -> Near {
        let mut near = from.clone();
        for point in 0..self.points.len() {
            let [least, most] = self.points[point].limits;
            let bits = (near.added[point] + bits).clamp(least, most) - near.added[point];
            self.add(&mut near, point, bits);
        }
        near
    }

    /// By how much the bound changes with bits more at a point; none if it may not have them.
    pub fn bound_change(&self, near: &Near, point: usize, bits: i32) -> Option<f64> {
        let Point { share, limits: [least, most], .. } = self.points[point];
        let added = near.added[point];
        let allowed = (least..=most).contains(&(added + bits));
        allowed.then(|| share * (f64::from(-added - bits).exp2() - f64::from(-added).exp2()))
    }

    /// By how many cells the size changes with bits more at a point.
    pub fn cell_change(&self, near: &Near, point: usize, bits: i32) -> i64 {
        let Point { wider, cells, .. } = &self.points[point];
        let products = wider.iter().map(|&(product, [a, b])| {
            let [x, y] = near.widths[product];
            let factors = &self.center.tried.extent.factors[product];
            let cells = |widths| self.products.of(factors, widths);
            cells([x + a * bits, y + b * bits]) - cells([x, y])
        });
        products.sum::<i64>() + cells * i64::from(bits)
    }

    /// Adds bits at a point that may have them.
    pub fn add(&self, near: &mut Near, point: usize, bits: i32) {
        near.bound += self.bound_change(near, point, bits).unwrap_or(0.0);
        near.cells += self.cell_change(near, point, bits);
        near.added[point] += bits;
        for &(product, [a, b]) in &self.points[point].wider {
            let [x, y] = &mut near.widths[product];
            (*x, *y) = (*x + a * bits, *y + b * bits);
        }
    }
}

impl Point {
    fn tried(trials: &Trials, center: &State, point: usize, limits: [i32; 2]) -> Point {
        let neighbour = |bits: i32| {
            let formats = trials.neighbour(&center.formats, point, bits)?;
            Some((bits, trials.state(formats)?))
        };
        let Some((bits, other)) = neighbour(1).or_else(|| neighbour(-1)) else {
            return Point::fixed();
        };
        let (own, other) = (&center.tried, &other.tried);
        let change = other.bound - own.bound;
        // s (2^-d - 1) for d bits more. A bound that falls where less is rounded elsewhere, as ranges
        // move by a unit in the last place, is no share: nothing is won by rounding more.
        let share = (change / (f64::from(-bits).exp2() - 1.0)).max(0.0);
        let share = if share < NO_CHANGE { 0.0 } else { share };
        let is_alike = own.extent.factors.len() == other.extent.factors.len();
        let factors = own.extent.factors.iter().zip(&other.extent.factors);
        // Widths are below 2^31.
        let wider = factors
            .map(|(own, other)| {
                [0, 1].map(|i| (other.widths[i] as i32 - own.widths[i] as i32) * bits)
            })
            .enumerate()
            .filter(|(_, wider)| is_alike && *wider != [0, 0]);
        let wider: Vec<(usize, [i32; 2])> = wider.collect();
        let apart = |tried: &Tried| tried.cells - if is_alike { tried.product_cells } else { 0 };
        let cells = (apart(other) - apart(own)) * i64::from(bits);
        if share == 0.0 && cells == 0 && wider.is_empty() {
            return Point::fixed();
        }
        let limits = limits.map(|added| added.clamp(-REACH, REACH));
        Point { share, limits, wider, cells }
    }

    /// One at which nothing changes.
    fn fixed() -> Point {
        Point { share: 0.0, limits: [0, 0], wider: vec![], cells: 0 }
    }
}
