// Errors on a logarithmic scale: what this run saw, what a search attained, what is proved.

// The position of an error on a scale of powers of ten, in per cent.
function log_scale(errors) {
  const magnitudes = errors.filter((error) => error !== null && error !== 0).map(magnitude);
  const low = Math.floor(Math.min(0, ...magnitudes));
  const high = Math.max(low + 3, Math.ceil(Math.max(...magnitudes, 1)));
  // A few overflowed sides reach 10^600: the scale ends at 10^20, where no digit of a sign is left, and a bar that
  // extends beyond shows it.
  const end = Math.min(high, 20);
  const at = (error) => Math.min(100, Math.max(0, 100 * (magnitude(error) - low) / (end - low)));
  return {low, end, at, beyond: (error) => magnitude(error) > end};
}

function log_ticks({low, end}) {
  const step = Math.ceil((end - low) / 6);
  const ticks = el('div', 'ticks');
  for (let exponent = low; exponent <= end; exponent += step) {
    const tick = el('span', '', exponent === 0 ? '1' : '10', exponent === 0 ? null : el('sup', '', String(exponent)));
    tick.style.left = `${100 * (exponent - low) / (end - low)}%`;
    ticks.append(tick);
  }
  return ticks;
}

// A bar from `attained` to `proved`; open on the right where nothing is proved.
function log_bar(scale, attained, proved) {
  const bar = el('div', 'logbar');
  bar.setAttribute('aria-hidden', 'true');
  if (attained === null || attained === 0) return bar;
  const part = (className, left, width) => {
    const node = el('span', className);
    node.style.left = `${left}%`;
    node.style.width = `${Math.max(width, 0.4)}%`;
    bar.append(node);
  };
  part('attained', 0, scale.at(attained));
  if (proved !== null) part('slack', scale.at(attained), scale.at(proved) - scale.at(attained));
  if (scale.beyond(attained)) bar.append(el('span', 'beyond', '▸'));
  return bar;
}

function error_cell(error) {
  if (error === null) return el('td', 'n', el('span', 'zero', 'none'));
  const td = el('td', 'n', typeof error === 'number' ? amount(error, 6) : error);
  td.title = String(error);
  return td;
}

function ratio_text(attained, proved) {
  if (attained === null || proved === null || attained === 0) return 'open';
  const ratio = 10 ** (magnitude(proved) - magnitude(attained));
  return `× ${amount(ratio, 3)}`;
}

function bounds_table(data, entry) {
  const rows = Object.keys(entry.all.comparisons).map((name) => ({name, ...bound_of(data, entry, name)}));
  const observed = log_scale(rows.map((row) => row.observed));
  const hunted = log_scale(rows.flatMap((row) => [row.attained, row.proved]));
  const has_hunt = rows.some((row) => row.attained !== null || row.proved !== null);
  const head = el('tr', '', el('th', '', 'comparison'), el('th', '', 'evidence'), el('th', 'n', 'observed here, u'),
                  el('th', 'wide', 'relative to |lhs| + |rhs|', log_ticks(observed)));
  if (has_hunt) {
    head.append(el('th', 'n', 'attained, u'), el('th', 'n', 'proved, u'), el('th', 'n', 'ratio'),
                el('th', 'wide', 'attained to proved, coordinates and r at most 1', log_ticks(hunted)));
  }
  const body = el('tbody', '', ...rows.map((row) => {
    const th = el('th', '', el('span', 'name', row.name));
    th.scope = 'row';
    const tr = el('tr', '', th, el('td', '', badge_chip(row.badge)), error_cell(row.observed),
                  el('td', 'wide', log_bar(observed, row.observed, null)));
    if (has_hunt) {
      tr.append(error_cell(row.attained), error_cell(row.proved), el('td', 'n', ratio_text(row.attained, row.proved)),
                el('td', 'wide', log_bar(hunted, row.attained, row.proved)));
    }
    return tr;
  }));
  const caption = `Errors of ${entry_name(entry)}`;
  return scroll_table(caption, 'bounds', el('thead', '', head), body);
}

// A part that the folder does not hold takes no room here: the last section names it. Removes a place with its heading.
function leave_out(place) {
  if (place.previousElementSibling?.tagName === 'H3') place.previousElementSibling.remove();
  place.remove();
}

function show_bounds(data) {
  const place = document.getElementById('bounds-table');
  const shown = data.kernels.filter((entry) => entry.all !== null && entry.all.comparisons !== null);
  const silent = data.kernels.filter((entry) => entry.all !== null && entry.all.comparisons === null && entry.classes !== null);
  if (silent.length > 0) {
    document.getElementById('bounds').append(
      el('p', 'lead', `${silent.map(entry_name).join('; ')}: no sides are shown. How deep the wrong verdicts are instead:`),
      ...silent.map((entry) => class_depths(data, entry)));
  }
  if (shown.length === 0) {
    if (silent.length === 0) place.append(el('p', 'empty', 'No kernel here exposes comparisons.'));
    return;
  }
  const show = (index) => place.replaceChildren(bounds_table(data, shown[index]));
  document.getElementById('bounds-controls').append(choice('Kernel', shown.map(entry_name), show));
  show(0);
}
