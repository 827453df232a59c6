//! Values of signals over a batch of clocks.
use specula_hdl::design::NodeId;

/// One column of raw values for each watched signal, over consecutive clocks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Columns {
    /// The clock of the first row.
    pub first_clock: u64,
    /// The signals, in the order of the columns.
    pub nodes: Vec<NodeId>,
    /// The values, a column for each signal.
    pub values: Vec<Vec<i64>>,
}

impl Columns {
    /// Empty columns for these signals.
    pub fn new(nodes: &[NodeId]) -> Columns {
        Columns { first_clock: 0, nodes: nodes.to_vec(), values: vec![vec![]; nodes.len()] }
    }

    /// Number of clocks.
    pub fn clocks(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }

    /// The clocks they cover.
    pub fn span(&self) -> std::ops::Range<u64> {
        self.first_clock..self.first_clock + self.clocks() as u64
    }

    /// Empties them; the next row will be that of `first_clock`.
    pub fn restart(&mut self, first_clock: u64) {
        self.first_clock = first_clock;
        self.values.iter_mut().for_each(Vec::clear);
    }

    /// The rows whose clocks lie in `window`.
    pub fn within(&self, window: &std::ops::Range<u64>) -> Columns {
        let span = self.span();
        let first = window.start.clamp(span.start, span.end);
        let last = window.end.clamp(first, span.end);
        let rows = (first - span.start) as usize..(last - span.start) as usize;
        let values = self.values.iter().map(|column| column[rows.clone()].to_vec()).collect();
        Columns { first_clock: first, nodes: self.nodes.clone(), values }
    }

    /// Appends the rows of `other`, which has the same signals and follows on.
    pub fn extend(&mut self, other: &Columns) {
        if self.clocks() == 0 {
            self.first_clock = other.first_clock;
        }
        for (mine, theirs) in self.values.iter_mut().zip(&other.values) {
            mine.extend_from_slice(theirs);
        }
    }

    /// The column of a signal.
    pub fn of(&self, node: NodeId) -> Option<&[i64]> {
        self.nodes.iter().position(|&n| n == node).map(|i| self.values[i].as_slice())
    }
}
