//! Rules about ribbon between unwinder and pull roller: the loop, the slack rate, the knob, the tension of the web.

use crate::controls::Code;
use crate::machines::form::entry::{NumberEntry, at_least, nearest};
use crate::machines::ribbon_line::axes::{LineAxis, PerAxis};
use crate::machines::ribbon_line::derive::{Derived, greatest, least_dwell};
use crate::machines::ribbon_line::params::{AXIS_FIELDS, FIELDS, Params, PathMode, Variant, Wait};
use crate::machines::ribbon_line::regulated_loop;
use crate::machines::ribbon_line::regulator::set_point;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::tension_switch::{TensionSwitch, with_pinch};
use crate::machines::ribbon_line::unwinder_motor::shortest_ramp;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::text::catalog::sentence;
use crate::text::{Message, clauses};
use crate::view::Advice;
use crate::view::FieldEntry;
use crate::view::Limit::{AtMost, Equal, Within};

/// Entries that give both axes the greater time constant and the lower gain.
pub(in crate::machines::ribbon_line) fn equal_entries(p: &Params) -> Vec<NumberEntry> {
    let PerAxis { pull, print } = &p.axes;
    let slow = pull.time_constant.max(print.time_constant);
    let soft = pull.position_gain.min(print.position_gain);
    let slower = LineAxis::BOTH.map(|axis| (AXIS_FIELDS[axis].time_constant, p.axes[axis].time_constant, slow));
    let softer = LineAxis::BOTH.map(|axis| (AXIS_FIELDS[axis].position_gain, p.axes[axis].position_gain, soft));
    let unequal = slower.into_iter().chain(softer).filter(|(_, value, same)| value != same);
    unequal.map(|(id, _, same)| nearest(FIELDS, id, same)).collect()
}

/// Both axes with the greater time constant and the lower gain.
pub(in crate::machines::ribbon_line) fn equal_axes(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, .. } = line;
    let (sets, PerAxis { pull, print }) = (equal_entries(p), &p.axes);
    let mut advice = Vec::new();
    let mut say =
        |message: Message| advice.push(Advice::from(message).setting(msg!("advice.make-equal"), sets.clone()));
    if pull.time_constant != print.time_constant {
        say(msg!(
            "ribbon.unequal-time-constants",
            time_x = (pull.time_constant, 1),
            axis = line.print_letter(),
            time = (print.time_constant, 1)
        ));
    }
    if pull.position_gain != print.position_gain {
        say(msg!(
            "ribbon.unequal-gains",
            gain_x = (pull.position_gain, 2),
            axis = line.print_letter(),
            gain = (print.position_gain, 2),
            error = (d.accuracy.register_error, 3)
        ));
    }
    if advice.is_empty() {
        return ok(Equal(0.0));
    }
    // At standstill, and where the differences cancel, there is no error yet.
    fail((d.accuracy.register_error != 0.0).then_some(Equal(0.0)), advice)
}

/// Entry of the shortest dwell (s) with which no start pulls the ribbon tight, with the knob at its highest position:
/// each second of dwell lays `v` mm more. 0 with a feed per revolution, which follows the unwinder from standstill.
fn matching_dwell(line: &RibbonLine, p: &Params) -> NumberEntry {
    let [_, fast, _] = line.with(&Params { wait: Wait::Dwell, dwell: 0.0, ..p.clone() });
    let short = if line.feeds_per_revolution() { 0.0 } else { -fast.slack.start / fast.feeds.mm_per_second() };
    let dwell = if short > 0.0 { least_dwell(p) + short } else { 0.0 };
    at_least(FIELDS, "dwell", dwell)
}

/// The results at the position of the knob at which a product may lay most ribbon into the loop.
pub(in crate::machines::ribbon_line) fn worst_loop(line: &RibbonLine) -> &Derived {
    line.worst(|d| d.slack.loop_needed)
}

/// Longest loop (mm) that an advice offers: hanging free it is half as deep. Engineering choice.
pub(in crate::machines::ribbon_line) const LONGEST_LOOP: f64 = 5000.0;

