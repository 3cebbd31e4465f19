// The sentences of a language by their ids, from its catalog: `const say = words('zh'); say('page.new')`.
import { readFileSync } from 'node:fs';

export function words(code) {
  const file = readFileSync(new URL(`../../src/text/catalog/${code}.properties`, import.meta.url), 'utf8');
  const rows = new Map(file.split('\n').map((row) => [row.slice(0, row.indexOf('=')), row.slice(row.indexOf('=') + 1)]));
  return (id) => {
    if (!rows.has(id)) throw new Error(`no sentence ${id}`);
    return rows.get(id);
  };
}
