// The types of macroline's package. A test holds them true against what every function really gives.

/** A language of sentences. */
export type Language = 'en' | 'zh';

/** Something that cannot be done, as a sentence; the diagnostics of files that have errors are with it. */
export interface Refusal {
  error: string;
  diagnostics: Diagnostic[];
}

/** What a function answers: its result, or why there is none. `'error' in answer` tells which. */
export type Answer<T> = T | Refusal;

export interface LanguageOption {
  /** Without it English. */
  language?: Language;
}

/** A finding about a file, a field of the form or a run. What does not apply is null. */
export interface Diagnostic {
  /** An error keeps a program from being exported. */
  severity: 'error' | 'warning' | 'info';
  /** The control's alarm number, and its wording there. */
  alarm: string | null;
  wording: string | null;
  /** What `silence` takes. */
  id: string;
  message: string;
  file: string | null;
  /** Line and column from 1, columns in characters. */
  line: number | null;
  column: number | null;
  /** Id of the field of the form. */
  field: string | null;
  hints: string[];
  fixes: Fix[];
}

/** A way to mend a finding, by itself. */
export interface Fix {
  title: string;
  edits: Edit[];
}

/** Replaces the bytes of a file (UTF-8) from `start` to `end`. */
export interface Edit {
  file: string;
  start: number;
  end: number;
  text: string;
}

export interface File {
  name: string;
  text: string;
}

/** A project, as its file has it. The ids of values are those of `design`. */
export interface Project {
  version: number;
  name: string;
  machine: string;
  control: string;
  values: Record<string, number | boolean | string>;
  provenance?: Record<string, string>;
  switches?: Record<string, string>;
  /** Code of the language of comments, where the control can show it. */
  comments?: string;
  silenced?: string[];
  panel?: PanelEvent[];
  edited?: File[];
  title_block?: Record<string, string>;
  parts?: Record<string, unknown>[];
  variants?: Record<string, unknown>[];
}

/** Something that the operator does at `t` seconds: `{ t: 2.5, spindle_override: 80 }`. */
export interface PanelEvent {
  t: number;
  spindle_override?: number;
  feed_override?: number;
  rapid_override?: number;
  start?: boolean;
  hold?: boolean;
  reset?: boolean;
  estop?: boolean;
  inverter_fault?: boolean;
  program_zero?: boolean;
  single_block?: boolean;
  optional_stop?: boolean;
  block_skip?: boolean;
  manual_s?: number;
  lower_speed_limit?: number;
  upper_speed_limit?: number;
  surface_speed_limit?: number;
  input?: Record<string, number>;
  variable?: Record<string, number | null>;
}

/** A project, or the text of its file. */
export type GivenProject = Project | string;

/** Bare programs for a control. */
export interface Programs {
  /** Id of the control. */
  control: string;
  files: File[];
}

/** What is checked, run or stepped through. */
export type Subject = GivenProject | Programs;

/** What `init` loads the module from; see there. */
export type InitSource = string | URL | Request | Response | Promise<Response> | BufferSource | WebAssembly.Module;

/** Loads the module, once; await it before the first call. Without `source` it is the file beside this one, in Node and in browsers. */
export function init(source?: InitSource): Promise<void>;

export interface Listing {
  machines: Machine[];
  controls: Control[];
}

export interface Machine {
  id: string;
  name: string;
  /** Ids of the controls that it goes with. */
  controls: string[];
  examples: Example[];
}

export interface Example {
  id: string;
  name: string;
  about: string;
  /** Results that fail in it. */
  fails: string[];
}

export interface Control {
  id: string;
  name: string;
  bench: Bench;
  switches: Switch[];
}

/** The plant that bare programs run on. */
export interface Bench {
  axes: { axis: string; rotary: boolean; rapid: number; clamp: number; time_constant_s: number; position_gain: number }[];
  speed_at_full: number;
  gears: number[];
  speed_clamp: number;
  volts: number;
  output_bits: number;
  ramp_s: number;
}

/** An open point of a control: `{ switches: { [id]: option } }` settles it. */
export interface Switch {
  id: string;
  text: string;
  default: string;
  options: { id: string; label: string }[];
}

/** Machines with their examples, controls with their switches. */
export function list(options?: LanguageOption): Answer<Listing>;

export interface NewOptions extends LanguageOption {
  /** Without it the machine's first. */
  control?: string;
  /** Without it the machine's first, in which no verdict fails. */
  example?: string;
}

/** An example of a machine as a project. */
export function newProject(machine: string, options?: NewOptions): Answer<Project>;

export type Verdict = 'ok' | 'warn' | 'fail' | 'none';

