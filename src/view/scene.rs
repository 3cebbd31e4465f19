//! An animated drawing: nodes drawn once, and poses that move them. Lengths are drawing units of the view box.

use super::letters::Anchor;
use super::look::{Gradient, Look, Paint};

/// A shape, in the coordinates of its group.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A circle.
    Circle {
        /// Centre.
        x: f64,
        /// Centre.
        y: f64,
        /// Radius.
        r: f64,
    },
    /// An ellipse with horizontal and vertical axes.
    Ellipse {
        /// Centre.
        x: f64,
        /// Centre.
        y: f64,
        /// Half the width.
        rx: f64,
        /// Half the height.
        ry: f64,
    },
    /// A path in SVG syntax.
    Path {
        /// The `d` attribute of the path.
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
        /// Radius of the corners.
        r: f64,
    },
    /// A line of text.
    Text {
        /// Anchor point.
        x: f64,
        /// Base line of line 0.
        y: f64,
        /// Part of the text at the point.
        anchor: Anchor,
        /// The words.
        text: String,
        /// Line number below `y`; lines are [`LINE`] letter sizes apart.
        line: f64,
        /// Font.
        font: Font,
    },
}

/// Distance between lines of text, in letter sizes.
pub const LINE: f64 = 1.4;
/// Letter size of labels, pixels at any zoom.
pub const LETTER: f64 = 13.0;

/// Type and size of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Font {
    /// [`LETTER`] pixels at any zoom.
    Label,
    /// Like [`Font::Label`], bold, with figures of equal width.
    Value,
    /// Letters on a part of the machine, with a height in drawing units.
    Engraved(f64),
}

/// A shape with its look, in a group that poses can move.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Id for changes by poses; `None` for most.
    pub id: Option<u16>,
    /// Group that it moves with; group 0 never moves. Groups are drawn in node order.
    pub group: u16,
    /// The shape.
    pub shape: Shape,
    /// Fill and stroke.
    pub look: Look,
    /// Id of the form field that the shape shows; empty for most.
    pub field: &'static str,
    /// Number of its label, common to name, values and leader; 0 for other shapes.
    pub label: u16,
}

/// A group: its place in its parent, and its window. Poses turn and shift it relative to that place.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneGroup {
    /// The parent group; 0 is the drawing.
    pub parent: u16,
    /// Origin of the group in the parent.
    pub at: (f64, f64),
    /// Units of the parent per unit of the group.
    pub scale: f64,
    /// Window of the group: a circle, a rectangle or a path. Outside of it the group is invisible. It moves with the group.
    pub clip: Option<Shape>,
    /// Whether the group is visible only in poses that show it, for instance blurred rings or chips.
    pub hidden: bool,
}

impl Default for SceneGroup {
    fn default() -> SceneGroup {
        SceneGroup { parent: 0, at: (0.0, 0.0), scale: 1.0, clip: None, hidden: false }
    }
}

/// A drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scene {
    /// View box: left, top, width, height.
    pub view: [f64; 4],
    /// Largest drawing units per pixel for which the labels have space; 0 without a limit.
    pub unit: f64,
    /// Nodes in drawing order.
    pub nodes: Vec<Node>,
    /// Groups by number, including 0, the drawing.
    pub groups: Vec<SceneGroup>,
    /// Gradients of [`Paint::Own`].
    pub gradients: Vec<Gradient>,
    /// Catalog id of the description for screen readers.
    pub alt: &'static str,
    /// Named places for a drawing wider than its space: catalog id of the name, and distance from the left.
    pub stations: Vec<(&'static str, f64)>,
    /// Catalog id of the drawing's own option, a check box below it; `None` for most.
    pub drawing_option: Option<&'static str>,
}

/// Placement of a group: scaled, rotated by `turn` degrees around (`cx`, `cy`), then shifted from its place at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Size along x and y, relative to the size at rest.
    pub size: (f64, f64),
    /// Opacity 0 to 1.
    pub opacity: f64,
}

impl Default for Placement {
    fn default() -> Placement {
        Placement { group: 0, turn: 0.0, cx: 0.0, cy: 0.0, dx: 0.0, dy: 0.0, size: (1.0, 1.0), opacity: 1.0 }
    }
}

impl Placement {
    /// A group at rest.
    pub fn of(group: u16) -> Placement {
        Placement { group, ..Placement::default() }
    }

    /// A group at rest that is shown or not.
    pub fn shown(group: u16, is_shown: bool) -> Placement {
        Placement { opacity: f64::from(u8::from(is_shown)), ..Placement::of(group) }
    }
}

/// One moment of a scene: the changes from rest. Nodes are referred to by their [id](Node::id).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pose {
    /// Placements of groups.
    pub placements: Vec<Placement>,
    /// Nodes with a changed path.
    pub paths: Vec<(u16, String)>,
    /// Nodes with a changed text.
    pub texts: Vec<(u16, String)>,
    /// Offsets of dashes: backward shift of a dashed stroke along its path.
    pub dashes: Vec<(u16, f64)>,
    /// Changed fills: lamps, values beyond their limits.
    pub fills: Vec<(u16, Paint)>,
}

impl Scene {
    /// The node with this id.
    pub fn node(&self, id: u16) -> Option<&Node> {
        self.nodes.iter().find(|node| node.id == Some(id))
    }

    /// Removes the labels: for pictures too small to read.
    pub fn remove_labels(&mut self) {
        self.nodes.retain(|node| node.label == 0);
    }
}
