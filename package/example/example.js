// The example page of the package: results of a machine, and a program that runs.
import * as macroline from '../index.js';

/**
 * The element with an id.
 * @template {HTMLElement} T
 * @param {string} id
 * @param {new () => T} kind
 * @returns {T}
 */
function element(id, kind) {
  const found = document.getElementById(id);
  if (found instanceof kind) return found;
  throw new Error(`there is no ${kind.name} ${id}`);
}

const machine = element('machine', HTMLSelectElement);
const control = element('control', HTMLSelectElement);
const language = element('language', HTMLSelectElement);
const program = element('program', HTMLTextAreaElement);

/**
 * The result of an answer; an error where it is none.
 * @template {object} T
 * @param {macroline.Answer<T>} answer
 * @returns {T}
 */
function result(answer) {
  if ('error' in answer) throw new Error(answer.error);
  return answer;
}

/** The language option of every call. */
const spoken = () => ({ language: /** @type {macroline.Language} */ (language.value) });

/**
 * Fills a choice, and keeps what was chosen where it is still there.
 * @param {HTMLSelectElement} select
 * @param {{ id: string, name: string }[]} rows
 */
function offer(select, rows) {
  const chosen = select.value;
  select.replaceChildren(...rows.map(({ id, name }) => new Option(name, id, false, id === chosen)));
}

function offerChoices() {
  const { machines, controls } = result(macroline.list(spoken()));
  offer(machine, machines);
  const goesWith = machines.find(({ id }) => id === machine.value)?.controls ?? [];
  offer(control, controls.filter(({ id }) => goesWith.includes(id)));
}

function showDesign() {
  const project = result(macroline.newProject(machine.value, { control: control.value, ...spoken() }));
  const { readouts } = result(macroline.design(project, spoken()));
  const number = (/** @type {number | null} */ value) => value?.toLocaleString(language.value, { maximumSignificantDigits: 5 }) ?? '';
  const rows = readouts.map(({ id, value, unit, limit, verdict }) => {
    const row = document.createElement('tr');
    row.dataset['verdict'] = verdict;
    const head = document.createElement('th');
    head.scope = 'row';
    head.textContent = id;
    row.append(head);
    for (const text of [`${number(value)} ${unit}`, number(limit), verdict === 'none' ? '' : verdict]) row.insertCell().textContent = text;
    return row;
  });
  element('results', HTMLTableSectionElement).replaceChildren(...rows);
}

function runProgram() {
  const programs = { control: control.value, files: [{ name: 'program.nc', text: program.value }] };
  const ran = macroline.run(programs, { continue: true, seconds: 600, ...spoken() });
  const found = ran.diagnostics.map(({ alarm, id, line, message }) => `line ${line ?? '-'}: [${alarm ?? id}] ${message}`);
  const end = 'error' in ran ? [ran.error] : [...(ran.canon ?? []), `${ran.ended}, ${ran.time_s.toFixed(3)} s`];
  element('log', HTMLPreElement).textContent = [...end, ...found].join('\n');
}

await macroline.init();
program.value = 'O1\nG90 G94\nG00 X0.\n#100=1\nWHILE[#100 LE 3]DO1\nG01 X[#100*10.] F6000.\n#100=#100+1\nEND1\nM30';
offerChoices();
showDesign();
for (const choice of [machine, control, language]) {
  choice.addEventListener('change', () => {
    offerChoices();
    showDesign();
  });
}
element('run', HTMLButtonElement).addEventListener('click', runProgram);