/// A change of the form that an advice offers.
pub(in crate::machines::ribbon_line) struct FormChange {
    /// Words of the button that makes it.
    button: Message,
    /// Entries of the form.
    entries: Vec<FieldEntry>,
}

/// An advice whose button takes several changes and names each.
fn taking(advice: Advice, changes: Vec<FormChange>) -> Advice {
    let button = match &changes[..] {
        [only] => only.button.clone(),
        all => msg!("advice.several", changes = clauses(all.iter().map(|change| sentence(&change.button)))),
    };
    advice.setting(button, changes.into_iter().flat_map(|change| change.entries).collect::<Vec<_>>())
}

/// A loop is built to centimetres.
const LOOP_STEP: f64 = 10.0;

/// The loop that holds `needed` mm.
fn longer_loop(needed: f64) -> FormChange {
    let set = at_least(FIELDS, "loop-capacity", LOOP_STEP * (needed / LOOP_STEP).ceil());
    FormChange { button: msg!("advice.set-loop", capacity = set.text.as_str()), entries: vec![set.into()] }
}

/// Adds a button to an advice: these changes, and the loop for the `needed` mm that a product then lays. No button if
/// the loop would be longer than [`LONGEST_LOOP`].
pub(in crate::machines::ribbon_line) fn with_loop(advice: Advice, needed: f64, changes: Vec<FormChange>) -> Advice {
    if needed > LONGEST_LOOP {
        return advice;
    }
    taking(advice, changes.into_iter().chain([longer_loop(needed)]).collect())
}

/// The parts of the loop that a product needs; with the regulator of a dancer also what products before have left.
fn sum_of_loop(line: &RibbonLine, d: &Derived) -> Message {
    let (percent, needed) = ((d.unwinder.effective_override, 1), (d.slack.loop_needed.ceil(), 0));
    let capacity = (line.params.loop_capacity, 0);
    let [start, stop] = [d.slack.start, d.slack.stop].map(|laid| (laid.abs(), 0));
    let (run, hold) = (((d.slack.run.abs() + d.slack.standing), 0), (d.slack.interruption, 0));
    if d.slack.set_point > 0.0 || d.slack.before > 0.0 {
        let before = if d.slack.before.is_finite() { d.slack.before } else { 0.0 };
        let (before, kept) = ((before, 0), (d.slack.set_point, 0));
        return msg!("ribbon.loop-too-small-dancer", percent, needed, capacity, before, kept, start, run, stop, hold);
    }
    msg!("ribbon.loop-too-small", percent, needed, capacity, start, run, stop, hold)
}

/// The results at the position of the knob at which start and stop of a product add most ribbon.
fn most_added(line: &RibbonLine) -> &Derived {
    line.worst(|d| d.slack.start + d.slack.stop)
}

/// Ribbon (mm) that each product adds to the loop beyond the trim of a dancer: `start + stop - λ · l`, with the length l of a product, at the
/// worst position of the knob; negative where the dancer takes it away. Source: ribbon line facts, 7.
pub(in crate::machines::ribbon_line) fn loop_growth(line: &RibbonLine) -> f64 {
    growth_at(line, most_added(line))
}

/// Whether a loop that many products leave is known.
pub(in crate::machines::ribbon_line) fn settles(line: &RibbonLine) -> bool {
    line.params.loop_trim() > 0.0 && line.derived.slack.before.is_finite()
}

/// Ribbon (mm) that each product adds beyond the trim at one position of the knob.
fn growth_at(line: &RibbonLine, at: &Derived) -> f64 {
    at.slack.start + at.slack.stop - line.params.loop_trim() * at.product.length
}

