//! Polygon turning against the check tables and closed forms of the sheet (polygon-turning.md section 3), and against its own tip paths.

mod choosing;
mod section;

use macroline::drives::polygon::curve::flat_ratio;
use macroline::drives::polygon::cut::{helical_tool_speed, mark_pitch, twist};
use macroline::drives::polygon::{Curve, CutterSetup, Ratio, Section, ellipse};
use macroline::math::{self, PI};

use super::close;
use crate::queries::near;

fn ratio(tool: i32, work: i32) -> Ratio {
    Ratio::new(tool, work).unwrap()
}

/// A cutter with its axis at `a` and its tips at `r`.
fn setup(a: f64, r: f64, ratio: Ratio, inserts: u32) -> CutterSetup {
    CutterSetup::even(2.0 * (a - r), r, ratio, inserts)
}

/// Position of a tip on work that has turned by `angle` (rad) since the start.
fn tip(cutter: &CutterSetup, insert: usize, angle: f64) -> (f64, f64) {
    let tool = cutter.tool_start + cutter.ratio.value() * angle;
    cutter.tip_on_work(insert, cutter.work_start + angle, tool).unwrap()
}

/// The tip circle whose sides are flat at their middle, `r = d / ((k-1)² - 1)`; none from 0 to 2, where every side is crowned (sheet 3.3).
fn flat_radius(apothem: f64, ratio: f64) -> Option<f64> {
    let excess = (ratio - 1.0) * (ratio - 1.0) - 1.0;
    (excess > 0.0).then(|| apothem / excess)
}

/// Angle (rad) from a side's normal at which an ellipse ends in stock of a radius: `cos² φ = (d²/R² - ε²) / (1 - ε²)`.
fn edge_in_stock(apothem: f64, radius: f64, stock: f64) -> f64 {
    let e = apothem / (2.0 * radius + apothem);
    let square = apothem * apothem / (stock * stock) - e * e;
    math::acos(math::clamp(square / (1.0 - e * e), 0.0, 1.0).sqrt())
}

/// How far the edges lie below the ideal side where it ends in stock of a radius: `δ = d - R cos φ`.
fn sag_in_stock(apothem: f64, radius: f64, stock: f64) -> f64 {
    apothem - stock * math::cos(edge_in_stock(apothem, radius, stock))
}

/// Pseudo-random numbers, the same in every run.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn integer(&mut self, low: i32, high: i32) -> i32 {
        (self.between(f64::from(low), f64::from(high) + 1.0).floor() as i32).min(high)
    }

    /// A ratio up to 12/7 of either sign.
    fn ratio(&mut self) -> Ratio {
        let sign = if self.between(0.0, 1.0) < 0.3 { -1 } else { 1 };
        ratio(sign * self.integer(1, 12), self.integer(1, 7))
    }
}

#[test]
fn ratio_in_lowest_terms_gives_the_number_of_sides() {
    let same = ratio(12, 30);
    assert_eq!((same.tool(), same.work(), same), (2, 5, ratio(-2, -5)));
    assert_eq!((ratio(2, -1).tool(), ratio(2, -1).work()), (-2, 1));
    for (tool, work) in [(0, 1), (1, 0), (i32::MIN, 1), (1, i32::MAX), (10_000, 1)] {
        assert_eq!(Ratio::new(tool, work), None);
    }
    // Sheet 3.2, with the examples of the makers' manuals.
    for (tool, work, inserts, sides) in [
        (2, 1, 1, 2),
        (2, 1, 2, 4),
        (2, 1, 3, 6),
        (2, 1, 4, 8),
        (12, 5, 5, 12),
        (6, 2, 2, 6),
        (3, 2, 2, 3),
        (5, 2, 2, 5),
        (5, 2, 1, 5),
        (-2, 1, 3, 6),
    ] {
        assert_eq!(ratio(tool, work).sides(inserts), sides, "{inserts} inserts at {tool}/{work}");
    }
    assert_eq!(ratio(5, 2).passes_per_turn(1), 0.5);
    close(mark_pitch(ratio(5, 2), 1, 0.1), 0.2, 1e-15);
    close(mark_pitch(ratio(2, 1), 3, 0.1), 0.1, 1e-15);
}

