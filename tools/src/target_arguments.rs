//! The target, the device and the clock that a core is made for.
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{ArgGroup, Args};
use specula_datapath::Design;
use specula_datapath::target::Target;
use specula_experiments::cost::GENERIC_BLOCK;
use specula_experiments::explore::{Device, WantedClock};
use specula_experiments::formats::Products;
use specula_spec::CoreSpec;

use crate::device::{Fitted, device_parser};
use crate::error::{OtherTarget, ToolError};

/// The clock, and the target or the device, that a core is made for.
#[derive(Clone, Debug, Default, Args)]
#[command(group = ArgGroup::new(PART).args(["target", "device"]).multiple(true))]
pub struct TargetArguments {
    /// Target whose cells and delays the core is made for; no delays are known of gowin, whose cores
    /// are for any device [default: the device's, else any device, with a register behind each
    /// operator]
    #[arg(long, value_name = "TARGET", value_parser = target_parser())]
    pub target: Option<String>,
    /// The FPGA that the core has to fit: look-up tables are estimated, the rest is counted
    #[arg(long, value_name = "DEVICE", value_parser = device_parser())]
    pub device: Option<Device>,
    /// Clock in MHz that the core is pipelined for, from 1 to 1000, or max for the highest that
    /// its loops and placement allow [default: max]
    #[arg(long, value_name = "MHZ", value_parser = parse_clock, requires_if("max", PART))]
    pub clock: Option<Clock>,
}

/// `--target` or `--device`.
pub const PART: &str = "part";

/// What `--clock` means where it needs no target.
pub const CLOCK_HELP: &str = "\
Clock in MHz, from 1 to 1000, that a core with --target or --device is pipelined for, or max for the \
highest that its loops and placement allow [default: max]; without, the one at which frames per second are counted: \
assumed, not proven [default: 100]";

/// A clock that is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// So many MHz.
    Mhz(f64),
    /// The highest.
    Highest,
}

impl TargetArguments {
    /// The target that a core is made for: the one that is named, any device where its delays are not
    /// known, or else the device's, if its delays are known.
    ///
    /// # Errors
    /// [`OtherTarget`] where both are named and do not belong together.
    pub fn target(&self) -> Result<Option<&str>, OtherTarget> {
        let is_clocked = |name: &str| Target::clocked().any(|clocked| clocked == name);
        let Some(device) = &self.device else {
            let own = |name| if is_clocked(name) { name } else { ANY_DEVICE };
            return Ok(self.target.as_deref().map(own));
        };
        match &self.target {
            Some(target) if *target != device.target => Err(OtherTarget {
                device: device.name.clone(),
                own: device.target.clone(),
                target: target.clone(),
            }),
            _ => Ok(Some(device.target.as_str()).filter(|own| is_clocked(own))),
        }
    }

    /// The target and the clock that cores are made for; none if they are for any device.
    ///
    /// # Errors
    /// As [`TargetArguments::target`].
    pub fn wanted(&self) -> Result<Option<WantedClock>, OtherTarget> {
        let named = self.target()?.filter(|target| *target != ANY_DEVICE);
        let mhz = match self.clock {
            Some(Clock::Mhz(mhz)) => Some(mhz),
            _ => None,
        };
        Ok(named.and_then(Target::named).map(|target| WantedClock { target, mhz }))
    }

    /// The clock in MHz that is given where cores are made for any device.
    pub fn given_for_any_device(&self) -> Option<f64> {
        match (self.wanted(), self.clock) {
            (Ok(None), Some(Clock::Mhz(mhz))) => Some(mhz),
            _ => None,
        }
    }

    /// The share of the device that a core takes, if the user named a device.
    ///
    /// # Errors
    /// [`ToolError::DoesNotFit`] if the core takes more than the device has, and
    /// [`ToolError::OtherTarget`] if it is made for another target.
    pub fn fitted(&self, spec: &CoreSpec, design: &Design) -> Result<Option<Fitted>, ToolError> {
        let Some(device) = self.device.clone() else { return Ok(None) };
        match &spec.target {
            Some(clock) if clock.name != device.target => {
                Err(ToolError::OtherTarget(OtherTarget {
                    device: device.name,
                    own: device.target,
                    target: clock.name.clone(),
                }))
            }
            _ => Ok(Some(Fitted::on(device, design)?)),
        }
    }

    /// How products are made on the target that the core is made for, or else on the device or the
    /// target that is named.
    ///
    /// # Errors
    /// As [`TargetArguments::target`].
    pub fn products(&self) -> Result<Products, OtherTarget> {
        Ok(match (self.wanted()?, &self.device) {
            (Some(wanted), _) => Products::Of(Box::new(wanted.target)),
            (None, Some(device)) => device.block.map_or(Products::Logic, Products::Blocks),
            (None, None) => {
                let named = self.target.as_deref().and_then(Target::named);
                let block = named.and_then(|target| target.multiplier);
                Products::Blocks(block.map_or(GENERIC_BLOCK, |block| block.widths))
            }
        })
    }

    /// A core made for what is asked for; unchanged where nothing is.
    ///
    /// # Errors
    /// As [`TargetArguments::target`], and [`ToolError::Bench`] if the core cannot be built.
    pub fn made_for(&self, spec: CoreSpec) -> Result<CoreSpec, ToolError> {
        match (self.wanted()?, self.target()?) {
            (Some(wanted), _) => Ok(wanted.made(&spec)?),
            (None, Some(_)) => Ok(CoreSpec { target: None, ..spec }),
            (None, None) => Ok(spec),
        }
    }
}

/// The target that is no device in particular.
pub const ANY_DEVICE: &str = "generic";

/// `--target`.
fn target_parser() -> impl TypedValueParser<Value = String> {
    PossibleValuesParser::new(Target::names())
}

/// Parses `--clock`.
fn parse_clock(text: &str) -> Result<Clock, String> {
    let mhz = || {
        let mhz = text.strip_suffix("MHz").unwrap_or(text).trim().parse::<f64>().ok();
        mhz.filter(|mhz| (1.0..=1000.0).contains(mhz)).map(Clock::Mhz)
    };
    let clock = if text == "max" { Some(Clock::Highest) } else { mhz() };
    clock.ok_or_else(|| "write a clock from 1 to 1000 MHz, as in 250, or max".to_owned())
}