/// Warns about products that lay more ribbon than the dancer takes away while they run, so that the operator has to take up the loop; of a
/// line that does so at the set position of the knob it says with which product its sensor holds the program.
pub(in crate::machines::ribbon_line) fn grows(line: &RibbonLine) -> Option<Judgement> {
    let limit = AtMost(0.0);
    if limit.holds(loop_growth(line)) {
        return ok(limit);
    }
    let (worst, trim) = (most_added(line), line.params.loop_trim());
    let laid = worst.slack.start + worst.slack.stop;
    let (percent, taken) = ((worst.unwinder.effective_override, 1), (trim * worst.product.length, 0));
    let length = ((laid / trim).ceil(), 0);
    let now = growth_at(line, &line.derived);
    if now > 0.0 {
        // Each product needs the room of one more than has room now.
        let room = line.params.loop_capacity - line.derived.slack.laid_to_the_end();
        let count = ((room / now).floor().max(0.0) + 1.0, 0);
        return warn(limit, [msg!("ribbon.loop-fills-by-products", added = (now, 0), taken, count, length).into()]);
    }
    warn(limit, [msg!("ribbon.loop-grows", percent, laid = (laid, 0), taken, length).into()])
}

/// Judges the ribbon that a product lays into the loop, with one interruption, against the loop's capacity, over the range of the knob.
pub(in crate::machines::ribbon_line) fn loop_needed(line: &RibbonLine) -> Option<Judgement> {
    let (p, d) = (&line.params, worst_loop(line));
    let limit = AtMost(p.loop_capacity);
    if d.slack.loop_needed <= p.loop_capacity {
        return ok(limit);
    }
    let mut advice = vec![with_loop(sum_of_loop(line, d).into(), d.slack.loop_needed, Vec::new())];
    let after = |form: &Params| greatest(&line.with(form), |d| d.slack.loop_needed);
    // Offers changes of wait and ramp with the loop that is still needed, if such a loop can be built.
    let mut offer = |message: Message, left: f64, changes: Vec<FormChange>| {
        if left <= p.loop_capacity {
            advice.push(taking(message.into(), changes));
        } else if left <= LONGEST_LOOP {
            advice.push(with_loop(message.into(), left, changes));
        }
    };
    let dwelt = with_matching_dwell(line, p.clone());
    let left = after(&dwelt.form);
    if left < d.slack.loop_needed {
        let message = msg!("ribbon.matching-dwell", time = dwelt.typed.as_str(), capacity = (left.ceil(), 0));
        offer(message, left, vec![dwelt.change]);
    }
    let ramp = at_least(FIELDS, "inverter-ramp", shortest_ramp(line));
    if ramp.value < p.inverter_ramp {
        let steep = with_matching_dwell(line, Params { inverter_ramp: ramp.value, ..p.clone() });
        let shortest = after(&steep.form);
        if shortest < left.min(d.slack.loop_needed) {
            let message = msg!("ribbon.shorter-ramp", time = ramp.text.as_str(), capacity = (shortest.ceil(), 0));
            let button = msg!("advice.set-ramp", time = ramp.text.as_str());
            offer(message, shortest, vec![FormChange { button, entries: vec![ramp.into()] }, steep.change]);
        }
    }
    if d.slack.run != 0.0 && !p.is_regulated() {
        advice.push(with_dancer(line, msg!("ribbon.run-fills", length = (d.slack.run.abs(), 0))));
    }
    fail(limit, advice)
}

/// Least ribbon (mm) in the loop while the line runs, over the positions of the knob.
fn least_laid_by_start(line: &RibbonLine) -> f64 {
    line.over_knob().into_iter().map(least_laid).fold(f64::INFINITY, f64::min)
}

/// The same at one position of the knob.
fn least_laid(at: &Derived) -> f64 {
    at.slack.start.min(at.slack.start + at.slack.run)
}

/// Whether one turn of the knob lays ribbon.
pub(in crate::machines::ribbon_line) fn turns_with_queue(line: &RibbonLine) -> bool {
    line.knob_turn().acts()
}

/// One turn of the knob in which X pulls more ribbon than the unwinder lays.
struct StarvingTurn {
    /// Positions (%) before and after it.
    from: f64,
    to: f64,
    /// Ribbon (mm) that is missing after it.
    missing: f64,
    /// Ribbon (mm) in the loop before it, at its least.
    laid: f64,
}

