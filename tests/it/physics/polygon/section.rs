//! The section that is left: check table, closed forms, and tips that have passed everything outside of it and nothing within.

use super::*;

#[test]
fn sections_match_the_check_table() {
    // Sheet 3.6: a, r, tool and work terms, inserts, sides, corner radius, deviation, area and how exact it is.
    // (The sheet prints 11.53564 in row 4, where its own closed form gives 11.535635; its areas are sums, right to 1e-3.)
    let rows = [
        (40., 30., 2, 1, 2, 4, 14.00000, -0.100505, 397.3118, 1e-3),
        (55., 45., 2, 1, 2, 4, 14.07195, -0.049628, 398.6746, 1e-3),
        (55., 45., 2, 1, 3, 6, 11.52781, -0.016625, 346.0260, 1e-3),
        (70., 60., 2, 1, 3, 6, 11.53563, -0.009847, 346.1830, 1e-3),
        (55., 45., 2, 1, 4, 8, 10.81465, -0.008565, 331.182, 1e-3),
        (55., 45., 2, 1, 5, 10, 10.50908, -0.00527, 324.806, 1e-3),
        (75., 60., 2, 1, 3, 6, 17.28498, -0.03077, 778.3563, 1e-3),
        (55., 45., 3, 1, 2, 6, 11.66385, 0.10119, 348.735, 1e-3),
        (55., 45., 3, 1, 1, 3, 22.22222, 1.11111, 555.81, 5e-3),
        (55., 45., 6, 1, 1, 6, 11.82293, 0.23896, 351.858, 1e-3),
        (55., 45., 4, 1, 1, 4, 14.90712, 0.54093, 414.009, 1e-3),
        (55., 45., 5, 2, 2, 5, 12.46299, 0.08277, 365.267, 1e-3),
        (55., 45., 12, 5, 5, 12, 10.36164, 0.00858, 321.723, 1e-3),
        (55., 45., 3, 2, 2, 3, 18.18182, -0.90909, 486.770, 1e-3),
        (55., 45., 1, 1, 6, 6, 11.21601, -0.28665, 339.702, 1e-3),
        (55., 45., 1, 1, 4, 4, 13.04109, -0.77856, 378.485, 1e-3),
        (40., 10., 3, 1, 2, 6, 34.59680, -0.03829, 3116.14, 5e-3),
        (55., 45., -2, 1, 3, 6, 12.89534, 1.16769, 371.476, 1e-3),
    ];
    for (a, r, tool, work, inserts, sides, corner, deviation, area, exact) in rows {
        let cutter = setup(a, r, ratio(tool, work), inserts);
        assert_eq!(cutter.sides(), sides);
        let section = Section::new(&cutter, 60.0).unwrap();
        for found in section.corners() {
            assert!(found.meets);
            near(found.radius, corner, 5e-6);
        }
        for side in section.sides() {
            near(side.middle, 0.0, 1e-12);
            near(if deviation < 0.0 { side.low } else { side.high }, deviation, 5e-6);
            near(if deviation < 0.0 { side.high } else { side.low }, 0.0, 5e-6);
        }
        near(section.area(), area, exact);
    }
}

#[test]
fn wrong_sense_sides_do_not_meet_in_the_stock() {
    // The last row of the table.
    let section = Section::new(&setup(55., 45., ratio(-2, 1), 2), 15.0).unwrap();
    assert!(section.corners().iter().all(|corner| !corner.meets && corner.radius == 15.0));
    near(section.corners()[0].angle, section.begin() + 0.25 * PI, 1e-12);
}

/// Twice the distance of a corner from the centre at ratio 2: `2 d / (cos(π/N) √(1 + ε² T²))`. For 3 sides or more.
fn across_corners(apothem: f64, radius: f64, sides: u32) -> f64 {
    2.0 * ellipse::reach(apothem, radius, PI / f64::from(sides))
}

/// Area (mm²) of the section at ratio 2: `(N d² / ε) atan(ε T)`, with `ε = d / (2 r + d)` and `T = tan(π/N)`. For 3 sides or more.
fn area(apothem: f64, radius: f64, sides: u32) -> f64 {
    let e = apothem / (2.0 * radius + apothem);
    f64::from(sides) * apothem * apothem / e * math::atan(e * math::tan(PI / f64::from(sides)))
}

