//! A drawing that moves: nodes drawn once, and poses that move them. Lengths are drawing units of the view box.

/// A shape. Colours are names of the page's tokens (`steel`, `ribbon`, `accent`, `ink`, `dim`, `pane`, `bad` …), never colours.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A circle around the node's origin offset.
    Circle {
        /// Centre.
        x: f64,
        /// Centre.
        y: f64,
        /// Radius.
        r: f64,
    },
    /// A path in SVG syntax.
    Path {
        /// The `d` of the path.
        d: String,
    },
    /// A rectangle.
    Rect {
        /// Left.
        x: f64,
        /// Top.
        y: f64,
        /// Width.
        w: f64,
        /// Height.
        h: f64,
    },
    /// A line of text; `anchor` is `start`, `middle` or `end`.
    Text {
        /// Anchor point.
        x: f64,
        /// Base line.
        y: f64,
        /// Which end of the text is at the point.
        anchor: &'static str,
        /// The words.
        text: String,
    },
}

/// A shape with its look, in a group that poses can move.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Group that it moves with; 0 never moves. Groups are drawn in node order.
    pub group: u16,
    /// The shape.
    pub shape: Shape,
    /// Token of the fill, or empty for none.
    pub fill: &'static str,
    /// Token of the stroke, or empty for none.
    pub stroke: &'static str,
    /// Stroke width.
    pub width: f64,
    /// CSS class for anything further (`blur`, `label`, `value`), or empty.
    pub class: &'static str,
}

/// A drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scene {
    /// View box: left, top, width, height.
    pub view: [f64; 4],
    /// Nodes in drawing order.
    pub nodes: Vec<Node>,
    /// How many groups there are.
    pub groups: u16,
    /// What the drawing shows, for those who do not see it: catalog id.
    pub alt: &'static str,
    /// Catalog id of the drawing's own option, a check box below it; none for most.
    pub option: Option<&'static str>,
}

/// Placement of a group: rotated by `turn` degrees around (`cx`, `cy`), then shifted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Placement {
    /// Group.
    pub group: u16,
    /// Degrees, clockwise on the screen.
    pub turn: f64,
    /// Centre of the turn.
    pub cx: f64,
    /// Centre of the turn.
    pub cy: f64,
    /// Shift to the right.
    pub dx: f64,
    /// Shift down.
    pub dy: f64,
    /// Opacity 0 to 1.
    pub opacity: f64,
}

/// A moment of a scene: only what may have moved.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pose {
    /// Groups and where they stand.
    pub placements: Vec<Placement>,
    /// Nodes (by index) whose path changed.
    pub paths: Vec<(usize, String)>,
    /// Nodes (by index) whose text changed.
    pub texts: Vec<(usize, String)>,
}
