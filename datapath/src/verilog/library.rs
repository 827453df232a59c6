//! The modules of cores, each distinct one once.
use super::LongDelays;
use super::delay_modules::DelayModules;
use super::delays::Delays;
use super::gated_sum_modules::{self, GatedSum};
use super::module::{self, Instantiated};
use super::multiplier_modules::{self, MultiplierModules};
use crate::block::Module;
use crate::target::SumCells;

/// Stands for the module's name while texts are compared; no name can contain it.
const PLACEHOLDER: &str = "\u{0}";

/// A module as text.
#[derive(Clone, Debug)]
pub struct Printed {
    /// The unit that it is.
    unit: String,
    /// Its name.
    pub name: String,
    /// Its text, without its name.
    text: String,
    /// Its ports, as text.
    ports: String,
    /// The places in the library of what it instantiates, once for each instance; they come before
    /// its own.
    pub children: Vec<usize>,
}

/// Modules by their texts: what is equal is there once, whichever core it is from.
#[derive(Clone, Debug)]
pub struct Library {
    prefix: String,
    modules: Vec<Printed>,
    delays: DelayModules,
    multipliers: MultiplierModules,
    /// The cells of sums of which one summand may be cleared, if there is one.
    gated_sums: Option<SumCells>,
    long_delays: LongDelays,
}

impl Library {
    /// An empty one, in which all names begin with `prefix`.
    pub fn new(prefix: &str, long_delays: LongDelays) -> Library {
        Library {
            prefix: prefix.to_owned(),
            modules: vec![],
            delays: DelayModules::new(prefix),
            multipliers: MultiplierModules::new(prefix),
            gated_sums: None,
            long_delays,
        }
    }

    /// Every distinct module, those that are instantiated before those that instantiate them.
    pub fn modules(&self) -> &[Printed] {
        &self.modules
    }

    /// Adds a module with all that is in it, and gives its place: that of an equal one added
    /// before, or a new one.
    pub fn add(&mut self, module: &Module) -> usize {
        let (text, children) = self.text(module, PLACEHOLDER);
        if let Some(same) =
            self.modules.iter().position(|m| m.unit == module.unit && m.text == text)
        {
            return same;
        }
        let number = self.modules.iter().filter(|m| m.unit == module.unit).count()
            + usize::from(
                DelayModules::is_named_as(&module.unit)
                    || multiplier_modules::is_named_as(&module.unit)
                    || module.unit == gated_sum_modules::UNIT,
            );
        let base = format!("{}_{}", self.prefix, module.unit);
        let name = if number == 0 { base } else { format!("{base}_{}", number + 1) };
        self.modules.push(Printed {
            unit: module.unit.clone(),
            name,
            text,
            ports: module::ports(module),
            children,
        });
        self.modules.len() - 1
    }

    /// The text of a module under a name, and the places of its children, which are added with all
    /// that is in them.
    pub fn text(&mut self, module: &Module, name: &str) -> (String, Vec<usize>) {
        let children: Vec<usize> =
            module.children().iter().map(|child| self.add(&child.module)).collect();
        for line in Delays::of(module).lines {
            self.delays.note(line.storage(self.long_delays));
        }
        if let (Some(cells), [_, ..]) = (module.primitives().multiplier, module.multipliers()) {
            self.multipliers.note(cells);
        }
        if let (Some(cells), [_, ..]) = (module.primitives().gated_sum, &GatedSum::all(module)[..])
        {
            self.gated_sums = Some(cells);
        }
        let names = self.names(&children);
        let (delays, multipliers) = (&self.delays, &self.multipliers);
        let gated_sum = &self.gated_sum_name();
        let instantiated = Instantiated { children: &names, delays, multipliers, gated_sum };
        (module::text(module, name, &instantiated, self.long_delays), children)
    }

    /// The modules that delay lines, products and sums are instances of, those that are instantiated.
    pub fn primitive_modules(&self) -> impl Iterator<Item = String> {
        let sum = |cells| gated_sum_modules::source(&self.gated_sum_name(), cells);
        let gated_sums = self.gated_sums.into_iter().map(sum);
        self.delays.sources().chain(self.multipliers.sources()).chain(gated_sums)
    }

    fn gated_sum_name(&self) -> String {
        format!("{}_{}", self.prefix, gated_sum_modules::UNIT)
    }

    /// Names of the modules in these places.
    pub fn names(&self, places: &[usize]) -> Vec<String> {
        places.iter().map(|&place| self.modules[place].name.clone()).collect()
    }
}

impl Printed {
    /// The module.
    pub fn source(&self) -> String {
        self.text.replacen(PLACEHOLDER, &self.name, 1)
    }

    /// The module with nothing in it, for tools that are to take it as it is.
    pub fn black_box(&self) -> String {
        format!("(* blackbox *)\nmodule {} (\n{}\n);\nendmodule\n", self.name, self.ports)
    }
}