impl StarvingTurn {
    /// The turn with most ribbon missing beyond that in the loop: down to the lowest position, on to 0, or up from any position.
    fn worst(line: &RibbonLine) -> StarvingTurn {
        let turn = line.knob_turn();
        let [low, high] = [&line.slow, &line.fast].map(|d| d.unwinder.effective_override);
        let laid = least_laid_by_start(line);
        let down = StarvingTurn { from: high, to: low, missing: turn.missing_at_lowest(), laid };
        let stop = StarvingTurn { from: low, to: 0.0, missing: turn.missing_at_zero(), laid };
        let up = turn.positions_below_highest().map(|from| (from, turn.missing_at_highest(from)));
        let up = up.filter(|(_, missing)| *missing > 0.0).map(|(from, missing)| {
            let laid = least_laid(&line.at(from));
            // A regulator brings the loop from the start to its set point.
            let laid = if line.params.is_regulated() { laid.min(set_point(line)) } else { laid };
            StarvingTurn { from, to: high, missing, laid }
        });
        let others = [stop].into_iter().chain(up);
        others.fold(down, |worst, next| if next.beyond_loop() > worst.beyond_loop() { next } else { worst })
    }

    /// Ribbon (mm) that is missing beyond that in the loop.
    fn beyond_loop(&self) -> f64 {
        self.missing - self.laid
    }

    fn is_up(&self) -> bool {
        self.to > self.from
    }

    fn message(&self, line: &RibbonLine, most: f64) -> Message {
        let (missing, kept) = ((self.missing, 1), (up_to_tenth(self.missing - most), 1));
        let turn = line.knob_turn();
        if self.is_up() {
            let speed = line.fast.feeds.mm_per_second() * self.from / self.to;
            let time = turn.least_queued() / speed;
            let (low, high) = ((self.from, 0), (self.to, 0));
            return msg!("ribbon.knob-outruns", low, high, time = (time, 1), missing, kept);
        }
        let (low, high) = ((self.to, 0), (self.from, 0));
        msg!("ribbon.knob-starves", queued = (turn.queued(), 0), low, high, missing, kept)
    }
}

/// Ribbon (mm) that one turn of the knob pulls more than is laid; 0 where a turn lays none.
pub(in crate::machines::ribbon_line) fn missing_by_turn(line: &RibbonLine) -> f64 {
    if turns_with_queue(line) { StarvingTurn::worst(line).missing } else { 0.0 }
}

/// A shortage (mm) as a message shows it, rounded up to tenths: none is shown as 0.
fn up_to_tenth(shortage: f64) -> f64 {
    (10.0 * shortage).ceil() / 10.0
}

/// Greatest ribbon (mm) in the loop at the end of a product, at the worst position of the knob.
fn laid_to_the_end(line: &RibbonLine) -> f64 {
    greatest(line.over_knob(), |d| d.slack.laid_to_the_end())
}

/// Loop (mm) that takes a product in which the knob is turned once from its lowest position to its highest: the loop keeps the ribbon of
/// the turn, and the stop at the end adds its own. Source: ribbon line facts, 5.
pub(in crate::machines::ribbon_line) fn loop_for_turn(line: &RibbonLine) -> f64 {
    laid_to_the_end(line) + line.knob_turn().laid()
}

/// Judges one turn of the knob up, as the operating envelope does: the loop has to take its ribbon.
pub(in crate::machines::ribbon_line) fn turn_up(line: &RibbonLine) -> Option<Judgement> {
    let (p, needed) = (&line.params, loop_for_turn(line));
    let limit = AtMost(p.loop_capacity);
    if needed <= p.loop_capacity {
        return ok(limit);
    }
    let (turn, room) = (line.knob_turn(), p.loop_capacity - laid_to_the_end(line));
    let laid = turn.laid();
    let message = msg!(
        "ribbon.knob-fills-loop",
        low = (line.slow.unwinder.effective_override, 0),
        high = (line.fast.unwinder.effective_override, 0),
        laid = (laid.ceil(), 0),
        queued = (turn.queued(), 0),
        before = (laid_to_the_end(line).ceil(), 0),
        capacity = (p.loop_capacity, 0)
    );
    let longer = with_loop(message.into(), needed, Vec::new());
    let lowest = line.fast.unwinder.effective_override / (1.0 + room.max(0.0) / turn.queued());
    let others = [higher_lowest(line, lowest), fewer_pitches(line, room / laid)];
    fail(limit, [longer].into_iter().chain(others.into_iter().flatten()).collect::<Vec<_>>())
}