#[test]
fn ratio_for_a_number_of_sides_is_found() {
    assert_eq!(Ratio::for_sides(6, 3, 1), Some(ratio(2, 1)));
    assert_eq!(Ratio::for_sides(12, 5, 5), Some(ratio(12, 5)));
    assert_eq!(Ratio::for_sides(5, 2, 2), Some(ratio(5, 2)));
    assert_eq!(Ratio::for_sides(5, 3, 1), None);
    assert_eq!(Ratio::for_sides(4, 0, 1), None);
    assert_eq!(Ratio::for_sides(u32::MAX, 1, u32::MAX), None);
    for sides in 1..40 {
        for inserts in 1..8 {
            for work in 1..8 {
                let all = (1..400).filter_map(|tool| Ratio::new(tool, work)).filter(|one| one.work() == work);
                let wanted = all.filter(|one| one.sides(inserts) == sides).collect::<Vec<Ratio>>();
                assert_eq!(Ratio::for_sides(sides, inserts, work as u32).into_iter().collect::<Vec<Ratio>>(), wanted);
            }
        }
    }
}

#[test]
fn tip_paths_equal_the_papers_mirrored() {
    // Equations (1) and (2) with the slips of sheet 3.7 mended: X = a cos αt - r cos (θ-α)t, Y = a sin αt + r sin (θ-α)t.
    let cutter = setup(55.0, 45.0, ratio(2, 1), 2);
    for i in 0..100 {
        let turned = 0.1 * f64::from(i);
        let (x, y) = tip(&cutter, 0, turned);
        near(x, 10.0 * math::cos(turned), 1e-12);
        near(-y, 100.0 * math::sin(turned), 1e-12);
        // Equation (5): an ellipse.
        near((x / 10.0) * (x / 10.0) + (y / 100.0) * (y / 100.0), 1.0, 1e-12);
    }
    assert_eq!(cutter.tip_on_work(0, 0.0, 0.0), Some((10.0, 0.0)));
    assert_eq!(cutter.tip_on_work(2, 0.0, 0.0), None);
}

#[test]
fn start_angles_rotate_the_polygon() {
    // Sheet 3.1: A turns it by -A, E by E/k (E = 10 degrees at k = 2 gives 5).
    let mut cutter = setup(55.0, 45.0, ratio(2, 1), 2);
    cutter.tool_start = 10.0 * PI / 180.0;
    near(cutter.normal(0.0) * 180.0 / PI, 5.0, 1e-12);
    cutter.work_start = 0.3;
    near(cutter.normal(0.0), 5.0 * PI / 180.0 - 0.3, 1e-15);
    cutter.work_start = cutter.work_start_for(0.7);
    let section = Section::new(&cutter, 20.0).unwrap();
    for side in 0..4 {
        near(section.radius(0.7 + 0.5 * PI * f64::from(side)), 10.0, 1e-12);
    }
    // The tip itself comes nearest there.
    let turned = -cutter.tool_start / 2.0;
    let (x, y) = tip(&cutter, 0, turned);
    near(math::atan2(y, x), 0.7, 1e-12);
    near(math::hypot(x, y), 10.0, 1e-12);
}

#[test]
fn sides_are_flat_in_the_middle_at_one_radius() {
    // Sheet 3.3: r = d / ((k-1)² - 1).
    assert_eq!(flat_radius(10.0, 3.0), Some(10.0 / 3.0));
    near(flat_radius(10.0, 12.0 / 5.0).unwrap(), 10.4166667, 1e-7);
    near(flat_radius(10.0, -1.0).unwrap(), 10.0 / 3.0, 1e-12);
    near(flat_radius(10.0, -2.0).unwrap(), 1.25, 1e-12);
    assert_eq!([0.5, 1.0, 2.0].map(|k| flat_radius(10.0, k)), [None; 3]);
    near(flat_ratio(55.0, 45.0), 2.1055, 1e-4);
    for k in [2.3, 3.0, 6.0, -1.0, -3.5] {
        let r = flat_radius(10.0, k).unwrap();
        near(Curve::new(10.0 + r, r, k).unwrap().curvature(), 0.0, 1e-15);
        assert!(Curve::new(10.0 + 1.1 * r, 1.1 * r, k).unwrap().curvature() < 0.0, "larger ones are hollow");
    }
    // k = 2: d / (2 r + d)²; the ellipse's own curvature. k = 1: an arc of radius a.
    near(Curve::new(55.0, 45.0, 2.0).unwrap().curvature(), 0.001, 1e-15);
    near(Curve::new(55.0, 45.0, 1.0).unwrap().curvature(), 1.0 / 55.0, 1e-15);
    near(Curve::new(55.0, 45.0, -2.0).unwrap().curvature(), -0.0547, 5e-5);
    // k = 1 - a/r: the tip is at rest on the work in the middle of the side, a cusp.
    let cusp = Curve::new(55.0, 45.0, -2.0 / 9.0).unwrap();
    assert_eq!(cusp.curvature(), f64::NEG_INFINITY);
    near(cusp.speed(200.0, 0.0), 0.0, 1e-9);
}

