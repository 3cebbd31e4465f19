// Places of the page's text count the carriage returns at the ends of its lines; the editor has one character between two lines.

// How many of the rising numbers are below a limit.
function below(numbers, limit) {
  let [from, to] = [0, numbers.length];
  while (from < to) {
    const half = (from + to) >> 1;
    if (numbers[half] < limit) from = half + 1;
    else to = half;
  }
  return from;
}

export const withoutReturns = (text) => text.replace(/\r\n?/g, '\n');

// The ways between places of a text of the page and those of the editor.
export function waysOf(text) {
  const returns = [];
  for (let at = text.indexOf('\r\n'); at >= 0; at = text.indexOf('\r\n', at + 2)) returns.push(at);
  const here = returns.map((at, count) => at - count);
  return { toEditor: (at) => at - below(returns, at), toPage: (at) => at + below(here, at) };
}
