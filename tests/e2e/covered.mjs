// Gives the page `inked`: the box of a text without the spacing of its line, which differs between browsers, and its size on the screen in px.
export const measureInk = (page) =>
  page.evaluate(() => {
    window.inked = (text) => {
      const { left, top, right, bottom } = text.getBoundingClientRect();
      const matrix = text.getScreenCTM?.();
      const size = parseFloat(getComputedStyle(text).fontSize) * (matrix ? Math.hypot(matrix.a, matrix.b) : 1);
      const [middle, half] = [0.5 * (top + bottom), Math.min(0.45 * size, 0.5 * (bottom - top))];
      return { left, top: middle - half, right, bottom: middle + half, size };
    };
  });

// Labels of the drawing that overlap one another, a lens of another label, or elements over the drawing; figures of the chart over its
// title.
export async function covered(page) {
  await measureInk(page);
  return page.evaluate(() => {
    const area = (element) => element.getBoundingClientRect();
    const overlap = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
    const texts = [...document.querySelectorAll('.stage text[data-label]')].filter((text) => text.textContent && text.checkVisibility({ visibilityProperty: true }));
    const labels = texts.map((text) => ({ words: text.textContent, label: text.dataset.label, area: inked(text) }));
    const lenses = [...document.querySelectorAll('.stage circle[data-label]')].map((rim) => {
      const { left, top, right, bottom } = area(rim);
      const part = 0.15 * (right - left);
      return { words: 'lens', label: rim.dataset.label, area: { left: left + part, top: top + part, right: right - part, bottom: bottom - part } };
    });
    const over = [...document.querySelectorAll('.drawing .mode, .band .icon, .alarm-screen:not(.open)')].map((one) => ({ words: one.textContent, label: '', area: area(one) }));
    const faults = [];
    labels.forEach((one, at) => {
      const others = [...labels.slice(at + 1), ...lenses.filter(({ label }) => label !== one.label), ...over];
      others.filter((other) => overlap(one.area, other.area)).forEach((other) => faults.push(`“${one.words}” and “${other.words}”`));
    });
    const title = inked(document.querySelector('.chart figcaption'));
    for (const tick of document.querySelectorAll('.plot .tick')) if (overlap(inked(tick), title)) faults.push(`“${tick.textContent}” of the chart`);
    return faults;
  });
}