#[test]
fn required_relief_exceeds_the_tip_motion_angle() {
    // Sheet 3.4: hundredths of a degree at the finished corner.
    for (across_flats, radius, inserts, wanted) in
        [(20.0, 45.0, 2, 628.0), (20.0, 45.0, 3, 364.0), (20.0, 30.0, 2, 930.0), (30.0, 45.0, 3, 539.0)]
    {
        let cutter = CutterSetup::even(across_flats, radius, ratio(2, 1), inserts);
        let corner = Section::new(&cutter, 100.0).unwrap().corners()[0].radius;
        let curve = cutter.curve(0).unwrap();
        let edge = curve.sigma_at(corner);
        near(curve.relief_needed(edge) * 18_000.0 / PI, wanted, 0.5);
        // k = 2: θ + atan(ε tan θ) with σ = 2θ.
        let bent = (curve.apothem() / (curve.distance() + curve.radius())) * math::tan(0.5 * edge);
        near(curve.engagement(edge), 0.5 * edge + math::atan(bent), 1e-13);
        near(curve.engagement(-edge), -curve.engagement(edge), 1e-15);
    }
}

#[test]
fn relief_and_cutting_speed_follow_the_tip_motion() {
    let mut random = Random(7);
    for _ in 0..300 {
        let (d, r, k) = (random.between(2.0, 30.0), random.between(5.0, 80.0), random.between(-8.0, 8.0));
        if k.abs() < 0.1 {
            continue;
        }
        let curve = Curve::new(d + r, r, k).unwrap();
        let edge = random.between(0.05, 1.0);
        // The tip's velocity over the work in the tool's frame: e^(iσ/k) dP/dθ, by central differences.
        let place = |sigma: f64| {
            let (b, reach) = (curve.turn(sigma), curve.reach(sigma));
            (reach * math::cos(b), -reach * math::sin(b))
        };
        let mut greatest: f64 = 0.0;
        for i in 0..=200 {
            let sigma = edge * f64::from(i) / 200.0;
            let h = 1e-5;
            let (back, on) = (place(sigma - h), place(sigma + h));
            let v = ((on.0 - back.0) / (2.0 * h) * k, (on.1 - back.1) / (2.0 * h) * k);
            near(curve.speed(1000.0, sigma), 2.0 * PI * math::hypot(v.0, v.1), 1e-4 * (1.0 + k.abs()) * (d + r));
            // Outward from the tool's axis to the tip, on the work.
            let (sin, cos) = math::sin_cos(sigma - sigma / k);
            let out = (-cos, -sin);
            let along = (v.0 * out.1 - v.1 * out.0).abs();
            let angle = math::atan2(v.0 * out.0 + v.1 * out.1, along);
            if curve.engagement(sigma) < 1.5 && math::hypot(v.0, v.1) > 1.0 {
                near(angle, curve.engagement(sigma), 1e-5);
            }
            greatest = greatest.max(curve.engagement(sigma));
        }
        let needed = curve.relief_needed(edge);
        assert!(needed >= greatest - 1e-12 && needed <= greatest + 0.02, "{needed} {greatest} {curve:?}");
        let (low, high) = curve.speeds(200.0, edge);
        let within = curve.speed(200.0, 0.6 * edge);
        assert!(low <= within && within <= high);
    }
}