/// Judges one turn of the knob down or up, as the operating envelope does: its ribbon comes from the loop and from the stretch at which the
/// tension switch opens.
pub(in crate::machines::ribbon_line) fn turn_starves(line: &RibbonLine) -> Option<Judgement> {
    let (turn, stretch) = (StarvingTurn::worst(line), TensionSwitch::new(line).missing);
    let most = (turn.laid + stretch).max(0.0);
    let limit = AtMost(most);
    if missing_by_turn(line) <= most {
        return ok(limit);
    }
    let harder = with_pinch(line, turn.message(line, most), turn.beyond_loop());
    // The start at each position has to lay the ribbon to which a regulator brings the loop.
    let kept = if line.params.is_regulated() {
        line.knob_turn().missing() - least_laid_by_start(line)
    } else {
        turn.beyond_loop()
    };
    let dwell = longer_dwell(line, kept - stretch);
    let others = if turn.is_up() {
        [None, None, dwell]
    } else {
        let knob = line.knob_turn();
        let lowest = line.fast.unwinder.effective_override * (1.0 - most / knob.queued());
        let higher = higher_lowest(line, lowest).filter(|_| knob.missing_at_zero() <= most);
        [higher, fewer_pitches(line, most / turn.missing), dwell]
    };
    fail(limit, [harder].into_iter().chain(others.into_iter().flatten()).collect::<Vec<_>>())
}

/// A dwell after which the start has laid `kept` mm more, and the loop that takes them; none where the start does not wait by a dwell. Each
/// second lays `v` mm, least with the knob at its lowest position, most at its highest.
fn longer_dwell(line: &RibbonLine, kept: f64) -> Option<Advice> {
    let p = &line.params;
    if p.wait != Wait::Dwell {
        return None;
    }
    let least = p.dwell.max(least_dwell(p)) + kept / line.slow.feeds.mm_per_second();
    let set = at_least(FIELDS, "dwell", least);
    if set.value < least {
        return None;
    }
    let laid = (set.value - p.dwell) * line.fast.feeds.mm_per_second();
    let after = line.with(&Params { dwell: set.value, ..p.clone() });
    let needed = greatest(&after, |d| d.slack.loop_needed);
    let needed = needed.max(loop_for_turn(line) + laid);
    let message = msg!("ribbon.dwell-for-turn", time = set.text.as_str(), kept = (up_to_tenth(kept), 1));
    let button = msg!("advice.set-dwell", time = set.text.as_str());
    let dwell = FormChange { button, entries: vec![set.into()] };
    if needed > LONGEST_LOOP {
        return None;
    }
    let loops = (needed > p.loop_capacity).then(|| longer_loop(needed));
    Some(taking(message.into(), [dwell].into_iter().chain(loops).collect()))
}

/// The lowest position of the knob from which one turn holds, for the PLC to limit it there; none where the form's position is lower.
fn higher_lowest(line: &RibbonLine, lowest: f64) -> Option<Advice> {
    let set = at_least(FIELDS, "knob-lowest", lowest);
    if set.value <= line.params.knob_lowest || set.value < lowest || set.value > line.params.override_stepped() {
        return None;
    }
    let message = msg!("ribbon.higher-lowest", percent = (set.value, 0));
    Some(Advice::from(message).setting(msg!("advice.set-lowest-knob", percent = set.text.as_str()), [set]))
}

/// The greatest number of pitches per block at which a turn of the knob moves at most `share` of the ribbon that it moves now; none where
/// one is too many.
fn fewer_pitches(line: &RibbonLine, share: f64) -> Option<Advice> {
    let (p, turn) = (&line.params, line.knob_turn());
    let pitches = (turn.queued() * share / turn.queued_per_pitch()).floor();
    if p.variant != Variant::ReadyMade || pitches < 1.0 || pitches >= p.block_pitches() {
        return None;
    }
    let set = nearest(FIELDS, "pitches-per-block", pitches);
    let message = msg!("ribbon.fewer-pitches-to-turn", count = (set.value, 0));
    Some(Advice::from(message).setting(msg!("advice.set-pitches", count = set.text.as_str()), [set]))
}

