//! Trials of formats: the bound and the size of a core, of which no more is made than its graph.
use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use specula_datapath::builder::{BuildError, Builder};
use specula_datapath::design::Extent;
use specula_datapath::pass;
use specula_spec::CoreSpec;

use super::Wanted;
use super::products::ProductCells;

/// Numbers of fraction bits, in the order of the narrowing points.
pub(super) type Formats = Vec<u32>;

/// What is known of a core.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tried {
    /// The proven bound of its quantisation error, in LSBs.
    pub bound: f64,
    /// What it is made of.
    pub extent: Extent,
    /// The cells that its products take.
    pub product_cells: i64,
    /// The resources that it takes, as one number.
    pub cells: i64,
}

/// Formats with what is known of the core that has them.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub formats: Formats,
    pub tried: Arc<Tried>,
}

/// The trials of one search.
pub(super) struct Trials<'a> {
    start: &'a CoreSpec,
    products: ProductCells,
    /// Whether each narrowing point keeps its format.
    kept: Vec<bool>,
    known: Mutex<HashMap<Formats, Option<Arc<Tried>>>>,
}

/// The formats of a core.
pub(super) fn formats_of(spec: &CoreSpec) -> Formats {
    spec.narrowing_points().iter().map(|point| point.format.fraction_bits).collect()
}

impl<'a> Trials<'a> {
    /// Trials of the formats of `start`; those that are to be kept stay.
    pub fn new(start: &'a CoreSpec, wanted: &Wanted) -> Trials<'a> {
        let points = start.narrowing_points();
        let kept = points.iter().map(|point| wanted.kept.iter().any(|name| name == point.name));
        Trials {
            start,
            products: ProductCells::new(&wanted.products),
            kept: kept.collect(),
            known: Mutex::default(),
        }
    }

    /// Number of cores that were tried.
    pub fn count(&self) -> usize {
        self.known().len()
    }

    /// What products take.
    pub fn products(&self) -> &ProductCells {
        &self.products
    }

    /// What is known of a core in these formats, whose inputs are given about what the start's are;
    /// none if it cannot be built.
    pub fn state(&self, formats: Formats) -> Option<State> {
        let seen = self.known().get(&formats).cloned();
        let tried = seen.unwrap_or_else(|| {
            let tried = self.tried(&formats).map(Arc::new);
            self.known().insert(formats.clone(), tried.clone());
            tried
        });
        tried.map(|tried| State { formats, tried })
    }

    fn known(&self) -> std::sync::MutexGuard<'_, HashMap<Formats, Option<Arc<Tried>>>> {
        // Whoever panicked while it held the lock had not begun to change anything.
        self.known.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn tried(&self, formats: &[u32]) -> Option<Tried> {
        let general = self.start.with_fraction_bits(formats)?;
        let spec = general.nearly_specialised_as(self.start);
        self.appraised(&spec).ok().filter(|tried| tried.bound.is_finite())
    }

    /// The bound and the size of a core.
    ///
    /// # Errors
    /// [`BuildError`] if it cannot be built.
    pub fn appraised(&self, spec: &CoreSpec) -> Result<Tried, BuildError> {
        let graph = specula_hdl::cores::graph(spec, |formula| Builder::new("core", formula))?;
        let bound = pass::bounds(&graph).of_outputs(&graph);
        let extent = pass::extent(&graph)?;
        let factors = extent.factors.iter();
        // Widths are below 2^31.
        let products = factors
            .map(|factors| self.products.of(factors, factors.widths.map(|width| width as i32)));
        let product_cells: i64 = products.sum();
        let size = &extent.size;
        // Sizes are far below 2^63.
        let others = (size.adder_bits + size.register_bits + size.table_bits) as i64;
        Ok(Tried { bound, product_cells, cells: product_cells + others, extent })
    }

    /// The start's formats, all finer by so many bits, each as far as it may be; none if no such core
    /// can be described.
    pub fn finer(&self, added: i32) -> Option<Formats> {
        let bits = formats_of(self.start);
        let moved = bits.iter().map(|bits| bits.saturating_add_signed(added));
        self.allowed(moved.collect())
    }

    /// The formats with one narrowing point finer by so many bits, and with those that this takes
    /// along; none if it may not be, or is to be kept.
    pub fn neighbour(&self, formats: &[u32], point: usize, added: i32) -> Option<Formats> {
        let mut moved = formats.to_vec();
        moved[point] = moved[point].checked_add_signed(added)?;
        self.allowed(moved).filter(|allowed| allowed[point] != formats[point])
    }

    /// By how many bits each narrowing point may be finer, at least and at most, if the others stay.
    pub fn limits(&self, formats: &[u32]) -> Vec<[i32; 2]> {
        let spec = self.start.with_fraction_bits(formats);
        let points = spec.as_ref().unwrap_or(self.start).narrowing_points();
        let limits = points.iter().zip(&self.kept).map(|(point, kept)| {
            // Bits are below 2^31.
            let added = |limit: u32| limit as i32 - point.format.fraction_bits as i32;
            let [least, most] =
                [added(point.fewest_fraction_bits), added(point.most_fraction_bits)];
            if *kept { [0, 0] } else { [least, most.max(least)] }
        });
        limits.collect()
    }

    /// The nearest formats that a core may have, with those that are kept as they are; none if
    /// there are none.
    pub fn allowed(&self, mut formats: Formats) -> Option<Formats> {
        let start = formats_of(self.start);
        for (point, &bits) in start.iter().enumerate() {
            if self.kept[point] {
                formats[point] = bits;
            }
        }
        let allowed = formats_of(&self.start.with_fraction_bits(&formats)?);
        let stays = |point: usize| !self.kept[point] || allowed[point] == start[point];
        (0..allowed.len()).all(stays).then_some(allowed)
    }
}