#[test]
fn two_inserts_turn_a_square_three_a_hexagon() {
    // B200 D1 Q2 with two inserts opposite each other: work 200, tool 400 r/min; X20 is 20 mm across flats.
    let (work, tool) = (200.0 * 1.0, 200.0 * 2.0);
    let square = CutterSetup::even(20.0, 45.0, ratio(2, 1), 2);
    assert_eq!((square.sides(), square.across_flats()), (4, 20.0));
    assert_eq!(square.ratio.value() * work, tool);
    let section = Section::new(&square, 12.5).unwrap();
    near(section.across_flats().1, 20.0, 1e-12);
    for side in 0..4 {
        near(2.0 * section.radius(section.begin() + 0.5 * PI * f64::from(side)), 20.0, 1e-12);
    }
    assert_eq!(CutterSetup::even(20.0, 45.0, ratio(2, 1), 3).sides(), 6);
    // 2π · 200 · (a + r) / 1000 over the middle of the side.
    let curve = square.curve(0).unwrap();
    near(curve.speed(work, 0.0), 2.0 * PI * 0.2 * 100.0, 1e-9);
    assert!(curve.faces_forward());
}

#[test]
fn twisted_polygon_changes_the_tool_speed() {
    // Sheet 3.5: n_tool = k (n_work ∓ F/K).
    close(helical_tool_speed(ratio(2, 1), 200.0, -50.0, 100.0), 2.0 * (200.0 - 0.5), 1e-15);
    close(helical_tool_speed(ratio(2, 1), 200.0, -50.0, -100.0), 2.0 * (200.0 + 0.5), 1e-15);
    // The 928Ti's sheet: 400 r/min, two to one, F30 at K1.
    close(helical_tool_speed(ratio(2, 1), 400.0, -30.0, 1.0), 400.0 * 2.0 - 30.0 * 2.0, 1e-15);
    // After t minutes the slide is at z = F t and the tool ahead by E: the section has turned by E/k, as start angles do.
    let (feed, lead, minutes) = (-50.0, 80.0, 0.37);
    let ahead = 2.0 * PI * minutes * (helical_tool_speed(ratio(-5, 2), 150.0, feed, lead) + 2.5 * 150.0);
    close(ahead / -2.5, twist(feed * minutes, lead), 1e-12);
}

#[test]
fn ellipse_sides_match_the_table() {
    // Sheet 3.6: the sag in mm by number of sides, half distance across flats and tip circle.
    let radii = [30.0, 45.0, 60.0, 80.0, 100.0];
    let rows: [(u32, f64, &[f64]); 9] = [
        (4, 5.0, &[0.01473, 0.00691, 0.00400, 0.00229, 0.00149]),
        (4, 10.0, &[0.10051, 0.04963, 0.02946, 0.01726, 0.01132]),
        (4, 15.0, &[0.29129, 0.15076, 0.09174, 0.05480, 0.03637]),
        (4, 20.0, &[0.59715, 0.32260, 0.20101, 0.12233, 0.08214]),
        (6, 5.0, &[0.00492, 0.00231, 0.00133, 0.00077, 0.00050]),
        (6, 10.0, &[0.03384, 0.01663, 0.00985, 0.00576, 0.00378]),
        (6, 15.0, &[0.09901, 0.05076, 0.03077, 0.01833, 0.01215]),
        (6, 20.0, &[0.20513, 0.10929, 0.06768, 0.04103, 0.02749]),
        (8, 10.0, &[0.01746, 0.00857, 0.00507, 0.00297, 0.00194]),
    ];
    for (sides, d, sags) in rows {
        for (&r, &sag) in radii.iter().zip(sags) {
            near(ellipse::sag(d, r, sides), sag, 5e-6);
            close(ellipse::radius_for(d, sides, ellipse::sag(d, r, sides)), r, 1e-9);
        }
    }
    for (d, r, stock, sag) in [(10.0, 45.0, 12.0, 0.02225), (10.0, 30.0, 12.0, 0.04594), (8.0, 50.0, 10.0, 0.01242)] {
        near(sag_in_stock(d, r, stock), sag, 5e-6);
    }
    assert_eq!(ellipse::radius_for(10.0, 4, 9.0), 0.0);
}