/// A form with the dwell that suits its other entries.
struct DweltForm {
    form: Params,
    /// The dwell (s) as typed.
    typed: String,
    /// The change of the form to it.
    change: FormChange,
}

/// The form with a dwell by [`matching_dwell`] in place of its own wait.
fn with_matching_dwell(line: &RibbonLine, form: Params) -> DweltForm {
    let set = matching_dwell(line, &form);
    let (dwell, typed) = (set.value, set.text.clone());
    let button = msg!("advice.set-dwell", time = typed.as_str());
    let change = FormChange { button, entries: vec![FieldEntry::new("wait", "dwell"), set.into()] };
    DweltForm { form: Params { wait: Wait::Dwell, dwell, ..form }, typed, change }
}

/// Adds the dwell with which no start misses ribbon, and the loop that the ribbon of that dwell then needs.
pub(in crate::machines::ribbon_line) fn with_dwell(line: &RibbonLine, message: Message) -> Advice {
    let dwelt = with_matching_dwell(line, line.params.clone());
    let needed = greatest(&line.with(&dwelt.form), |d| d.slack.loop_needed);
    if needed > line.params.loop_capacity && needed <= LONGEST_LOOP {
        with_loop(message.into(), needed, vec![dwelt.change])
    } else {
        taking(message.into(), vec![dwelt.change])
    }
}

/// Slack rate (mm/min) that an operator can watch and correct by hand: 50. Engineering choice.
const DRIFT: f64 = 50.0;

/// Advice for blocks that the axes execute faster than the control reads them; `kept`: remaining share of the speed, %.
fn starved(line: &RibbonLine, kept: (f64, u8)) -> Advice {
    let RibbonLine { params: p, derived: d, .. } = line;
    let message = msg!("ribbon.starved", percent = kept);
    let ready = Params { variant: Variant::ReadyMade, ..p.clone() };
    let pitches = ready.pass_needed() * line.driven_share(d) / d.timing.pitch;
    let set = at_least(FIELDS, "pitches-per-block", pitches.max(p.pitches_per_block));
    match p.variant {
        Variant::ReadyMade => {
            Advice::from(message).setting(msg!("advice.set-pitches", count = set.text.as_str()), [set])
        }
        Variant::Published | Variant::Precomputed => Advice::from(message)
            .setting(msg!("advice.ready-made"), [FieldEntry::new("variant", "ready-made"), set.into()]),
    }
}

fn drift(rate: f64, line: &RibbonLine) -> Option<Judgement> {
    let limit = Within(DRIFT);
    if rate.abs() <= DRIFT {
        return ok(limit);
    }
    let RibbonLine { params: p, derived: d, .. } = line;
    let lasts = p.loop_capacity / rate.abs() * 60.0;
    let fills = if rate > 0.0 {
        msg!("ribbon.loop-fills", rate = (rate, 0), capacity = (line.params.loop_capacity, 0), time = (lasts, 0))
    } else {
        msg!("ribbon.loop-empties", rate = (-rate, 0), capacity = (line.params.loop_capacity, 0), time = (lasts, 0))
    };
    let mut advice = vec![Advice::from(fills)];
    // Loss of X by exact stops and starved blocks, mm/min; a regulator leaves what is beyond its trim.
    let lost = d.feeds.line_speed * (1.0 - d.timing.kept);
    if lost > DRIFT {
        let kept = (d.timing.kept * 100.0, 1);
        advice.push(match p.path_mode {
            PathMode::ExactStop => Advice::from(msg!("ribbon.stops-lose", percent = kept))
                .setting(msg!("advice.continuous"), [("path-mode", "continuous")]),
            PathMode::Continuous => starved(line, kept),
        });
    }
    if !p.is_regulated() && (rate - lost).abs() > DRIFT {
        advice.push(with_dancer(line, msg!("ribbon.trim")));
    }
    fail(limit, advice)
}