/** How a value stands to its limit; `within` where the limit is for its size of either sign. */
export type Bound = 'most' | 'least' | 'equal' | 'within';

export interface Readout {
  id: string;
  value: number | null;
  unit: string;
  limit: number | null;
  bound: Bound | null;
  verdict: Verdict;
  formula: string;
  advice: string[];
}

export interface Entry {
  /** Id of the field. */
  id: string;
  value: string;
  unit: string;
  origin: 'entered' | 'default' | 'example' | 'assumed' | 'measured' | 'data sheet';
}

export interface Assumption {
  /** Id of a fact that is only assumed. */
  field: string;
  /** The verdict that a tenth more or less of it flips. */
  flips: { readout: string; factor: number; from: Verdict; to: Verdict } | null;
}

export interface Repairs {
  /** Each with its entries by the id of their field, in the order in which they are taken. */
  changes: { change: string; sets: Record<string, string> }[];
  /** Number of results that fail with all changes too. */
  still_failing: number;
  /** Number of errors of the form that stay: the export is refused. */
  errors: number;
  /** Ids of the results that are to be checked with all changes, and were not before. */
  new_warnings: string[];
}

export interface Design {
  readouts: Readout[];
  /** Changes with which the failing results hold. */
  repairs: Repairs;
  values: Entry[];
  assumed: Assumption[];
  /** Assumed facts whose change flips a verdict, those that lead to a failure first. */
  measure_first: string[];
  /** The example whose values the project has. */
  example: string | null;
  /** Why verdicts of that example fail. */
  faults: { readout: string; reason: string }[];
  diagnostics: Diagnostic[];
}

/** Results with limits and verdicts, and where each value comes from. */
export function design(project: GivenProject, options?: LanguageOption): Answer<Design>;

export interface SizeOptions extends LanguageOption {
  /** So many machines are drawn with their assumed facts within a tenth. */
  draws?: number;
  seed?: number;
}

/** Whether a part is still made. */
export type PartStatus = 'current' | 'phased out' | 'spare part' | 'unknown';

/** A motor for an axis. Loads are in percent. */
export interface Candidate {
  maker: string;
  model: string;
  passes: boolean;
  reason: string | null;
  effective_load: number | null;
  peak_load: number | null;
  regenerative_load: number | null;
  inertia_ratio: number | null;
  status: PartStatus;
  grade: string;
  /** Mean power for an external brake resistor, W; null where none is needed, or nothing is known of the amplifier. */
  resistor_w: number | null;
  /** The smallest that takes it; null where there is none. */
  resistor: string | null;
  amplifier: string | null;
  /** Values of the form that take it. */
  entries: Record<string, string>;
}

export interface SizedAxis {
  axis: string;
  name: string;
  turning: number;
  loaded: number;
  least: string | null;
  asked: {
    speed_rad_s: number;
    peak_torque_nm: number;
    peak_at_s: number;
    /** Position of the knob in the run with that torque; null where the form has it. */
    peak_at_knob_percent: number | null;
    /** Position of the feed override in that run; null at 100 %. */
    peak_at_feed_percent: number | null;
    effective_torque_nm: number;
    energy_given_j: number;
    energy_returned_j: number;
    current_per_torque_a_nm: number | null;
  } | null;
  /** What to ask a maker for where the catalogue has no motor that passes, or no amplifier for one; null where it has. */
  shortage: string | null;
  candidates: Candidate[];
  /** Its gear unit, with those of the catalogue that have this ratio; null where it has none. */
  gear: {
    ratio: number;
    mean_torque_nm: number;
    peak_torque_nm: number;
    mean_input_rpm: number;
    input_rpm: number;
    /** The next lower and higher ratio, where the catalogue has none of this one. */
    next_ratios: number[];
    candidates: {
      maker: string;
      model: string;
      passes: boolean;
      reason: string | null;
      /** Loads are in percent of the rating; null where that is not known. */
      mean_load: number | null;
      peak_load: number | null;
      mean_speed_load: number | null;
      speed_load: number | null;
      status: PartStatus;
      grade: string;
      entries: Record<string, string>;
    }[];
  } | null;
}

