// Where errors come from: broken links by family; the cost of each form of the predicate; flips against precision.

function origins_table(data, entry) {
  const rows = Object.entries(entry.families).map(([family, result]) => ({family, result}));
  const wrong = ({result}) => result.verdict.false_separation + result.verdict.false_contact;
  const most = Math.max(1, ...rows.map(wrong));
  return table(`Broken links of wrong verdicts, ${entry_name(entry)}`, [
    column.text('family', (row) => row.family, {cell: (th, value) => th.append(el('span', 'name', value))}),
    column.count('wrong verdicts', wrong, {alarm: 'bad'}),
    column.text('share of each link', wrong, {numeric: true, left: true, cell: (td, value, row) => {
      const bar = links_bar(row.result.verdict.links);
      td.classList.add('wide');
      // The length is logarithmic: one wrong verdict gives a twentieth, the largest number of any family the whole.
      if (bar) {
        bar.style.width = `${5 + 95 * Math.log1p(value) / Math.log1p(most)}%`;
        td.append(bar);
      }
    }}),
    column.text('links', wrong, {numeric: true, left: true,
                                 cell: (td, value, row) => td.append(link_chips(row.result.verdict.links))}),
    column.text('breaks that cancelled', (row) => links_total(row.result.verdict.masked_links),
                {numeric: true, left: true, cell: (td, value, row) => td.append(link_chips(row.result.verdict.masked_links))}),
  ], rows, grouped(data, rows));
}

function plot(canvas, datasets, x, y) {
  Chart.getChart(canvas)?.destroy();
  const {text} = chart_colours();
  return new Chart(canvas, {
    type: 'scatter', data: {datasets}, plugins: [point_labels],
    options: {
      animation: false, maintainAspectRatio: false, scales: {x: chart_scale(...x), y: chart_scale(...y)},
      plugins: {legend: {labels: {color: text, usePointStyle: true}},
                tooltip: {callbacks: {label: ({raw}) => `${raw.label}: ${amount(raw.x, 4)}, ${amount(raw.y, 4)}`}}},
    },
  });
}

// Writes the label of each point next to it where its dataset is `labelled` and the label covers no other: on paper
// there is no hovering, and the table has all labels.
const point_labels = {
  id: 'point_labels',
  afterDatasetsDraw(chart) {
    chart.ctx.save();
    chart.ctx.fillStyle = chart_colours().text;
    chart.ctx.font = '12px system-ui, sans-serif';
    const taken = [];
    chart.data.datasets.forEach((dataset, i) => {
      if (!dataset.labelled) return;
      chart.getDatasetMeta(i).data.forEach(({x, y}, k) => {
        const {label} = dataset.data[k];
        const width = chart.ctx.measureText(label).width;
        const left = x + 10 + width > chart.chartArea.right ? x - 10 - width : x + 10;
        if (taken.some((other) => Math.abs(other.y - y) < 13 && left < other.right && other.left < left + width)) return;
        taken.push({y, left, right: left + width});
        chart.ctx.fillText(label, left, y - 8);
      });
    });
    chart.ctx.restore();
  },
};

// A canvas in a box, drawn again whenever the colour scheme changes.
function plot_box(label, draw) {
  const canvas = el('canvas');
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', label);
  const redraw = () => draw(canvas);
  dark_scheme.addEventListener('change', redraw);
  return {box: el('div', 'plot', canvas), redraw};
}

// The points that no other point beats in both.
function front_of(points) {
  return points.filter((p) => !points.some((q) => q !== p && q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y)));
}

const ladder_measures = [
  ['sign errors per million', (figures, family) => 1e6 * (figures.false_separation + figures.missed_separation) / family.queries],
  ['error that 99 % stay below, u', (figures) => figures.p99_u],
  ['worst error, u', (figures) => figures.worst_u],
];

function ladder_points(ladder, family, axis, of) {
  return ladder.kernels.flatMap((kernel) => {
    const time = ladder.speed?.kernels?.[kernel.id]?.scalar;
    const asked = kernel.families?.[family];
    const value = asked?.axes?.[axis] ? of(asked.axes[axis], asked) : null;
    if (!time || typeof value !== 'number') return [];
    return [{x: time, y: Math.max(value, 1e-3), value, label: kernel.id}];
  });
}

