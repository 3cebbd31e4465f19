// The shelf of projects: one database of this browser, bundled beside the page and loaded when a project is first kept. A state is a project
// or, with the id of its project in `of`, a version of one. Content of the database is untrusted: it is converted to the expected types before it leaves this file.
import { openDB } from 'idb';
import { strFromU8, strToU8, unzipSync, zipSync } from 'fflate';

const STATES = 'states';
// Version of the states that are written.
const VERSION = 1;
// Most files of an archive that are read, and most bytes of one: a project as large as the page opens it (`MAX_BYTES` of project/saved).
const FILES = 10_000;
const BYTES = 16 << 20;
// Bytes of a project's name in the name of its file.
const NAME = 76;

let opened;
function base() {
  opened ??= openDB('macroline', 1, {
    upgrade: (db) => db.createObjectStore(STATES, { keyPath: 'id' }),
    // Another tab has a newer page, which waits for this one.
    blocking(_, __, event) {
      event.target.close();
      opened = undefined;
    },
    terminated: () => (opened = undefined),
  }).catch((error) => {
    opened = undefined;
    throw error;
  });
  return opened;
}

async function change(act) {
  const transaction = (await base()).transaction(STATES, 'readwrite');
  // All or nothing: a failure undoes the whole transaction.
  const acted = act(transaction.store).catch((error) => {
    try {
      transaction.abort();
    } catch {
      // The database has done so itself.
    }
    throw error;
  });
  // `transaction.done` rejects for every refused request.
  const [result] = await Promise.all([acted, transaction.done]);
  return result;
}

// Errors that the page knows by their names, as it knows those of the browser (`shelf::reason`).
const fault = (name) => Object.assign(new Error(name), { name });

const text = (value) => (typeof value === 'string' ? value : '');
const number = (value) => (Number.isFinite(value) ? value : 0);
const state = (row) => ({ id: text(row.id), of: text(row.of), at: number(row.at), version: number(row.version), note: text(row.note), text: text(row.text) });

export const all = async () => (await (await base()).getAll(STATES)).map(state).filter(({ id }) => id);

// Writes a state over the one with its id; with `known`, only if there is one. A state of a newer build is left alone.
export const put = (row, known) =>
  change(async (store) => {
    const before = await store.get(row.id);
    if (before?.version > VERSION) throw fault('VersionError');
    if (before || !known) await store.put({ ...row, version: VERSION });
  });

// Removes a state, and the versions of a project; returns what `restore` brings back.
export const remove = (id) =>
  change(async (store) => {
    const rows = (await store.getAll()).filter((row) => row.id === id || row.of === id);
    for (const row of rows) await store.delete(row.id);
    return rows;
  });

export const restore = (rows) =>
  change(async (store) => {
    for (const row of rows) await store.put(row);
  });

// All states as an archive: each as a file that the page opens, and a list of their other data.
export async function pack() {
  const states = await all();
  const name = (project) => {
    // As it is written in JSON; letters and digits of any script stay, so many bytes of them.
    let words = /"name": "(.*)"/.exec(project.slice(0, 400))?.[1] ?? '';
    words = words.replace(/\\u[0-9a-f]{4}|\\./gi, '-').toLowerCase().replace(/[^\p{L}\p{M}\p{N}]+/gu, '-').replace(/^-/, '');
    const letters = [...words].slice(0, NAME);
    while (strToU8(letters.join('')).length > NAME) letters.pop();
    return letters.join('').replace(/-$/, '') || 'project';
  };
  const listed = states.map((row, at) => ({ ...row, file: `${at + 1}-${name(row.text)}.json` }));
  const files = listed.map((row) => [row.file, strToU8(row.text)]);
  const list = listed.map(({ text: _, ...row }) => row);
  return zipSync(Object.fromEntries([['shelf.json', strToU8(JSON.stringify({ version: VERSION, states: list }, null, 2))], ...files]), { level: 9 });
}

// The files of an archive and its list; files that are too large are not read.
function archived(bytes) {
  let count = 0;
  try {
    const files = unzipSync(bytes, { filter: ({ name, originalSize }) => name.endsWith('.json') && originalSize <= BYTES && ++count <= FILES });
    const { version, states } = JSON.parse(strFromU8(files['shelf.json']));
    if (Array.isArray(states) && Number.isInteger(version)) return { files, version, states };
  } catch {
    // No ZIP, or none of ours.
  }
  throw fault('NoArchive');
}

// Adds the states of an archive that are missing: one whose id has another text here gets a new id. Returns the count.
export async function unpack(bytes) {
  const { files, version, states } = archived(bytes);
  if (version > VERSION) throw fault('VersionError');
  // Projects before their versions.
  const entries = states.filter((row) => row && typeof row === 'object').sort((a, b) => Boolean(a.of) - Boolean(b.of));
  if (!entries.every(({ file }) => Object.hasOwn(files, file))) throw fault('Incomplete');
  const rows = entries.map((entry) => ({ ...state(entry), version: VERSION, text: strFromU8(files[entry.file]) }));
  return change(async (store) => {
    const known = new Map((await store.getAll()).map((row) => [row.id, row]));
    const renamed = new Map();
    let added = 0;
    for (const row of rows) {
      if (!row.id || !row.text || known.get(row.id)?.text === row.text) continue;
      if (known.has(row.id)) {
        const id = `${row.id}${Math.random().toString(36).slice(2, 8)}`;
        renamed.set(row.id, id);
        row.id = id;
      }
      row.of = renamed.get(row.of) ?? row.of;
      known.set(row.id, row);
      await store.put(row);
      added += 1;
    }
    return added;
  });
}