#[test]
fn ratio_2_sections_equal_the_ellipse_formula() {
    let mut random = Random(1);
    for case in 0..1000 {
        let (d, r) = (random.between(1.0, 40.0), random.between(5.0, 150.0));
        let inserts = random.integer(1, 8) as u32;
        let mut cutter = setup(d + r, r, ratio(2, 1), inserts);
        let d = cutter.distance - r;
        cutter.work_start = random.between(-7.0, 7.0);
        cutter.tool_start = random.between(-7.0, 7.0);
        let sides = 2 * inserts;
        let whole = sides > 2 && case % 3 > 0;
        let full = if sides > 2 { across_corners(d, r, sides) / 2.0 } else { 1.5 * d };
        let stock = if whole { 1.5 * full } else { random.between(d, full) };
        let section = Section::new(&cutter, stock).unwrap();
        let half = PI / f64::from(sides);
        let edge = if whole { half } else { edge_in_stock(d, r, stock) };
        for _ in 0..8 {
            let off = random.between(-half, half);
            let wanted = if off.abs() > edge { stock } else { ellipse::reach(d, r, off) };
            let turned = 2.0 * half * f64::from(random.integer(-9, 9));
            near(section.radius(cutter.normal(0.0) + turned + off), wanted, 1e-9);
        }
        let side = section.sides()[inserts as usize];
        near(side.high, 0.0, 1e-9);
        let corner = section.corners()[sides as usize - 1];
        if whole {
            near(side.flatness(), ellipse::sag(d, r, sides), 1e-9);
            near(corner.radius, full, 1e-9);
            near(section.across_corners().0, across_corners(d, r, sides), 1e-9);
            close(section.area(), area(d, r, sides), 1e-12);
        } else {
            near(side.flatness(), sag_in_stock(d, r, stock), 1e-9);
            assert!(!corner.meets && corner.radius == stock);
        }
    }
}

#[test]
fn ratio_1_sections_are_arcs_of_the_axis_distance() {
    // e^(-iσ) a - r: a circle about -r on the normal.
    let mut random = Random(2);
    for _ in 0..200 {
        let (d, r, inserts) = (random.between(1.0, 40.0), random.between(5.0, 150.0), random.integer(3, 9) as u32);
        let section = Section::new(&setup(d + r, r, ratio(1, 1), inserts), 1000.0).unwrap();
        let off = random.between(-1.0, 1.0) * PI / f64::from(inserts);
        let (sin, cos) = math::sin_cos(off);
        let a = d + r;
        near(section.radius(section.begin() + off), (a * a - r * r * sin * sin).sqrt() - r * cos, 1e-9);
    }
}

#[test]
fn side_count_of_500_ratios_matches_the_section() {
    let mut random = Random(3);
    for _ in 0..500 {
        let (ratio, inserts) = (random.ratio(), random.integer(1, 6) as u32);
        let mut cutter = setup(55.0, 45.0, ratio, inserts);
        let sides = cutter.sides();
        // One insert slightly off its angle: every pass is computed by itself, and none is repeated by symmetry.
        cutter.tips[0].radius -= 1e-7;
        let section = Section::new(&cutter, 13.0).unwrap();
        let radii = section.radii(sides as usize * 32);
        let lowest = |i: usize| {
            let at = |by: usize| radii[(i + by) % radii.len()];
            at(1) <= at(0) && at(1) < at(2) && at(1) < 10.0 + 1e-6
        };
        assert_eq!((0..radii.len()).filter(|&i| lowest(i)).count(), sides as usize, "{ratio:?} {inserts}");
    }
}

/// A cutter whose inserts are all a little, or not so little, out of their places.
fn worn(random: &mut Random) -> CutterSetup {
    let (d, r, inserts) = (random.between(3.0, 30.0), random.between(20.0, 60.0), random.integer(1, 5) as u32);
    let mut cutter = setup(d + r, r, random.ratio(), inserts);
    cutter.work_start = random.between(-4.0, 4.0);
    cutter.tool_start = random.between(-4.0, 4.0);
    let size = [0.0, 0.02, 1.0, 4.0][random.integer(0, 3) as usize];
    for tip in &mut cutter.tips {
        tip.radius += size * random.between(-1.0, 1.0);
        tip.angle += 0.1 * size * random.between(-1.0, 1.0);
    }
    cutter
}

