//! Letters of drawn texts: the part of a text at its point, and the area that its letters take.

/// The part of a text that is at its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Start of the text.
    Start,
    /// Middle of the text.
    Middle,
    /// End of the text.
    End,
}

impl Anchor {
    /// The value of `text-anchor` in SVG.
    pub fn name(self) -> &'static str {
        match self {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        }
    }

    /// Left edge of a text of a width at `x`.
    pub fn left(self, x: f64, width: f64) -> f64 {
        match self {
            Anchor::Start => x,
            Anchor::Middle => x - 0.5 * width,
            Anchor::End => x - width,
        }
    }
}

/// Space that letters take, in letter sizes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LetterBox {
    /// Width of a letter.
    pub width: f64,
    /// Height above the base line.
    pub top: f64,
    /// Depth below the base line.
    pub foot: f64,
}

/// Space of the letters of drawings, of all their fonts: rounded up, so that leaders and balloons stay clear of them.
pub const LETTER_BOX: LetterBox = LetterBox { width: 0.6, top: 0.78, foot: 0.25 };

impl LetterBox {
    /// Area of so many letters of a size, anchored at a point of their base line: left, top, right, bottom.
    pub fn area(self, (x, base): (f64, f64), anchor: Anchor, size: f64, letters: usize) -> [f64; 4] {
        let width = self.width * size * letters as f64;
        let left = anchor.left(x, width);
        [left, base - self.top * size, left + width, base + self.foot * size]
    }
}
