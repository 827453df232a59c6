//! A core that does not know one need.
use specula_datapath::Design;

/// The core elaborated without knowing one need.
pub struct Ablation {
    pub need: &'static str,
    pub left_out: String,
    pub safe: &'static str,
    pub design: Design,
}
