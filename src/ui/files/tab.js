// Shows a document of our own in a tab that the page has opened, and prints it. The content security policy of the page holds in that tab
// and allows no <style> element; it allows a sheet that a script constructs.
export function print(tab, html) {
  tab.document.write('<!doctype html>');
  tab.document.close();
  const sheets = [];
  // Removed before parsing: the policy would report each <style> element.
  const plain = html.replace(/<style>([^<]*)<\/style>/g, (_, rules) => {
    const sheet = new tab.CSSStyleSheet();
    sheet.replaceSync(rules);
    sheets.push(sheet);
    return '';
  });
  const read = new tab.DOMParser().parseFromString(plain, 'text/html');
  tab.document.replaceChild(tab.document.adoptNode(read.documentElement), tab.document.documentElement);
  tab.document.adoptedStyleSheets = sheets;
  // The print dialog stops both tabs: the report is painted before.
  tab.requestAnimationFrame(() => tab.setTimeout(() => tab.print()));
}
