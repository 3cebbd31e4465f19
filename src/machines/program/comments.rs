//! The comments of machines' programs in Chinese, put in the place of the English ones.

use crate::controls::Control;
use crate::nc::{Deck, is_message};
use crate::text::catalog::programs::chinese;

/// Translates the comments and titles of a deck to Chinese. Messages to the operator, settings of the form and texts without a translation
/// stay.
pub fn put_in_chinese(deck: &mut Deck, control: &Control) {
    let comments = deck.blocks.iter().filter(|block| !is_message(deck, control, block)).map(|block| block.comment);
    let titles = deck.programs.iter().map(|program| program.title);
    let texts: Vec<_> = comments.chain(titles).flatten().collect();
    for id in texts {
        if let Some(text) = deck.text_mut(id)
            && let Some(chinese) = chinese(text)
        {
            *text = chinese.into();
        }
    }
}
