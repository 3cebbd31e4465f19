// Files as one zip archive, bundled beside the page and loaded only when all files are saved at once.
import { zipSync } from 'fflate';

// `files` are pairs of name and bytes.
export const zip = (files) => zipSync(Object.fromEntries(files), { level: 9 });
