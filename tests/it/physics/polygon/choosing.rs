//! From the polygon to the cutter: the flattest possible one first, and why the others are not possible.

use macroline::drives::polygon::choose::{Choice, ChoiceLimit, Cutter, LatheLimits, PolygonSpec, choices};
use macroline::drives::polygon::cut::{self, InsertLoad};

use super::*;

const HEXAGON: PolygonSpec = PolygonSpec { sides: 6, sizes: &[20.0], stock: 12.0, flatness: 0.05, hollow: false };

fn cutter(inserts: u32, radius: f64) -> Cutter {
    Cutter { inserts, radius: (radius, radius), relief: 15.0 * PI / 180.0 }
}

fn lathe(cutters: Vec<Cutter>) -> LatheLimits {
    LatheLimits {
        cutters,
        terms: (12, 5),
        against: false,
        work_speed: 1500.0,
        tool_speed: 3000.0,
        distance: (30.0, 120.0),
        cutting_speed: (60.0, 200.0),
    }
}

fn find(found: &[Choice], cutter: usize, k: Ratio) -> &Choice {
    found.iter().find(|one| one.cutter == cutter && one.ratio == k).unwrap()
}

#[test]
fn flattest_possible_choice_comes_first() {
    let found = choices(&HEXAGON, &lathe(vec![cutter(3, 45.0), cutter(3, 60.0), cutter(2, 45.0), cutter(1, 45.0)]));
    let best = &found[0];
    assert_eq!((best.cutter, best.ratio, best.limits.is_empty()), (1, ratio(2, 1), true));
    near(best.flatness(), 0.009847, 5e-6);
    near(best.deviation.1, 0.0, 1e-9);
    assert_eq!((found[1].cutter, found[1].ratio), (0, ratio(2, 1)));
    let possible = found.iter().take_while(|one| one.limits.is_empty()).count();
    assert!(found[possible..].iter().all(|one| !one.limits.is_empty()));
    for part in [&found[..possible], &found[possible..]] {
        assert!(part.is_sorted_by_key(Choice::flatness));
    }
    // Every one of them turns a hexagon.
    let inserts = [3, 3, 2, 1];
    assert!(found.iter().all(|one| one.ratio.sides(inserts[one.cutter]) == 6));
}

#[test]
fn choice_names_every_limit_that_excludes_it() {
    let narrow = LatheLimits { terms: (6, 1), ..lathe(vec![cutter(3, 45.0), cutter(2, 45.0)]) };
    let found = choices(&HEXAGON, &narrow);
    assert_eq!(find(&found, 0, ratio(2, 1)).limits, []);
    assert_eq!(find(&found, 1, ratio(3, 1)).limits, [ChoiceLimit::Hollow, ChoiceLimit::Flatness]);
    // The wrong sense: its sides would meet 12.895 mm from the centre.
    let wrong = |stock: f64| {
        let found = choices(&PolygonSpec { stock, ..HEXAGON }, &narrow);
        find(&found, 0, ratio(-2, 1))
            .limits
            .iter()
            .copied()
            .take_while(|limit| *limit != ChoiceLimit::Relief)
            .collect::<Vec<ChoiceLimit>>()
    };
    assert_eq!(wrong(12.85), [ChoiceLimit::Sense, ChoiceLimit::Gap, ChoiceLimit::Hollow, ChoiceLimit::Flatness]);
    assert_eq!(wrong(12.95), [ChoiceLimit::Sense, ChoiceLimit::Hollow, ChoiceLimit::Flatness]);
    let far = LatheLimits { distance: (60.0, 120.0), ..narrow.clone() };
    assert_eq!(find(&choices(&HEXAGON, &far), 0, ratio(2, 1)).limits, [ChoiceLimit::Distance]);
    let mut blunt = narrow.clone();
    blunt.cutters[0].relief = 3.0 * PI / 180.0;
    assert_eq!(find(&choices(&HEXAGON, &blunt), 0, ratio(2, 1)).limits, [ChoiceLimit::Relief]);
    let hollow = PolygonSpec { hollow: true, flatness: 0.2, ..HEXAGON };
    assert_eq!(find(&choices(&hollow, &narrow), 1, ratio(3, 1)).limits, []);
    assert!(choices(&PolygonSpec { sides: 7, ..HEXAGON }, &narrow).is_empty());
}

#[test]
fn speeds_reach_the_binding_limit() {
    let one = lathe(vec![cutter(3, 45.0)]);
    let of = |lathe: &LatheLimits| find(&choices(&HEXAGON, lathe), 0, ratio(2, 1)).clone();
    let free = of(&one);
    // 318.31 r/min would cut at 200 m/min: the next whole number below.
    assert_eq!((free.speed, free.work_speed, free.tool_speed), (318.0, 318.0, 636.0));
    // 2π n (a + r) / 1000 over the middle of the side.
    close(free.cutting_speed.1, 2.0 * PI * free.work_speed * 100.0 / 1000.0, 1e-12);
    let slow = of(&LatheLimits { tool_speed: 150.0, ..one.clone() });
    close(slow.tool_speed, 150.0, 1e-12);
    assert_eq!(slow.limits, [ChoiceLimit::ToolSpeed]);
    // No whole number above 0 is slow enough: the least one is shown, and excluded.
    let slower = of(&LatheLimits { tool_speed: 1.5, ..one.clone() });
    assert_eq!((slower.tool_speed, &slower.limits[..]), (2.0, &[ChoiceLimit::ToolSpeed][..]));
    assert_eq!(of(&LatheLimits { work_speed: 50.0, ..one.clone() }).limits, [ChoiceLimit::WorkSpeed]);
    assert_eq!(of(&LatheLimits { cutting_speed: (150.0, 150.01), ..one }).limits, [ChoiceLimit::CuttingSpeed]);
}