/// An advice to fit a dancer, where X follows the unwinder with a feed per minute, since it would follow the trim.
pub(in crate::machines::ribbon_line) fn with_dancer(line: &RibbonLine, advice: Message) -> Advice {
    let advice = Advice::from(advice);
    if line.feeds_per_revolution() {
        let entries = [("dancer", "true"), ("feed-form", "per-minute")];
        return advice.setting(msg!("advice.add-dancer-per-minute"), entries);
    }
    advice.setting(msg!("advice.add-dancer"), [("dancer", "true")])
}

pub(in crate::machines::ribbon_line) fn slack_rate(line: &RibbonLine) -> Option<Judgement> {
    drift(line.derived.slack.rate, line)
}

pub(in crate::machines::ribbon_line) fn slack_rate_rated(line: &RibbonLine) -> Option<Judgement> {
    drift(line.derived.slack.rate_rated, line)
}

/// Slack rate (mm/min) with the knob at its worse extreme position, where the knob turns the unwinder and the axes stay; else 0:
/// `K · (n_knob - n)`, less the trim of a regulator.
pub(in crate::machines::ribbon_line) fn knob_slack(line: &RibbonLine) -> f64 {
    worst_knob(line).map_or(0.0, |knob| knob.slack_rate)
}

/// A position of a knob that turns the unwinder while the axes stay.
pub(in crate::machines::ribbon_line) struct KnobPosition {
    /// The position, %.
    percent: f64,
    /// Speed of the unwinder there, r/min.
    speed: f64,
    /// Slack rate there, mm/min.
    slack_rate: f64,
}

/// The worse extreme position of such a knob; none if the axes follow it, or if nothing turns.
pub(in crate::machines::ribbon_line) fn worst_knob(line: &RibbonLine) -> Option<KnobPosition> {
    let RibbonLine { params: p, derived: d, .. } = line;
    if !p.knob_turns_alone() || d.unwinder.actual <= 0.0 {
        return None;
    }
    let at = |percent: f64| {
        let speed = p.speed_at(percent);
        let slack_rate = p.beyond_trim(d.feeds.k * (speed - d.unwinder.actual), d.feeds.k * speed);
        KnobPosition { percent, speed, slack_rate }
    };
    // A knob at 0 stops the unwinder alone; its ladder raises every other position below the lowest.
    let lowest = if line.dialect.spindle().knob.low > 0.0 { line.lowest_position() } else { 0.0 };
    let (high, low) = (at(line.highest_position()), at(lowest));
    Some(if low.slack_rate.abs() > high.slack_rate.abs() { low } else { high })
}

/// Fails a knob that the axes do not follow; the remedies are to lock it, or to let the axes follow the measured speed.
pub(in crate::machines::ribbon_line) fn slack_rate_knob(line: &RibbonLine) -> Option<Judgement> {
    let limit = Within(DRIFT);
    let Some(knob) = worst_knob(line).filter(|knob| knob.slack_rate.abs() > DRIFT) else {
        return ok(limit);
    };
    let turns =
        msg!("ribbon.knob-alone", percent = (knob.percent, 0), speed = (knob.speed, 1), rate = (knob.slack_rate, 0));
    let lock = [("knob-use", "locked")];
    let mut advice = vec![Advice::from(turns).setting(msg!("advice.lock-knob"), lock)];
    if line.control.can(Code::FeedPerRevolution) {
        let follow = msg!("ribbon.follow-measured", feed = (line.derived.feeds.per_revolution, 3));
        let set = [("feed-form", "per-revolution")];
        advice.push(if line.params.spindle_encoder {
            Advice::from(follow).setting(msg!("advice.per-revolution"), set)
        } else {
            follow.into()
        });
    }
    fail(limit, advice)
}

/// Whether a dancer trims away what a knob changes that turns the unwinder alone.
pub(in crate::machines::ribbon_line) fn trims_the_knob(line: &RibbonLine) -> bool {
    worst_knob(line).is_some() && line.params.loop_trim() > 0.0
}

/// Ribbon (mm) missing in the loop while such a knob is at its lowest position: the dancer stands that far below its end.
pub(in crate::machines::ribbon_line) fn missing_at_low_knob(line: &RibbonLine) -> f64 {
    if !trims_the_knob(line) {
        return 0.0;
    }
    (-regulated_loop::standing(&line.params, &line.derived, &line.slow) - set_point(line)).max(0.0)
}

