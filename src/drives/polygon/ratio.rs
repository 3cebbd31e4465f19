//! Ratio of tool to work speed as two integers, and its number of sides.

/// Turns of the tool to turns of the work, in lowest terms. A negative ratio means opposite directions, seen from one side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ratio {
    tool: i32,
    work: i32,
}

/// The greatest term of a ratio.
const MOST: u32 = 9999;

impl Ratio {
    /// The ratio of two integers of either sign, each up to 9999; `None` if one of them is 0 or larger.
    pub fn new(tool: i32, work: i32) -> Option<Ratio> {
        let terms = 1..=MOST;
        if !terms.contains(&tool.unsigned_abs()) || !terms.contains(&work.unsigned_abs()) {
            return None;
        }
        let common = gcd(tool.unsigned_abs(), work.unsigned_abs()) as i32 * work.signum();
        Some(Ratio { tool: tool / common, work: work / common })
    }

    /// Turns of the tool until the pattern closes, with the sign of the ratio.
    pub fn tool(self) -> i32 {
        self.tool
    }

    /// Turns of the work until the pattern closes, at least 1.
    pub fn work(self) -> i32 {
        self.work
    }

    /// Tool speed over work speed, k.
    pub fn value(self) -> f64 {
        f64::from(self.tool) / f64::from(self.work)
    }

    /// Number of sides with evenly spaced inserts: `N = n |p| / gcd(n, q)` for k = p/q, of either sign. Source: polygon turning facts 3.2.
    pub fn sides(self, inserts: u32) -> u32 {
        (inserts / gcd(inserts, self.work.unsigned_abs()).max(1)).saturating_mul(self.tool.unsigned_abs())
    }

    /// The ratio for a number of sides and of inserts with a pattern that closes in `work` turns of the work. There is at most one,
    /// `|p| = N gcd(n, q) / n`, and its negative.
    pub fn for_sides(sides: u32, inserts: u32, work: u32) -> Option<Ratio> {
        let tool = u64::from(sides) * u64::from(gcd(inserts, work));
        let tool = tool.checked_div(u64::from(inserts)).and_then(|turns| i32::try_from(turns).ok())?;
        let ratio = Ratio::new(tool, i32::try_from(work).ok()?)?;
        (ratio.work.unsigned_abs() == work && ratio.sides(inserts) == sides).then_some(ratio)
    }

    /// Cuts of a side per turn of the work: `gcd(n, q) / q`. The distance of the feed marks on a flat is the feed per turn divided by it.
    /// Source: polygon turning facts 3.2.
    pub fn passes_per_turn(self, inserts: u32) -> f64 {
        f64::from(gcd(inserts, self.work.unsigned_abs())) / f64::from(self.work)
    }
}

/// Greatest common divisor.
pub(super) fn gcd(mut a: u32, mut b: u32) -> u32 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
