// How far from zero the exact margins were: a histogram for each comparison, with the band in which errors reach them.

const margin_digits = {binary32: 24, binary64: 53};  // no margin exceeds its scale: 1/u

// Bins from `tie`, at the left, by powers of two up to the precision's; those below the least of every histogram are
// left out.
function margin_bins(rows, precision) {
  const exponents = rows.flatMap((row) => [...Object.keys(row.margins.right), ...Object.keys(row.margins.wrong)])
    .filter((key) => key !== 'tie').map(Number);
  const least = Math.min(0, ...exponents);
  return ['tie', ...Array.from({length: margin_digits[precision] - least}, (_, i) => String(least + i))];
}

function sum(counts) { return Object.values(counts).reduce((x, y) => x + y, 0); }

// The largest error that this run saw in the comparison, in u; null where the kernel shows no sides.
function margin_band(entry, row) { return entry.exposes.includes('sides') ? row.max_error_u : null; }

// The number of wrong signs whose margin is certainly above the band: a side was not finite, or there was none.
function beyond_band(row, band) {
  if (band === null) return 0;
  const reach = band === 0 ? -Infinity : magnitude(band) / Math.log10(2);
  return Object.entries(row.margins.wrong).filter(([key]) => key !== 'tie' && Number(key) >= reach).reduce((n, [, k]) => n + k, 0);
}

function margin_words(row, band) {
  const {right, wrong} = row.margins;
  const measured = sum(right) + sum(wrong);
  if (measured === 0) return 'none measured';
  const beyond = beyond_band(row, band);
  return `${count(measured)} measured, ${count(sum(wrong))} wrong` + (beyond > 0 ? `, ${count(beyond)} of them beyond the band` : '') +
    (band === null ? '; shows no sides' : `; largest error ${error_amount(band)} u`);
}

// Heights are logarithmic, so that one query is visible next to thousands.
function margin_histogram(entry, row, bins, most) {
  const band = margin_band(entry, row);
  const plot = el('div', 'histogram');
  plot.setAttribute('role', 'img');
  plot.setAttribute('aria-label', `Margins of ${row.name}: ${margin_words(row, band)}`);
  if (band !== null) {
    const shade = el('span', 'band');
    const bins_reached = band === 0 ? 1 : 1 + magnitude(band) / Math.log10(2) - Number(bins[1]);
    shade.style.width = `${100 * Math.min(1, Math.max(1, bins_reached) / bins.length)}%`;
    plot.append(shade);
  }
  const height = (n) => `${100 * Math.log1p(n) / Math.log1p(most)}%`;
  for (const key of bins) {
    const right = row.margins.right[key] ?? 0;
    const wrong = row.margins.wrong[key] ?? 0;
    const bar = el('span', 'bin');
    if (right + wrong > 0) {
      bar.title = `${key === 'tie' ? 'ties' : `2^${key} to 2^${Number(key) + 1} u`}: ${count(right)} right, ${count(wrong)} wrong`;
      const both = el('span', 'right');
      both.style.height = height(right + wrong);
      if (wrong > 0) {
        const part = el('span', 'wrong');
        part.style.height = `${Math.max(15, 100 * wrong / (right + wrong))}%`;
        both.append(part);
      }
      bar.append(both);
    }
    plot.append(bar);
  }
  const ticks = el('div', 'ticks');
  bins.forEach((key, i) => {
    // Next to the tie's label there is no room for another.
    if (key !== 'tie' && (i < 4 || Number(key) % (bins.length > 40 ? 16 : 8) !== 0)) return;
    const tick = el('span', '', ...(key === 'tie' ? ['0'] : ['2', el('sup', '', key)]));
    tick.style.left = `${100 * (key === 'tie' ? 0.5 : i) / bins.length}%`;
    ticks.append(tick);
  });
  return el('figure', 'margin', el('figcaption', '', el('span', 'name', row.name), ` ${margin_words(row, band)}`), plot, ticks);
}

// A row for each power of two: how many, and below how many of these have the wrong sign.
function margin_tables(rows, bins) {
  const range = (key) => (key === 'tie' ? 'tie' : `2^${key} u`);
  const used = bins.filter((key) => rows.some((row) => (row.margins.right[key] ?? 0) + (row.margins.wrong[key] ?? 0) > 0));
  const parts = parts_of(rows, 16);
  return el('details', '', el('summary', '', 'The figures'), ...parts.map((part) =>
    table('Margins above each power of two: all, and below of these wrong', [
      column.text('margin', range),
      ...part.map((row) => column.text(row.name.replace('.', '. '), (key) => (row.margins.right[key] ?? 0) + (row.margins.wrong[key] ?? 0), {numeric: true, cell: (td, value, key) => {
        const wrong = row.margins.wrong[key] ?? 0;
        td.append(short_count(value));
        td.title = `${count(value)}, ${count(wrong)} wrong`;
        if (value === 0) td.classList.add('zero');
        if (wrong > 0) td.append(el('small', 'wrong-count', short_count(wrong)));
      }}))], used)));
}

function has_margin({margins}) { return sum(margins.right) + sum(margins.wrong) > 0; }

function has_margins(entry) {
  return entry.all !== null && entry.all.comparisons !== null && Object.values(entry.all.comparisons).some(has_margin);
}

function show_margins(data) {
  const place = document.getElementById('margins');
  const shown = data.kernels.filter(has_margins);
  if (shown.length === 0) {
    place.append(el('p', 'empty', 'Not counted: no kernel here shows its comparisons, or no margin was measured.'));
    return;
  }
  const controls = document.getElementById('margins-controls');
  let entry = shown[0];
  const draw = (result) => {
    const rows = Object.entries(result.comparisons).map(([name, tally]) => ({name, ...tally}));
    const bins = margin_bins(rows, entry.precision);
    const most = Math.max(1, ...rows.flatMap((row) => bins.map((key) => (row.margins.right[key] ?? 0) + (row.margins.wrong[key] ?? 0))));
    place.replaceChildren(el('div', 'margins', ...rows.map((row) => margin_histogram(entry, row, bins, most))), margin_tables(rows, bins));
  };
  const families = () => choice('Family', ['all families', ...Object.keys(entry.families)], (index) =>
    draw(index === 0 ? entry.all : Object.values(entry.families)[index - 1]));
  const kernels = choice('Kernel', shown.map(entry_name), (index) => {
    entry = shown[index];
    controls.replaceChildren(kernels, families());
    draw(entry.all);
  });
  document.getElementById('margins-lead').append(
    `Counted over the first ${count(data.plan.margin_queries)} queries of each family.`);
  controls.append(kernels, families());
  draw(entry.all);
}
