//! The FPGA for which a core is made.
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde::Serialize;
use specula_datapath::Design;
use specula_experiments::cost::Cost;
use specula_experiments::explore::Device;
use specula_experiments::formats::Products;

use crate::error::DoesNotFit;

/// `--device`, for every command that makes a core.
#[derive(Clone, Debug, Default, Args)]
pub struct DeviceArguments {
    /// The FPGA whose multiplier blocks and registers must be enough for the core
    #[arg(long, value_name = "DEVICE", value_parser = device_parser())]
    pub device: Option<Device>,
}

fn device_parser() -> impl TypedValueParser<Value = Device> {
    PossibleValuesParser::new(Device::all().map(|device| device.name)).try_map(|name| {
        Device::all().find(|device| device.name == name).ok_or("there is no such device")
    })
}

impl DeviceArguments {
    /// How tools make products for the device, if the user named one.
    pub fn products(&self) -> Option<Products> {
        self.device.as_ref().map(|device| device.block.map_or(Products::Logic, Products::Blocks))
    }

    /// The share of the device that the core takes, if the user named a device.
    ///
    /// # Errors
    /// [`DoesNotFit`] if the core takes more than the device has.
    pub fn fitted(&self, design: &Design) -> Result<Option<Fitted>, DoesNotFit> {
        let Some(device) = self.device.clone() else { return Ok(None) };
        let cost = Cost::of(design, device.block);
        let fits = cost.fits(&device);
        let fitted = Fitted { device, cost };
        if fits { Ok(Some(fitted)) } else { Err(does_not_fit(&fitted, design)) }
    }
}

/// A device and the share of it that a core takes.
#[derive(Clone, Debug, Serialize)]
pub struct Fitted {
    device: Device,
    cost: Cost,
}

impl Fitted {
    /// The device and the cost as text.
    pub fn in_words(&self) -> String {
        let Fitted { device, cost } = self;
        let (blocks, registers) = (cost.blocks.unwrap_or(0), cost.register_bits);
        format!(
            "{}: {blocks} of {} multiplier blocks, {registers} of {} registers; logic cells are not counted",
            device.name, device.blocks, device.registers
        )
    }
}

/// The error, which names the first known device that has enough for the core.
fn does_not_fit(fitted: &Fitted, design: &Design) -> DoesNotFit {
    let fits = |device: &Device| Cost::of(design, device.block).fits(device);
    let larger = match Device::all().find(fits) {
        Some(device) => format!("`{}` has enough", device.name),
        None => "no device that is known here has enough".to_owned(),
    };
    DoesNotFit { device: fitted.device.name.clone(), taken: fitted.in_words(), larger }
}