export interface Size {
  axes: SizedAxis[];
  /** Null where the program does not come to its end. */
  cycle: {
    time_s: number;
    /** Time of each further part, whose gear is engaged already. */
    further_s: number;
    /** From its end to the next start. */
    pause_s: number;
    /** Mean of changes of material for a part. */
    change_s: number;
    parts_per_hour: number;
    /** Null where nothing is known of its motors. */
    energy_given_j: number | null;
    energy_returned_j: number | null;
    energy_returned_on_one_bus_j: number | null;
  } | null;
  /** Where and why the run ended before the end of the program; null where it came there. */
  cut: { at_s: number; reason: string } | null;
  envelope: {
    event: string;
    id: string;
    value: number;
    unit: string;
    limit: number | null;
    bound: Bound | null;
    verdict: Verdict;
    worst: boolean;
    /** Position of the knob at which it was met; null where the form has it. */
    knob_percent: number | null;
    /** Position of the feed override at which it was met; null at 100 %. */
    feed_percent: number | null;
    /** The run was cut while something coasted on. */
    more_than_value: boolean;
  }[];
  /** Limits of the form that would hold in operation, where one does not. */
  would_hold: {
    id: string;
    value: number;
    unit: string;
    more_than_value: boolean;
    field: string | null;
    entry: string | null;
  }[];
  limits: {
    quantity: string;
    limit: string | null;
    /** Null, as the value, where none of the tried entries holds. */
    margin: number | null;
    value: number | null;
    unit: string;
    /** From `value` on, more of the entry changes no result. */
    more_is_unused: boolean;
    /** Results that fail now and with less as well. */
    fails_with_less_too: string[];
  }[];
  /** The fastest operation of this hardware. */
  inverse: {
    line_speed: number;
    unit: string;
    result: string;
    binding: string;
    field: string;
    entry: string;
    fails_with_less_too: string[];
  } | null;
  /** Why there is no `inverse`; null where there is one. */
  inverse_reason: string | null;
  sensitivities: { input: string; result: string; factor: number; flips: { from: Verdict; to: Verdict } }[];
  tornado: { result: string; limit_use: number; bars: { input: string; low: number; high: number }[] }[];
  bom: {
    item: string;
    axis: string | null;
    /** Maker and model, or what is known of a part that is to be chosen. */
    part: string;
    maker: string;
    model: string;
    /** What the part has to be or do, where it is not chosen yet. */
    asked: string;
    /** In place of a part that is to be chosen. */
    proposal: boolean;
    quantity: number;
    /** Why the motor that the form names does not carry its axis. */
    refused: string | null;
    /** What is not settled about the part; null where nothing is. */
    open: string | null;
    status: PartStatus;
    grade: string;
    source: string;
  }[];
  /** Wires at terminals (`X2:4`), and ready-made cables (`W3`). Each end is an item of `bom`. */
  terminals: { terminal: string; signal: string; from: string; to: string }[];
  /** Null without `draws`. */
  chance: { draws: number; seed: number; facts: number; probability: number; fails: { result: string; draws: number }[] } | null;
  diagnostics: Diagnostic[];
}

/** Motors that carry the machine, operating envelope, limits, bill of materials. */
export function size(project: GivenProject, options?: SizeOptions): Answer<Size>;

export interface ExportOptions extends LanguageOption {
  /** Date in the title block of the report, as its reader writes dates. */
  date?: string;
}

export interface Export {
  /** Programs, sheets, drawings, report and project; none where a diagnostic is an error. */
  files: File[];
  diagnostics: Diagnostic[];
}

/** The files for the machine. */
export function exportFiles(project: GivenProject, options?: ExportOptions): Answer<Export>;
export { exportFiles as export };

export interface CheckOptions extends LanguageOption {
  /** Settings of open points of the control, by id. */
  switches?: Record<string, string>;
  /** Ids of warnings that are left out. */
  silence?: string[];
}

export interface Check {
  diagnostics: Diagnostic[];
  /** Number of warnings that were left out. */
  silenced: number;
}

/** What the control and a senior programmer say to programs, nothing run. */
export function check(subject: Subject, options?: CheckOptions): Answer<Check>;

export interface StepOptions extends CheckOptions {
  /** Project whose plant runs bare programs, instead of the control's bench. */
  plant?: GivenProject;
  /** Events of the operator. */
  panel?: PanelEvent[];
  /** Program to start, for instance `O9101`. */
  start?: string;
  /** Variables and inputs that are set before the start: `{ '#107': 8 }`. */
  set?: Record<string, number>;
  /** Ends the run after so many blocks; without it 10 million. */
  blocks?: number;
  /** Ends the run after so many seconds of machine time; without it 3600. */
  seconds?: number;
}

export interface RunOptions extends StepOptions {
  /** Answers M00, M01 and messages of the program by cycle start. */
  continue?: boolean;
  /** False leaves the log out. */
  canon?: boolean;
}

