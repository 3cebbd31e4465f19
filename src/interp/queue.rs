//! Commands of the last block not yet returned to the caller.

use super::canon::Canon;

/// Commands of the last block not yet returned to the caller.
#[derive(Debug, Clone, Default)]
pub(super) struct CommandQueue {
    items: Vec<Canon>,
    head: usize,
}

impl CommandQueue {
    #[inline]
    pub(super) fn push(&mut self, canon: Canon) {
        self.items.push(canon);
    }

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    #[inline(always)]
    pub(super) fn pop(&mut self) -> Option<Canon> {
        if self.items.len() == self.head + 1 {
            self.head = 0;
            let last = self.items.pop();
            self.items.clear();
            return last;
        }
        let canon = core::mem::replace(self.items.get_mut(self.head)?, Canon::Stop);
        self.head += 1;
        Some(canon)
    }

    pub(super) fn clear(&mut self) {
        self.items.clear();
        self.head = 0;
    }
}
