// Runs in the page: finds every text whose contrast with its background is below WCAG 2.1 AA, 4.5, or 3 for large text;
// each pair of colours once. Text in pictures, which has no HTML colours, is left to the eye.
export function contrast_faults() {
  const parse = (text) => {
    const numbers = text.match(/[0-9.]+/g)?.map(Number) ?? [0, 0, 0, 0];
    return [...numbers.slice(0, 3), numbers[3] ?? 1];
  };
  const over = (top, below) => [0, 1, 2].map((i) => top[i] * top[3] + below[i] * (1 - top[3])).concat(1);
  const luminance = (colour) => [0.2126, 0.7152, 0.0722].reduce((sum, weight, i) => {
    const c = colour[i] / 255;
    return sum + weight * (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  }, 0);
  const background = (node) => {
    const layers = [];
    for (let at = node; at; at = at.parentElement) {
      const colour = parse(getComputedStyle(at).backgroundColor);
      if (colour[3] > 0) layers.push(colour);
      if (colour[3] === 1) break;
    }
    return layers.reduceRight((below, top) => over(top, below), [255, 255, 255, 1]);
  };
  const faults = new Map();
  let seen = 0;
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode.parentElement;
    if (walker.currentNode.textContent.trim() === '' || node.closest('svg, script, noscript, .skip') || node.offsetParent === null) continue;
    ++seen;
    const style = getComputedStyle(node);
    const below = background(node);
    const [x, y] = [luminance(over(parse(style.color), below)), luminance(below)];
    const ratio = (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
    const size = Number.parseFloat(style.fontSize);
    const is_large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (ratio < (is_large ? 3 : 4.5)) faults.set(`${style.color} on ${below}`, `${ratio.toFixed(2)}: ${node.outerHTML.slice(0, 100)}`);
  }
  if (seen < 200) faults.set('few', `only ${seen} texts were found to look at`);
  return [...faults].map(([pair, where]) => `${pair}: ${where}`);
}
