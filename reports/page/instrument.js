// Draws an instrument's plots and scenes.

// The intervals of points, as vertical bars with ends; cut off where the plot ends.
const error_bars = {
  id: 'error_bars',
  afterDatasetsDraw(chart) {
    const {ctx, chartArea: area, scales: {y}} = chart;
    ctx.save();
    ctx.lineWidth = 1;
    chart.data.datasets.forEach((dataset, k) => {
      if (!chart.isDatasetVisible(k)) return;
      const points = chart.getDatasetMeta(k).data;
      (dataset.intervals || []).forEach((ends, i) => {
        const x = points[i].x;
        const [low, high] = ends.map((end) => {
          const at = y.getPixelForValue(end);
          return Number.isFinite(at) ? Math.min(Math.max(at, area.top), area.bottom) : area.bottom;
        });
        ctx.strokeStyle = dataset.borderColor;
        ctx.beginPath();
        for (const [from, to] of [[[x, low], [x, high]], [[x - 3, low], [x + 3, low]], [[x - 3, high], [x + 3, high]]]) {
          ctx.moveTo(...from);
          ctx.lineTo(...to);
        }
        ctx.stroke();
      });
    });
    ctx.restore();
  },
};

// Limits of an axis that show these intervals whole.
function around(intervals) {
  if (intervals.length === 0) return {};
  return { suggestedMin: Math.min(...intervals.map(([low]) => low)), suggestedMax: Math.max(...intervals.map(([, high]) => high)) };
}

function drawPlots() {
  const {text, series: colours} = chart_colours();
  const scale = (axis) => chart_scale(axis.label, axis.log, axis.names);
  const dataset = (series, i, kind) => ({
    label: series.name,
    intervals: series.intervals,
    data: series.points.map(([x, y], k) => ({ x, y, label: series.labels[k] || series.name })),
    borderColor: colours[i % colours.length],
    backgroundColor: colours[i % colours.length],
    borderDash: i < colours.length ? [] : [6, 4],
    borderWidth: 2,
    pointStyle: chart_marks[i % chart_marks.length],
    pointRadius: kind === 'scatter' ? 6 : 3,
    showLine: kind === 'line',
  });

  const plots = JSON.parse(document.getElementById('plots').textContent);
  document.querySelectorAll('.plot canvas').forEach((canvas, i) => {
    Chart.getChart(canvas)?.destroy();
    const plot = plots[i];
    new Chart(canvas, {
      type: 'scatter',
      plugins: [error_bars],
      data: { datasets: plot.series.map((series, k) => dataset(series, k, plot.kind)) },
      options: {
        animation: false,
        maintainAspectRatio: false,
        scales: { x: scale(plot.x), y: { ...scale(plot.y), ...around(plot.series.flatMap((series) => series.intervals)) } },
        plugins: {
          legend: { labels: { color: text, usePointStyle: true } },
          tooltip: { callbacks: { label: (item) => `${item.raw.label}: ${item.raw.x}, ${item.raw.y}` } },
        },
      },
    });
  });
}

// A picture for each scene, and a button that copies what is to paste.
function drawScenes() {
  const scenes = JSON.parse(document.getElementById('scenes').textContent);
  document.querySelectorAll('.worst .picture').forEach((place, i) => place.append(scene_figure(scenes[i])));
  document.querySelectorAll('.worst .command').forEach((box) => box.append(copy_button(box.textContent)));
}

drawPlots();
drawScenes();
unfold_on_paper('details');
dark_scheme.addEventListener('change', drawPlots);
