//! The FPGA for which a core is made.
use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::resources::Resources;
use specula_experiments::explore::Device;

use crate::error::DoesNotFit;

/// `--device`.
pub fn device_parser() -> impl TypedValueParser<Value = Device> {
    PossibleValuesParser::new(Device::all().map(|device| device.name)).try_map(|name| {
        Device::all().find(|device| device.name == name).ok_or("there is no such device")
    })
}

/// A device and the share of it that a core takes.
#[derive(Clone, Debug, Serialize)]
pub struct Fitted {
    device: Device,
    resources: Resources,
}

impl Fitted {
    /// That of a design.
    ///
    /// # Errors
    /// [`DoesNotFit`] if the design takes more than the device has.
    pub fn on(device: Device, design: &Design) -> Result<Fitted, DoesNotFit> {
        let resources = device.resources(design);
        let fits = device.has(&resources);
        let fitted = Fitted { device, resources };
        if fits { Ok(fitted) } else { Err(does_not_fit(&fitted, design)) }
    }

    /// The device and what of it is taken, as text.
    pub fn in_words(&self) -> String {
        let Fitted { device, resources } = self;
        let shares: Vec<String> = device
            .shares(resources)
            .map(|share| format!("{} of {} {}", share.taken, share.available, share.cells))
            .collect();
        format!("{}: {}", device.name, shares.join(", "))
    }
}

/// The error, which names the first known device that has enough for the core.
fn does_not_fit(fitted: &Fitted, design: &Design) -> DoesNotFit {
    // A core that is made for a target has that target's cells.
    let of_target =
        |device: &Device| design.multipliers.is_empty() || device.target == fitted.device.target;
    let fits = |device: &Device| of_target(device) && device.has(&device.resources(design));
    let larger = match Device::all().find(fits) {
        Some(device) => format!("`{}` has enough", device.name),
        None => format!("no known device of `{}` has enough", fitted.device.target),
    };
    DoesNotFit { device: fitted.device.name.clone(), taken: fitted.in_words(), larger }
}
