// Files as one zip archive, bundled beside the page and loaded only when somebody takes all of them.
import { strToU8, zipSync } from 'fflate';

// `files` are pairs of name and text.
export const zip = (files) => zipSync(Object.fromEntries(files.map(([name, text]) => [name, strToU8(text)])), { level: 9 });
