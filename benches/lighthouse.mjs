// Scores of Lighthouse for a page that is served, in a browser that listens at a port: `await scores(url, port)`.
import lighthouse, { desktopConfig } from 'lighthouse';

// Runs of each form; the one in the middle by performance counts.
const RUNS = 3;

// Resolves to [{ what, score, asked, short }]: `short` are the ids of audits that cost points.
export async function scores(url, port) {
  const forms = [
    ['mobile', undefined, { performance: 95, accessibility: 100, 'best-practices': 100 }],
    ['desktop', desktopConfig, { performance: 100, accessibility: 100, 'best-practices': 100 }],
  ];
  const rows = [];
  for (const [form, config, asked] of forms) {
    const runs = [];
    while (runs.length < RUNS) {
      const { lhr } = await lighthouse(url, { port, logLevel: 'error', onlyCategories: Object.keys(asked) }, config);
      if (lhr.runtimeError) throw new Error(`Lighthouse, ${form}: ${lhr.runtimeError.message}`);
      runs.push(lhr);
    }
    const lhr = runs.sort((a, b) => a.categories.performance.score - b.categories.performance.score)[RUNS >> 1];
    for (const [id, least] of Object.entries(asked)) {
      const { score, auditRefs } = lhr.categories[id];
      const short = auditRefs.map((ref) => ({ ...lhr.audits[ref.id], weight: ref.weight })).filter((audit) => audit.weight > 0 && audit.score !== null && audit.score < 1);
      rows.push({
        what: `Lighthouse, ${form}, ${id}`,
        score: Math.round(100 * score),
        asked: least,
        short: short.map((audit) => `${audit.id} ${audit.displayValue ?? ''} (${audit.score})`),
      });
    }
  }
  return rows;
}