function show_ladder(data) {
  const place = document.getElementById('ladder');
  const {ladder} = data.attached;
  if (ladder === null || !ladder.speed) return leave_out(place);
  const families = [...new Set(ladder.kernels.flatMap((kernel) => Object.keys(kernel.families ?? {})))];
  const axes = [...new Set(ladder.kernels.flatMap((kernel) => Object.values(kernel.families ?? {})
    .flatMap((family) => Object.keys(family.axes ?? {}))))];
  let family = families[0];
  let axis = axes[0];
  let measure = ladder_measures[0];
  const figures = el('div');
  const {box, redraw} = plot_box('Accuracy against speed of each form', (canvas) => {
    const points = ladder_points(ladder, family, axis, measure[1]);
    const front = front_of(points);
    const {series} = chart_colours();
    const dataset = (label, some, colour, style, is_front) => ({label, data: some, borderColor: colour, backgroundColor: colour,
      pointStyle: style, pointRadius: 7, showLine: is_front, borderWidth: 2, labelled: true});
    plot(canvas, [dataset('front: none is both faster and better', [...front].sort((p, q) => p.x - q.x), series[0], 'circle', true),
                  dataset('others', points.filter((p) => !front.includes(p)), series[1], 'rectRot', false)],
         ['ns a query, scalar', false], [`${measure[0]}, ${axis}, ${family} (0 is drawn at 0.001)`, true]);
    figures.replaceChildren(table(`${family}, ${axis}: ${measure[0]}`, [
      column.text('kernel', (row) => row.label, {cell: (th, value) => th.append(el('span', 'name', value))}),
      column.amount('ns a query', (row) => row.x, {digits: 3}), column.amount(measure[0], (row) => row.value, {digits: 4}),
      column.text('front', (row) => (front.includes(row) ? 'yes' : '')),
    ], points));
  });
  place.append(el('div', 'controls', choice('Family', families, (index) => { family = families[index]; redraw(); }),
                  choice('Axis', axes, (index) => { axis = axes[index]; redraw(); }),
                  choice('Accuracy', ladder_measures.map(([label]) => label), (index) => { measure = ladder_measures[index]; redraw(); })),
               el('p', 'lead', `${count(ladder.trials)} queries a family, ${ladder.precision}. Down and to the left is better.`),
               box, el('details', '', el('summary', 'label', 'The figures'), figures));
  redraw();
}

function show_precision(data) {
  const place = document.getElementById('precision');
  const {precision} = data.attached;
  if (precision === null) return leave_out(place);
  const ids = Object.keys(precision.kernels);
  let limited = 1;
  const {box, redraw} = plot_box('Wrong verdicts against precision', (canvas) => {
    const {series} = chart_colours();
    plot(canvas, ids.map((id, i) => ({
      label: id, showLine: true, borderWidth: 2, pointRadius: 3, pointStyle: chart_marks[i % chart_marks.length],
      borderColor: series[i % series.length], backgroundColor: series[i % series.length],
      borderDash: i < series.length ? [] : [6, 4],
      data: precision.kernels[id].map((row) => ({x: row[0], y: Math.max(row[limited], 0.5), label: id})),
    })), ['bits of the significand', true, null, Math.min(...ids.flatMap((id) => precision.kernels[id].map(([bits]) => bits)))],
      ['wrong verdicts (0 is drawn at 0.5)', true]);
  });
  place.append(el('div', 'controls', toggle('Exponents', ['unlimited', 'of the format'], (index) => { limited = index + 1; redraw(); })),
               el('p', 'lead', `${count(precision.queries)} queries of ${precision.precision}, evaluated with more and with fewer bits.`), box);
  redraw();
}

function show_origins(data) {
  const shown = data.kernels.filter((entry) => entry.all !== null);
  if (shown.length > 0) {
    const place = document.getElementById('links-table');
    const show = (index) => {
      const entry = shown[index];
      const has_other_links = Object.entries(entry.all.verdict.links ?? {}).some(([link, n]) => link !== 'unattributed' && n > 0);
      // Where no link says why, a table of links would say `unattributed` in every row.
      if (entry.classes === null) place.replaceChildren(origins_table(data, entry));
      else place.replaceChildren(classes_box(data, entry), ...(has_other_links ? [origins_table(data, entry)] : []));
    };
    document.getElementById('links-controls').append(choice('Kernel', shown.map(entry_name), show));
    show(0);
  }
  show_ladder(data);
  show_precision(data);
}
