//! The look of shapes: materials and colours by name, strokes, and gradients. The style sheet has the colours of both themes.

/// A colour or material. Flat ones are tokens of `style/scene.css`; gradients extend over the bounding box of their shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Paint {
    /// No paint.
    #[default]
    Clear,
    /// A gradient of the scene, by index.
    Own(u8),

    /// Figures and outlines.
    Ink,
    /// Names and leaders.
    Dim,
    /// Accent colour: cutting edges, lenses, arrows.
    Accent,
    /// The page around and behind the drawing.
    Page,
    /// A value beyond its limit.
    Bad,
    /// A value within its limit, or a lit lamp.
    Good,
    /// A value near its limit.
    Warn,

    /// Lit edge.
    Rim,
    /// Edge between two faces.
    Edge,
    /// Ink on the ribbon, displays, deep holes.
    Black,
    /// Needle and limits of a gauge.
    Needle,
    /// Soft shadow.
    Shade,
    /// Ground of a lens.
    Glass,
    /// Ground of a lens below the part.
    GlassDeep,

    /// Steel: lit, middle, shaded.
    SteelLight,
    /// Steel: lit, middle, shaded.
    Steel,
    /// Steel: lit, middle, shaded.
    SteelShade,
    /// Dark steel and cast housings: lit, middle, shaded.
    DarkLight,
    /// Dark steel and cast housings: lit, middle, shaded.
    Dark,
    /// Dark steel and cast housings: lit, middle, shaded.
    DarkShade,
    /// Ribbon: lit edge.
    RibbonLight,
    /// Ribbon.
    Ribbon,
    /// Ribbon: shaded edge.
    RibbonShade,

    /// A turned face of steel, seen from the front.
    SteelFace,
    /// A round body with an axis toward the upper right.
    SteelBody,
    /// A round bar with a horizontal axis.
    SteelBar,
    /// A turned face of dark steel.
    DarkFace,
    /// A round bar of dark steel with a horizontal axis.
    DarkBar,
    /// Front of a cabinet; its top is `SteelLight`, its side `SteelShade`.
    CabinetFront,
    /// Front of a dark housing or plate; its top is `DarkLight`, its side `DarkShade`.
    DarkFront,
    /// Soft shadow on the ground, an ellipse.
    GroundShade,
    /// Floor: fades in from above.
    Floor,
    /// Background.
    Sky,
    /// Upper end of the background.
    SkyHigh,
    /// Lower end of the background.
    SkyLow,
    /// The floor in front.
    FloorTone,
}

/// Direction and form of a gradient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ramp {
    /// Between two points of the shape's bounding box, (0, 0) to (1, 1).
    Across([f64; 4]),
    /// From the middle of the shape's bounding box to its edge.
    Outward,
    /// Between two points of the group.
    Between([f64; 4]),
    /// Rings around a point of the group, one every `r`: x, y, r.
    Rings([f64; 3]),
}

/// A gradient: stops of flat paints with their opacity.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// Direction.
    pub ramp: Ramp,
    /// Place 0 to 1, flat paint, opacity 0 to 1.
    pub stops: Vec<(f64, Paint, f64)>,
}