#[test]
fn tips_pass_outside_the_section_and_never_inside() {
    let mut random = Random(4);
    let (mut sections, mut edges) = (0, 0);
    for case in 0..300 {
        let cutter = worn(&mut random);
        let stock = (cutter.distance - cutter.radius) * random.between(1.05, 6.0);
        let Some(section) = Section::new(&cutter, stock) else { continue };
        sections += 1;
        let (inserts, turns) = (cutter.tips.len(), f64::from(cutter.ratio.work()));
        // Within: no tip is ever nearer than the section. Random times in the turns in which the pattern closes.
        for _ in 0..2000 {
            let (insert, turned) =
                (random.integer(0, inserts as i32 - 1) as usize, random.between(0.0, 2.0 * PI * turns));
            let (x, y) = tip(&cutter, insert, turned);
            // Radii just beside the angle count as well: where a path turns back, it runs radially.
            let left =
                [-1e-12, 1e-12].map(|by| section.radius(math::atan2(y, x) + by)).into_iter().fold(stock, f64::min);
            assert!(math::hypot(x, y) >= left - 1e-9, "case {case}: {} in {left}, {cutter:?}", math::hypot(x, y));
        }
        // Outside: where the section is smaller than the stock, a tip has reached its edge.
        let k = cutter.ratio.value();
        for _ in 0..10 {
            let angle = random.between(0.0, 2.0 * PI);
            let radius = section.radius(angle);
            if radius > stock - 1e-9 {
                continue;
            }
            edges += 1;
            let point = (radius * math::cos(angle), radius * math::sin(angle));
            let off = |insert: usize, turned: f64| {
                let (x, y) = tip(&cutter, insert, turned);
                math::hypot(x - point.0, y - point.1)
            };
            // A tip is at that distance twice in each turn of the tool.
            let mut nearest = f64::INFINITY;
            for insert in 0..inserts {
                let Some(curve) = cutter.curve(insert).filter(|curve| curve.apothem() <= radius) else { continue };
                for turn in 0..cutter.ratio.tool().abs() {
                    for sigma in [curve.sigma_at(radius), -curve.sigma_at(radius)] {
                        let tool = 2.0 * PI * f64::from(turn) + sigma - cutter.tips[insert].angle - cutter.tool_start;
                        nearest = nearest.min(off(insert, tool / k));
                    }
                }
            }
            assert!(nearest < 1e-9, "case {case}: {nearest} mm from a tip at {angle}, {cutter:?}");
        }
    }
    assert!(sections > 100 && edges > 1000, "{sections} sections, {edges} edges");
}

#[test]
fn repeated_side_equals_pass_by_pass_section() {
    let mut random = Random(5);
    for _ in 0..100 {
        let (d, r, inserts) = (random.between(3.0, 30.0), random.between(20.0, 60.0), random.integer(1, 6) as u32);
        let even = setup(d + r, r, random.ratio(), inserts);
        let mut hair = even.clone();
        hair.tips[0].radius -= 1e-11;
        let stock = random.between(d, 1.4 * d);
        let (one, other) = (Section::new(&even, stock).unwrap(), Section::new(&hair, stock).unwrap());
        close(one.area(), other.area(), 1e-10);
        let count = even.sides() as usize * 10;
        for (fast, slow) in one.radii(count).iter().zip(other.radii(count)) {
            near(*fast, slow, 1e-9);
        }
        for (i, radius) in one.radii(101).iter().enumerate() {
            near(*radius, other.radius(one.begin() + 2.0 * PI * i as f64 / 101.0), 1e-9);
        }
        // Every point is on the outline, at a jump on one side of it or the other.
        for (x, y) in one.points(5) {
            let (angle, radius) = (math::atan2(y, x), math::hypot(x, y));
            let beside = [-1e-12, 1e-12].map(|by| (other.radius(angle + by) - radius).abs());
            // (There the outline runs straight out, so that rounding of an angle is much of a radius.)
            assert!(
                beside[0].min(beside[1]) < if even.ratio.tool() < 0 { 1e-4 } else { 1e-9 },
                "{beside:?} at {angle}"
            );
        }
    }
}

#[test]
fn section_area_equals_the_integral_of_radii() {
    // In the last row the sides turn back before they meet: there the radius jumps, and a sum is less exact.
    for (tool, work, inserts, stock, within) in [
        (2, 1, 3, 20.0, 1e-9),
        (12, 5, 5, 20.0, 1e-9),
        (-2, 1, 3, 12.0, 1e-9),
        (5, 2, 2, 11.0, 1e-9),
        (-1, 3, 2, 25.0, 2e-6),
    ] {
        let section = Section::new(&setup(55.0, 45.0, ratio(tool, work), inserts), stock).unwrap();
        let count = 720_000;
        let sum: f64 = section.radii(count).iter().map(|radius| radius * radius).sum();
        close(section.area(), sum * PI / count as f64, within);
    }
}