/// Judges the ribbon that is missing while a knob at its lowest position slows the unwinder alone, against the stretch at which the tension
/// switch opens.
pub(in crate::machines::ribbon_line) fn low_knob_starves(line: &RibbonLine) -> Option<Judgement> {
    let (missing, limit) = (missing_at_low_knob(line), AtMost(TensionSwitch::new(line).missing));
    if limit.holds(missing) {
        return ok(limit);
    }
    let percent = (line.lowest_position(), 0);
    let advice = Advice::from(msg!("ribbon.low-knob-starves", percent, missing = (up_to_tenth(missing), 1)));
    fail(limit, [advice.setting(msg!("advice.lock-knob"), [("knob-use", "locked")])])
}

/// Judges the tension of a tight ribbon over the range of the knob against that at which the switch holds the program: by the draw while the
/// line runs, and by the ribbon that is missing after a start.
pub(in crate::machines::ribbon_line) fn stiff_web(line: &RibbonLine) -> Option<Judgement> {
    let p = &line.params;
    let most = TensionSwitch::new(line).tension;
    // The tension of a draw adds to that which the ribbon has anyway.
    let limit = AtMost(if is_drawn_taut(line) { most - p.web.tension_before } else { most });
    let (drawn, started) = (line.worst(|d| d.tension.draw), line.worst(|d| d.tension.start));
    let mut advice = Vec::new();
    if started.tension.start > most {
        let (dwell, percent) = (matching_dwell(line, p), (started.unwinder.effective_override, 1));
        let message = msg!(
            "ribbon.start-stretches",
            percent,
            missing = (started.slack.missing, 1),
            span = (p.web.span, 0),
            tension = (started.tension.start, 0),
            limit = (most, 0)
        );
        let button = msg!("advice.set-dwell", time = dwell.text.as_str());
        advice.push(Advice::from(message).setting(button, [dwell]));
    }
    let taut = drawn.tension.with_draw(p);
    if drawn.tension.draw > 0.0 && taut > most {
        let message = msg!("ribbon.stiff-web", tension = (taut, 0), limit = (most, 0));
        advice.push(with_dancer(line, message));
    }
    if advice.is_empty() { ok(limit) } else { fail(limit, advice) }
}

/// Whether there is a draw that pulls the ribbon tauter than a start that misses ribbon.
pub(in crate::machines::ribbon_line) fn is_drawn_taut(line: &RibbonLine) -> bool {
    let (drawn, started) = (&line.worst(|d| d.tension.draw).tension, &line.worst(|d| d.tension.start).tension);
    drawn.draw > 0.0 && drawn.with_draw(&line.params) > started.start
}

/// Tension (N) of a tight ribbon with the knob at its worst: what a draw adds, or the tension after a start that misses ribbon.
pub(in crate::machines::ribbon_line) fn tight(line: &RibbonLine) -> f64 {
    if is_drawn_taut(line) {
        line.worst(|d| d.tension.draw).tension.draw
    } else {
        line.worst(|d| d.tension.start).tension.start
    }
}

/// An advice against a taut ribbon: a dancer if the draw pulls more, else the dwell with which no start misses ribbon.
pub(in crate::machines::ribbon_line) fn advice_against_taut(line: &RibbonLine, message: Message) -> Advice {
    if is_drawn_taut(line) {
        return with_dancer(line, message);
    }
    with_dwell(line, message)
}

/// Warns about more than 100 stops per minute. The result, the remaining share of the speed, has no limit.
pub(in crate::machines::ribbon_line) fn start_stop(line: &RibbonLine) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, .. } = line;
    if p.path_mode != PathMode::ExactStop || d.timing.stops_per_minute <= 100.0 {
        return None;
    }
    let advice = Advice::from(msg!(
        "ribbon.start-stop",
        stops = (d.timing.stops_per_minute, 0),
        percent = (d.timing.exact_stop_speed, 0)
    ));
    warn(None, [advice.setting(msg!("advice.continuous"), [("path-mode", "continuous")])])
}
