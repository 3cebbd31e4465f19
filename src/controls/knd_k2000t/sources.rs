//! Sources that rows of the K2000T share.

use crate::text::{Citation, Grade};

/// The published paper about the polygon lathe, which has a K2000T.
pub(super) const PAPER: Citation = Citation::new("polygon turning paper, K2000T", Grade::Manual);
/// The mode "program zero return"; its motion is not documented here.
pub(super) const RETURN: Citation =
    Citation::new("EMQX Neuron, KND driver: mode 10 is program zero return; how it moves: memory", Grade::Open);
