// Labels of the drawing that overlap one another, a lens of another label, or elements over the drawing; figures of the chart over its
// title.
export const covered = (page) =>
  page.evaluate(() => {
    const area = (element, free = 0) => {
      const { left, top, right, bottom, height } = element.getBoundingClientRect();
      return { left, top: top + free * height, right, bottom: bottom - free * height };
    };
    const overlap = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
    const texts = [...document.querySelectorAll('.stage text[data-label]')].filter((text) => text.textContent && text.checkVisibility({ visibilityProperty: true }));
    const labels = texts.map((text) => ({ words: text.textContent, label: text.dataset.label, area: area(text, 0.12) }));
    const lenses = [...document.querySelectorAll('.stage circle[data-label]')].map((rim) => {
      const { left, top, right, bottom } = area(rim);
      const part = 0.15 * (right - left);
      return { words: 'lens', label: rim.dataset.label, area: { left: left + part, top: top + part, right: right - part, bottom: bottom - part } };
    });
    const over = [...document.querySelectorAll('.drawing .mode, .band .icon')].map((one) => ({ words: one.textContent, label: '', area: area(one) }));
    const faults = [];
    labels.forEach((one, at) => {
      const others = [...labels.slice(at + 1), ...lenses.filter(({ label }) => label !== one.label), ...over];
      others.filter((other) => overlap(one.area, other.area)).forEach((other) => faults.push(`“${one.words}” and “${other.words}”`));
    });
    const title = area(document.querySelector('.chart figcaption'), 0.12);
    for (const tick of document.querySelectorAll('.plot .tick')) if (overlap(area(tick, 0.12), title)) faults.push(`“${tick.textContent}” of the chart`);
    return faults;
  });
