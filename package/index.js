// macroline for programs: sizes special CNC machines, writes their macro programs and runs programs in a virtual control.
//
// Every function answers with a plain object. What cannot be done is an answer with `error`, a sentence, and `diagnostics`; nothing is thrown once
// `init` has resolved.
import load, * as core from './core.js';

let loading;
let isLoaded = false;

// Loads the module, once. Without `source` it is the file beside this one; else whatever `fetch` takes, a Response, bytes, or a WebAssembly.Module.
export function init(source) {
  loading ??= open(source).catch((fault) => {
    loading = undefined;
    throw fault;
  });
  return loading;
}

async function open(source) {
  let from = source ?? new URL('./core_bg.wasm', import.meta.url);
  if (from instanceof URL && from.protocol === 'file:') {
    // Node, where nothing fetches files. The name is no literal, so that bundlers for browsers leave it alone.
    const files = 'node:fs/promises';
    from = await (await import(/* @vite-ignore */ /* webpackIgnore: true */ files)).readFile(from);
  }
  await load({ module_or_path: from });
  isLoaded = true;
}

function ready() {
  if (!isLoaded) throw new Error('macroline: await init() before the first call');
}

const DEFAULT_LANGUAGE = 'en';

// Anything as the code of a language: what is none is refused by its name.
const code = (language) => (language === undefined ? DEFAULT_LANGUAGE : typeof language === 'string' ? language.slice(0, 20) : typeof language);

const refused = (language, why, text = '') => JSON.parse(core.refusal(code(language), why, text));

// An argument as JSON; undefined where JSON does not have it.
function json(value) {
  try {
    return JSON.stringify(value);
  } catch {
    return undefined;
  }
}

// Hands a request over, written by `write`, and gives its answer.
function asked(language, request, act) {
  ready();
  const text = json(request);
  if (text === undefined) return refused(language, 'unreadable');
  if (text.length > core.most()) return refused(language, 'too-large');
  try {
    return act(code(language), text);
  } catch (fault) {
    return refused(language, 'broken', String(fault));
  }
}

const ask = (name, language, request) => asked(language, request, (code, text) => JSON.parse(core.answer(code, name, text)));

// Options of a call without the language; what is no object comes through as it is, and is refused by its shape.
function split(options = {}) {
  if (options === null || typeof options !== 'object' || Array.isArray(options)) return [undefined, { options }];
  try {
    const { language, ...rest } = options;
    return [language, rest];
  } catch {
    return [undefined, { options: null }];
  }
}

// The same with the choices of a check or a run in one object.
function chosen(options) {
  const [language, { switches, silence, ...rest }] = split(options);
  return [language, { choices: { switches, silence }, ...rest }];
}

// A missing argument is null, which JSON keeps and the core refuses.
const given = (value) => value ?? null;

export function list(options) {
  const [language, rest] = split(options);
  return ask('list', language, rest);
}

export function newProject(machine, options) {
  const [language, rest] = split(options);
  return ask('new', language, { ...rest, machine: given(machine) });
}

export function design(project, options) {
  const [language, rest] = split(options);
  return ask('design', language, { ...rest, project: given(project) });
}

export function size(project, options) {
  const [language, rest] = split(options);
  return ask('size', language, { ...rest, project: given(project) });
}

function exportFiles(project, options) {
  const [language, rest] = split(options);
  return ask('export', language, { ...rest, project: given(project) });
}

export { exportFiles, exportFiles as export };

export function check(subject, options) {
  const [language, rest] = chosen(options);
  return ask('check', language, { ...rest, subject: given(subject) });
}

export function run(subject, options) {
  const [language, rest] = chosen(options);
  return ask('run', language, { ...rest, subject: given(subject) });
}

export function interpret(subject, options) {
  const [language, rest] = chosen(options);
  return ask('interpret', language, { ...rest, subject: given(subject) });
}

export function step(subject, options) {
  const [language, rest] = chosen(options);
  return asked(language, { ...rest, subject: given(subject) }, (code, text) => {
    const session = new core.Session(code, text);
    const first = JSON.parse(session.first());
    if (!('error' in first)) return new Session(session, first, language);
    session.free();
    return first;
  });
}

// A session of the debugger. It holds memory of the module until it is freed.
class Session {
  #session;
  #language;

  constructor(session, first, language) {
    this.#session = session;
    this.#language = language;
    this.first = first;
  }

  #ask(command) {
    if (!this.#session) return refused(this.#language, 'freed');
    return asked(this.#language, command, (_, text) => JSON.parse(this.#session.answer(text)));
  }

  into() {
    return this.#ask('into');
  }

  over() {
    return this.#ask('over');
  }

  out() {
    return this.#ask('out');
  }

  to(place) {
    return this.#ask({ to: given(place) });
  }

  continue() {
    return this.#ask('continue');
  }

  back() {
    return this.#ask('back');
  }

  start() {
    return this.#ask('start');
  }

  reset() {
    return this.#ask('reset');
  }

  breakAt(place, condition) {
    return this.#ask({ break: { place: given(place), condition } });
  }

  clear(number) {
    return this.#ask({ clear: given(number) });
  }

  breakpoints() {
    return this.#ask('breakpoints');
  }

  watch(expression) {
    return this.#ask({ watch: given(expression) });
  }

  unwatch(number) {
    return this.#ask({ unwatch: given(number) });
  }

  evaluate(expression) {
    return this.#ask({ evaluate: given(expression) });
  }

  variables() {
    return this.#ask('variables');
  }

  set(name, value) {
    return this.#ask({ set: { name: given(name), value: given(value) } });
  }

  free() {
    this.#session?.free();
    this.#session = undefined;
  }
}