#[test]
fn displaced_insert_changes_its_own_sides() {
    // Two inserts, ratio 2: insert 1 cuts the sides 1 and 3.
    let mut cutter = setup(55.0, 45.0, ratio(2, 1), 2);
    cutter.tips[1].radius += 0.05;
    near(cutter.error(1).0, 0.05, 1e-12);
    let section = Section::new(&cutter, 20.0).unwrap();
    let sides = section.sides();
    for (side, depth) in sides.iter().zip([0.0, -0.05, 0.0, -0.05]) {
        near(side.middle, depth, 1e-12);
        near(side.high, depth, 1e-12);
        near(side.turned, 0.0, 1e-12);
    }
    near(section.across_flats().0, 19.9, 1e-9);
    near(section.across_flats().1, 20.0, 1e-9);

    // An insert 0.1 degrees ahead turns its sides by 0.05 degrees; they rise at one end and fall at the other.
    let ahead = 0.1 * PI / 180.0;
    let mut cutter = setup(55.0, 45.0, ratio(2, 1), 2);
    cutter.tips[1].angle += ahead;
    let section = Section::new(&cutter, 20.0).unwrap();
    let sides = section.sides();
    near(sides[1].turned, ahead / 2.0, 1e-12);
    near(sides[3].turned, ahead / 2.0, 1e-12);
    near(sides[0].turned, 0.0, 1e-15);
    let straight = Section::new(&setup(55.0, 45.0, ratio(2, 1), 2), 20.0).unwrap().sides()[1];
    assert!(sides[1].flatness() > straight.flatness() + 0.005, "{:?} {straight:?}", sides[1]);

    // Ratio 5/2 with 2 inserts: both cut every side, and the longer one alone is seen.
    let mut cutter = setup(55.0, 45.0, ratio(4, 2), 2);
    cutter.ratio = ratio(5, 2);
    cutter.tips[1].radius += 0.05;
    for side in Section::new(&cutter, 20.0).unwrap().sides() {
        near(side.middle, -0.05, 1e-12);
    }
}

#[test]
fn short_insert_leaves_its_sides_to_the_others() {
    let mut cutter = setup(55.0, 45.0, ratio(2, 1), 2);
    cutter.tips[1].radius -= 4.0;
    let section = Section::new(&cutter, 13.0).unwrap();
    let sides = section.sides();
    // Nothing of side 1 is cut: stock is left on its normal.
    near(sides[1].middle, 3.0, 1e-9);
    assert_eq!(sides[1].flatness(), 0.0);
    near(sides[0].high, 0.0, 1e-12);
    // A tip circle beyond the centre of the work is no cutter.
    cutter.tips[1].radius = 60.0;
    assert_eq!(Section::new(&cutter, 13.0), None);
}

#[test]
fn one_and_two_flats_end_at_the_stock() {
    let section = Section::new(&setup(55.0, 45.0, ratio(2, 1), 1), 12.0).unwrap();
    assert_eq!(section.sides().len(), 2);
    near(section.sides()[1].flatness(), 0.02225, 5e-6);
    assert_eq!(section.corners().len(), 2);
    assert!(section.corners().iter().all(|corner| !corner.meets && corner.radius == 12.0));
    near(section.across_corners().0, 24.0, 0.0);
    let one = Section::new(&setup(55.0, 45.0, ratio(1, 1), 1), 12.0).unwrap();
    assert_eq!((one.sides().len(), one.corners().len()), (1, 1));
    near(one.radius(one.begin() + PI), 12.0, 0.0);
    near(one.radius(one.begin()), 10.0, 1e-12);
}

#[test]
fn any_section_input_gets_a_finite_answer() {
    let odd = [f64::NAN, f64::INFINITY, -f64::INFINITY, -1.0, 0.0, 1e-300, 1e300, 20.0];
    for a in odd {
        for r in odd {
            for stock in odd {
                let mut cutter = setup(55.0, 45.0, ratio(7, 3), 2);
                (cutter.distance, cutter.radius, cutter.tips[1].radius) = (a, r, r);
                drop(Section::new(&cutter, stock));
                (cutter.work_start, cutter.tips[0].angle) = (a, r);
                drop(Section::new(&cutter, stock));
            }
        }
    }
    // More sides than a section has, none at all, and stock that no tip reaches.
    assert_eq!(Section::new(&setup(55.0, 45.0, ratio(9999, 1), 7), 20.0), None);
    let mut cutter = setup(55.0, 45.0, ratio(2, 1), 2);
    assert_eq!(Section::new(&cutter, 9.0).map(|section| section.area()), Some(PI * 81.0));
    let section = Section::new(&cutter, 12.0).unwrap();
    assert_eq!((section.radii(0), section.side(4)), (vec![], None));
    assert!(section.radius(f64::NAN) <= 12.0 || section.radius(f64::NAN).is_nan());
    cutter.tips.clear();
    assert_eq!(Section::new(&cutter, 20.0), None);
}
