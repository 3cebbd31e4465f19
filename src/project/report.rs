//! The report of a project: the parts of machine and control, a run of the programs, and their checksums.

use super::Project;
use super::export::ExportOptions;
use super::files::checksum::crc32;
use super::files::encode;
use super::program::Written;
use super::repairs::repairs;
use super::run::{RunOptions, finish, of_project, program_number};
use super::size::{Cycle, Sizing, seconds_of_a_further_part};
use crate::controls::ParamRole;
use crate::controls::schema::syntax::Percent;
use crate::machines::report::report;
use crate::machines::{Frame, PreparedMachine};
use crate::motion::{Budget, Retention, RunEnd};
use crate::msg;
use crate::nc::File;
use crate::text::Message;
use crate::text::catalog::words;
use crate::text::lines::line_end;
use crate::text::listed;
use crate::view::balloons::balloons;
use crate::view::report::{Figure, PrintedProgram, Report, RunReport, SizingReport};
use crate::view::{Chart, Theme, svg};

/// Budget of a report's run: blocks, and seconds of machine time. A longer run is drawn as far as it came.
const LIMITS: Budget = Budget { blocks: 200_000, seconds: 8.0 * 3600.0 };

/// Points of a chart.
const POINTS: usize = 400;

/// Fraction of the run (0 to 1) at which the machine is drawn, moved to the nearest work.
const SHOWN: f64 = 0.6;

/// The middle of the work nearest to a time, of these spans (s); the time itself without any.
fn at_work(spans: &[(f64, f64)], time: f64) -> f64 {
    let middles = spans.iter().map(|(begin, end)| 0.5 * (begin + end));
    middles.min_by(|a, b| (a - time).abs().total_cmp(&(b - time).abs())).unwrap_or(time)
}

fn sizing_report(sizing: &Sizing) -> SizingReport {
    SizingReport { tables: sizing.offer(), exceeded: sizing.findings() }
}

impl Project {
    /// The report about these programs of the project.
    pub fn report(&self, prepared: &PreparedMachine, written: &Written, options: &ExportOptions) -> Report {
        let values = (&self.values, &self.provenance);
        let report = report(self.machine, prepared, &self.name, values, self.control_context(), options.advice);
        let files = &written.files.0;
        let program = |file: &File| PrintedProgram {
            name: file.name.clone(),
            text: file.text.clone(),
            checksum: checksum(&encode::bytes(&file.text, self.characters())),
        };
        Report {
            block: self.title_block.clone(),
            customer: self.customer().unwrap_or_default().to_owned(),
            date: options.date.to_owned(),
            checksum: checksum(self.to_json().as_bytes()),
            run: self.run_report(prepared, written),
            programs: files.iter().map(program).collect(),
            loading: self.loading(written),
            repairs: repairs(self),
            sizing: options.sizing.map(sizing_report).unwrap_or_default(),
            variants: self.compared_variants(words("variants.offer")),
            ..report
        }
    }

    /// The machine in a run of the programs.
    fn run_report(&self, prepared: &PreparedMachine, written: &Written) -> RunReport {
        let options = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
        let mut run = of_project(self, written, &options);
        let ended = finish(&mut run);
        let end = run.timeline().end();
        let drawn_at = at_work(&prepared.working(&run, end).unwrap_or_default(), SHOWN * end);
        let now = run.timeline().at(drawn_at);
        let pose = prepared.pose(&run, &now, Frame { step: 0.0, drawing_option: false });
        let scene = prepared.scene();
        let time = run.ended_at().filter(|time| ended == RunEnd::ProgramEnd && *time > 0.0);
        let cycle = time.map(|seconds| Cycle {
            seconds,
            further: seconds_of_a_further_part(prepared, &run).unwrap_or(seconds),
            pause: prepared.pause(),
            between_parts: prepared.time_between_parts(),
            energy: None,
        });
        let figures = cycle.map(|cycle| {
            let figure = |label, value, unit| Figure { label, value, unit, decimals: 1 };
            let time = figure("form.report.cycle-time", cycle.seconds, "s");
            let mean = figure("form.report.mean-time", cycle.mean(), "s");
            let parts = figure("form.report.parts-per-hour", cycle.parts_per_hour(), "1/h");
            let mean = Some(mean).filter(|mean| mean.value != time.value);
            [Some(time), mean, Some(parts)].into_iter().flatten()
        });
        RunReport {
            drawn_at,
            drawing: svg::picture_with(&scene, &pose, Theme::Line, &balloons(&scene, &pose, &prepared.parts())),
            figures: figures.into_iter().flatten().collect(),
            charts: prepared.charts(&run, 0.0, end, POINTS).into_iter().map(Chart::shown).collect(),
        }
    }

    /// How the programs get into the control.
    fn loading(&self, written: &Written) -> Vec<Message> {
        let files = &written.files.0;
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        let ends = files.first().map_or("\n", |file| line_end(&file.text));
        let percent = match self.control.syntax.percent {
            Percent::Both => msg!("form.report.percent-both"),
            Percent::End => msg!("form.report.percent-end"),
            Percent::Head => msg!("form.report.percent-head"),
        };
        let can_lock = self.control.param(ParamRole::EditLock).is_some();
        let locked = |name: &&str| {
            program_number(name, &self.control.syntax).is_some_and(|number| (9000..=9999).contains(&number))
        };
        let locked = (can_lock && names.iter().any(locked)).then(|| msg!("form.report.locked"));
        let first = [msg!("form.report.load", files = listed(names))].into_iter().chain(locked);
        let line_ends = msg!("form.report.line-ends", ends = if ends == "\n" { "LF" } else { "CR LF" });
        first.chain([percent, line_ends, msg!("form.report.transfer")]).collect()
    }
}

/// Checksum of an exported file: CRC-32 of its bytes.
fn checksum(bytes: &[u8]) -> String {
    format!("{:08X}", crc32(bytes))
}