export interface Run {
  ended: 'program-end' | 'stop' | 'alarm' | 'blocks' | 'seconds';
  blocks: number;
  time_s: number;
  standstill_s: number;
  /** By the control's names. */
  variables: Record<string, number>;
  /** By axis letter, mm or degrees. */
  axes: Record<string, number>;
  reference_point: Record<string, number> | null;
  spindle: { rpm: number; volts: number; volts_command: number; gear: number; angle_deg: number | null };
  /** Axes that the PLC turns, by name. */
  turned?: Record<string, { rpm: number; angle_deg: number }>;
  /** The log of commands. */
  canon?: string[];
  diagnostics: Diagnostic[];
}

/** Runs a project or programs to the end, over time. */
export function run(subject: Subject, options?: RunOptions): Answer<Run>;

export interface InterpretOptions extends CheckOptions {
  /** Program to start, for instance `O9101`. */
  start?: string;
  /** Variables and inputs: `{ '#1033': 100 }`. */
  set?: Record<string, number>;
  /** Positions of the axes by letter, mm or degrees; 0 without. */
  positions?: Record<string, number>;
  /** Ends after so many blocks; without it 10 million. */
  blocks?: number;
}

export interface Interpretation {
  ended: 'program-end' | 'alarm' | 'blocks';
  blocks: number;
  canon: string[];
  variables: Record<string, number>;
  alarm: Diagnostic | null;
  remarks: Diagnostic[];
  /** Findings of reading. */
  diagnostics: Diagnostic[];
}

/** Executes a program on a machine at rest, without time: what a test of a macro program asks. */
export function interpret(subject: Subject, options?: InterpretOptions): Answer<Interpretation>;

/** A block of a program. */
export interface Block {
  file: string;
  line: number;
  column: number;
  text: string;
}

export interface Level {
  program: number;
  name: string;
  entered: 'start' | 'subprogram' | 'macro';
  /** How often it runs again after this time. */
  again: number;
  block: Block | null;
  /** Local variables that are not vacant. */
  locals: Record<string, number>;
}

/** Where a session has stopped. */
export interface Stop {
  /** `block`: the goal is reached; `condition`: that of a breakpoint has no value here; else how the run ended. */
  stop: 'block' | 'breakpoint' | 'condition' | 'program-end' | 'stop' | 'alarm' | 'blocks' | 'seconds';
  /** Number of the breakpoint. */
  breakpoint: number | null;
  /** Why the condition of the breakpoint has no value. */
  reason: string | null;
  time_s: number;
  /** The next block; after the end the last one. */
  block: Block | null;
  /** The block that the machine executes, for the control reads ahead. */
  executing: Block | null;
  /** The call stack, innermost first. */
  stack: Level[];
  /** What the last step has changed: variables, and modal codes as `G` and `F`. Null is vacant. */
  changes: { name: string; before: number | null; after: number | null }[];
  /** The commands that it gave, the last ones, and the number of those before. */
  canon: string[];
  canon_before: number;
  watches: { number: number; expression: string; value: number | null; reason: string | null }[];
  /** Found since the stop before; the first stop has those of reading too. */
  diagnostics: Diagnostic[];
}

export interface Breakpoint {
  number: number;
  block: Block | null;
  condition: string;
  hits: number;
}

/** Steps through a run. It holds memory until it is freed. Places are `12`, `O9101.nc:12`, `N30`, `O9101 N30` or `O9101`. */
export interface Session {
  /** Before the first block. */
  readonly first: Stop;
  /** To the next block, also inside a called program. */
  into(): Answer<Stop>;
  /** To the next block of this program or of a caller. */
  over(): Answer<Stop>;
  /** To the block after the call of this program. */
  out(): Answer<Stop>;
  /** To a place. */
  to(place: string): Answer<Stop>;
  /** To a breakpoint or the end. */
  continue(): Answer<Stop>;
  /** To the block before. */
  back(): Answer<Stop>;
  /** Presses cycle start, for instance after M00. */
  start(): Answer<Stop>;
  /** Presses reset. */
  reset(): Answer<Stop>;
  breakAt(place: string, condition?: string): Answer<{ number: number }>;
  /** Removes a breakpoint; without a number all. */
  clear(number?: number): Answer<{ removed: boolean }>;
  breakpoints(): Answer<{ breakpoints: Breakpoint[] }>;
  /** Every stop has its value. */
  watch(expression: string): Answer<{ number: number }>;
  /** Removes a watch; without a number all. */
  unwatch(number?: number): Answer<{ removed: boolean }>;
  /** Null is vacant. */
  evaluate(expression: string): Answer<{ value: number | null }>;
  /** Variables that are not vacant. */
  variables(): Answer<{ variables: Record<string, number> }>;
  /** Sets a variable or an input now. */
  set(name: string, value: number): Answer<{ value: number }>;
  free(): void;
}

/** Begins to step through a run, before its first block. */
export function step(subject: Subject, options?: StepOptions): Answer<Session>;