#[test]
fn adjustable_cutter_balances_crown_and_hollow() {
    // No other limit: every radius is possible.
    let range = |inserts| Cutter { radius: (5.0, 60.0), relief: 1.5, ..cutter(inserts, 0.0) };
    let free = LatheLimits {
        distance: (10.0, 120.0),
        cutting_speed: (1.0, 200.0),
        ..lathe(vec![range(3), range(2), range(5)])
    };
    let spec = PolygonSpec { hollow: true, flatness: 1.0, ..HEXAGON };
    let found = choices(&spec, &free);
    // Ratio 2: the greatest there is.
    assert_eq!(find(&found, 0, ratio(2, 1)).radius, 60.0);
    // Above it: near the radius that is flat in the middle, and flatter than its neighbours.
    for (at, k, inserts, sides) in [(2, ratio(12, 5), 5, 12), (1, ratio(3, 1), 2, 6)] {
        let spec = PolygonSpec { sides, ..spec };
        let list = choices(&spec, &free);
        let best = find(&list, at, k);
        assert_eq!(best.limits, []);
        let error = |radius: f64| {
            let section = Section::new(&CutterSetup::even(20.0, radius, k, inserts), spec.stock).unwrap();
            section.sides()[0].flatness()
        };
        near(error(best.radius), best.flatness(), 1e-12);
        for i in 0..=200 {
            let other = 5.0 + 55.0 * f64::from(i) / 200.0;
            assert!(best.flatness() <= error(other) + 1e-6, "{k:?}: {other} is flatter than {}", best.radius);
        }
    }
}

#[test]
fn cutter_radius_stays_within_its_range() {
    // No hollow sides: at ratio 3 the largest crowned circle, r = d/3 (curvature 0 in the middle).
    let range = Cutter { radius: (3.0, 60.0), relief: 60.0 * PI / 180.0, ..cutter(2, 0.0) };
    let near_by = LatheLimits { distance: (10.0, 120.0), cutting_speed: (5.0, 200.0), ..lathe(vec![range]) };
    let found = choices(&HEXAGON, &near_by);
    let crowned = find(&found, 0, ratio(3, 1));
    assert_eq!(crowned.limits, []);
    near(crowned.radius, 10.0 / 3.0, 0.01);
    // Axes from 30 to 35 mm apart: hollow, and the less so the larger the circle.
    let apart = LatheLimits { distance: (30.0, 35.0), ..near_by };
    let hollow = PolygonSpec { hollow: true, flatness: 0.2, ..HEXAGON };
    let found = choices(&hollow, &apart);
    near(find(&found, 0, ratio(3, 1)).radius, 25.0, 1e-3);
    assert_eq!(find(&found, 0, ratio(3, 1)).limits, []);
}

#[test]
fn pass_relief_reaches_the_corners_of_the_pass_before() {
    let mut random = Random(11);
    let (mut met, mut stood) = (0, 0);
    for _ in 0..300 {
        let (k, inserts) = (random.ratio(), random.integer(1, 6) as u32);
        let (radius, size) = (random.between(20.0, 80.0), random.between(8.0, 40.0));
        let sizes = [size + random.between(0.2, 6.0), size];
        let stock = 0.5 * sizes[0] * random.between(1.01, 1.6);
        let [before, now] = sizes.map(|size| CutterSetup::even(size, radius, k, inserts));
        let (first, last) = (before.curve(0).unwrap(), now.curve(0).unwrap());
        let section = Section::new(&before, stock).unwrap();
        let cuts: Vec<InsertLoad> = cut::passes(&sizes, radius, k, now.sides(), stock).collect();
        close(cuts[0].relief, first.relief_needed(first.sigma_at(stock)), 1e-12);
        let edge = last.sigma_at(section.corners()[0].radius);
        near(cuts[1].relief, last.relief_needed(edge), 1e-7);
        close(cuts[1].speeds.1, last.speeds(1.0, edge).1, 1e-7);
        // Nothing of the work is further out on its path.
        let whole = last.sigma_at(stock);
        let within = |sigma: f64| last.reach(sigma) < section.radius(section.begin() + last.turn(sigma)) - 1e-9;
        let out = (0..=400).map(|i| whole * f64::from(i) / 400.0).rfind(|sigma| within(*sigma)).unwrap();
        assert!(out <= edge + 1e-7 && edge <= whole + 1e-12, "{k:?}: {out} {edge} {whole}");
        *(if edge < whole * 0.999 { &mut met } else { &mut stood }) += 1;
    }
    assert!(met > 40 && stood > 40, "{met} {stood}");
}

#[test]
fn odd_arguments_get_an_answer() {
    for radius in [(f64::NAN, 1.0), (0.0, 0.0), (-5.0, 5.0), (60.0, 5.0), (1.0, f64::INFINITY)] {
        let strange = lathe(vec![Cutter { radius, ..cutter(3, 1.0) }, Cutter { inserts: 0, ..cutter(1, 45.0) }]);
        for across_flats in [20.0, 0.0, -4.0, f64::NAN] {
            drop(choices(&PolygonSpec { sizes: &[across_flats], ..HEXAGON }, &strange));
        }
    }
    let most = LatheLimits { terms: (u32::MAX, u32::MAX), ..lathe(vec![cutter(u32::MAX, 45.0)]) };
    drop(choices(&HEXAGON, &most));
}
