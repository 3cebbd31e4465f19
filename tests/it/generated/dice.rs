//! Choices made from bytes: few bytes make a small program, other bytes another one.

/// A source of choices from bytes, one byte for each; 0 when no byte is left.
pub(crate) struct Dice<'a>(pub(crate) &'a [u8]);

impl Dice<'_> {
    /// Whether nothing is left.
    pub(crate) fn ended(&self) -> bool {
        self.0.is_empty()
    }

    /// The next byte.
    pub(crate) fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// A number below `n`, which is 1 at least.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        let high = if n > 256 { usize::from(self.byte()) << 8 } else { 0 };
        (high | usize::from(self.byte())) % n.max(1)
    }

    /// True for `n` of 256 byte values; false when no byte is left.
    pub(crate) fn rarely(&mut self, n: u8) -> bool {
        self.byte() >= 255 - n.min(254)
    }

    /// One of several.
    pub(crate) fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}