/// Composition of a paint.
pub(super) enum Substance {
    /// Token of the style sheet.
    Token(&'static str),
    /// Name, direction and stops of a gradient.
    Gradient(&'static str, Ramp, &'static [(f64, Paint, f64)]),
    /// Nothing, or a gradient of the scene.
    Other,
}

use Paint::*;

/// Light from the upper left on a face, across the axis on a body.
const FACE: Ramp = Ramp::Across([0.0, 0.0, 1.0, 1.0]);
const BODY: Ramp = Ramp::Across([0.24, 0.0, 0.76, 1.0]);
const DOWN: Ramp = Ramp::Across([0.0, 0.0, 0.0, 1.0]);

impl Paint {
    /// The substance of the paint.
    #[rustfmt::skip]
    pub(super) fn substance(self) -> Substance {
        use Substance::{Gradient, Other, Token};
        match self {
            Clear | Own(_) => Other,
            Ink => Token("ink"),
            Dim => Token("dim"),
            Accent => Token("accent"),
            Page => Token("bg"),
            Bad => Token("bad"),
            Good => Token("ok"),
            Warn => Token("warn"),
            Rim => Token("rim"),
            Edge => Token("edge-line"),
            Black => Token("black"),
            Needle => Token("needle"),
            Shade => Token("shade"),
            Glass => Token("glass"),
            GlassDeep => Token("glass-deep"),
            SteelLight => Token("steel-light"),
            Steel => Token("steel"),
            SteelShade => Token("steel-shade"),
            DarkLight => Token("dark-light"),
            Dark => Token("dark"),
            DarkShade => Token("dark-shade"),
            RibbonLight => Token("ribbon-light"),
            Ribbon => Token("ribbon"),
            RibbonShade => Token("ribbon-shade"),
            SteelFace => Gradient("steel-face", FACE, &[(0.0, SteelLight, 1.0), (0.3, Steel, 1.0), (0.5, SteelLight, 1.0), (0.72, Steel, 1.0), (1.0, SteelShade, 1.0)]),
            SteelBody => Gradient("steel-body", BODY, &[(0.0, Steel, 1.0), (0.2, SteelLight, 1.0), (0.55, Steel, 1.0), (1.0, SteelShade, 1.0)]),
            SteelBar => Gradient("steel-bar", DOWN, &[(0.0, SteelShade, 1.0), (0.12, Steel, 1.0), (0.3, SteelLight, 1.0), (0.55, Steel, 1.0), (1.0, SteelShade, 1.0)]),
            DarkFace => Gradient("dark-face", FACE, &[(0.0, DarkLight, 1.0), (0.5, Dark, 1.0), (1.0, DarkShade, 1.0)]),
            DarkBar => Gradient("dark-bar", DOWN, &[(0.0, Dark, 1.0), (0.3, SteelShade, 1.0), (0.45, DarkLight, 1.0), (1.0, DarkShade, 1.0)]),
            CabinetFront => Gradient("cabinet-front", Ramp::Across([0.0, 0.0, 0.2, 1.0]), &[(0.0, SteelLight, 1.0), (1.0, Steel, 1.0)]),
            DarkFront => Gradient("dark-front", FACE, &[(0.0, DarkLight, 1.0), (1.0, Dark, 1.0)]),
            GroundShade => Gradient("ground-shade", Ramp::Outward, &[(0.0, Shade, 0.42), (1.0, Shade, 0.0)]),
            Floor => Gradient("floor", DOWN, &[(0.0, SkyLow, 0.0), (0.25, FloorTone, 1.0), (1.0, FloorTone, 1.0)]),
            Sky => Gradient("sky", DOWN, &[(0.0, SkyHigh, 1.0), (1.0, SkyLow, 1.0)]),
            SkyHigh => Token("sky-high"),
            SkyLow => Token("sky-low"),
            FloorTone => Token("floor"),
        }
    }
}

impl Paint {
    /// Whether the paint is a material, so that shapes filled with it are bodies.
    pub(super) fn is_body(self) -> bool {
        match self.substance() {
            Substance::Token(name) => ["steel", "dark", "ribbon"].iter().any(|material| name.starts_with(material)),
            Substance::Gradient(..) => !matches!(self, GroundShade | Floor | Sky),
            Substance::Other => self != Clear,
        }
    }
}

/// Fill and stroke of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Fill.
    pub fill: Paint,
    /// Stroke.
    pub stroke: Paint,
    /// Width of the stroke: drawing units, or screen pixels if it is [thin](Look::thin).
    pub width: f64,
    /// The stroke keeps its width at any zoom.
    pub is_thin: bool,
    /// Ends and corners of the stroke are round.
    pub is_round: bool,
    /// Length of a dash and of the following gap; (0, 0) for none.
    pub dash: (f64, f64),
    /// Opacity 0 to 1.
    pub opacity: f64,
}

impl Look {
    /// A filled shape.
    pub const fn fill(fill: Paint) -> Look {
        Look { fill, stroke: Clear, width: 0.0, is_thin: false, is_round: false, dash: (0.0, 0.0), opacity: 1.0 }
    }

    /// A stroke of a width in drawing units.
    pub const fn line(stroke: Paint, width: f64) -> Look {
        Look::fill(Clear).edge(stroke, width)
    }

    /// A stroke of a width in pixels of the screen.
    pub const fn hair(stroke: Paint, pixels: f64) -> Look {
        Look { is_thin: true, ..Look::line(stroke, pixels) }
    }

    /// With an edge.
    pub const fn edge(self, stroke: Paint, width: f64) -> Look {
        Look { stroke, width, ..self }
    }

    /// With an edge of a width in pixels at any zoom.
    pub const fn thin(self, stroke: Paint, pixels: f64) -> Look {
        Look { stroke, width: pixels, is_thin: true, ..self }
    }

    /// With round ends and corners.
    pub const fn round(self) -> Look {
        Look { is_round: true, ..self }
    }

    /// With a dashed stroke.
    pub const fn dashed(self, dash: f64, gap: f64) -> Look {
        Look { dash: (dash, gap), ..self }
    }

    /// Translucent.
    pub const fn faint(self, opacity: f64) -> Look {
        Look { opacity, ..self }
    }

    /// Leaders and dimension lines.
    pub const LEAD: Look = Look::hair(Dim, 1.0);
    /// Joints between panels.
    pub const HAIR: Look = Look::hair(Edge, 1.0);
    /// Arrows and lens rings.
    pub const POINTER: Look = Look::hair(Accent, 1.5);
    /// The lit edge of a body.
    pub const RIM: Look = Look::line(Rim, 2.0).round().faint(0.85);
    /// A turned face with its edge.
    pub const FACE: Look = Look::fill(SteelFace).thin(Edge, 1.0);
    /// A dark turned face with its edge.
    pub const DARK_FACE: Look = Look::fill(DarkFace).thin(Edge, 1.0);
    /// A bore or a slot.
    pub const HOLE: Look = Look::fill(Dark).thin(Rim, 0.5);
    /// The name at a leader.
    pub const NAME: Look = Look::fill(Dim);
    /// A live value.
    pub const VALUE: Look = Look::fill(Ink);
}
