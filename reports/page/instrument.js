// Draws an instrument's plots with Chart.js, in the page's own colours.
'use strict';

const schemeColours = {
  // Eight that stay apart for colour-blind readers, at 3:1 or more on the panel; and a second round dashed.
  light: ['#0a58b0', '#b3540e', '#14632d', '#a8201a', '#6d3fb0', '#00707a', '#8a6d00', '#7a3b62'],
  dark: ['#7fb6f8', '#f5a860', '#77d394', '#ff9a91', '#c3a3f5', '#5fd0d8', '#e6c94f', '#eaa0cc'],
};

function drawPlots() {
  const css = getComputedStyle(document.documentElement);
  const text = css.getPropertyValue('--text').trim(), line = css.getPropertyValue('--line').trim();
  const dark = window.matchMedia('(prefers-color-scheme: dark)').matches;
  const colours = schemeColours[dark ? 'dark' : 'light'];
  const marks = ['circle', 'rectRot', 'triangle', 'rect', 'cross', 'star'];

  // Powers of ten alone where there are many.
  function logarithmicTick(...given) {
    if (Math.log10(this.max / this.min) < 4) return Chart.Ticks.formatters.logarithmic.apply(this, given);
    const exponent = Math.log10(given[0]);
    if (Math.abs(exponent - Math.round(exponent)) > 1e-9) return '';
    return given[0] < 1e-3 || given[0] >= 1e5 ? `1e${Math.round(exponent)}` : String(given[0]);
  }

  const scale = (axis) => ({
    type: axis.log ? 'logarithmic' : 'linear',
    title: { display: true, text: axis.label, color: text },
    ticks: axis.names && axis.names.length > 0
      ? { color: text, stepSize: 1, autoSkip: false, maxRotation: 60, callback: (value) => axis.names[value] || '' }
      : axis.log ? { color: text, maxRotation: 0, callback: logarithmicTick } : { color: text },
    grid: { color: line },
  });
  const dataset = (series, i, kind) => ({
    label: series.name,
    data: series.points.map(([x, y], k) => ({ x, y, label: series.labels[k] || series.name })),
    borderColor: colours[i % colours.length],
    backgroundColor: colours[i % colours.length],
    borderDash: i < colours.length ? [] : [6, 4],
    borderWidth: 2,
    pointStyle: marks[i % marks.length],
    pointRadius: kind === 'scatter' ? 6 : 3,
    showLine: kind === 'line',
  });

  const plots = JSON.parse(document.getElementById('plots').textContent);
  document.querySelectorAll('.plot canvas').forEach((canvas, i) => {
    const shown = Chart.getChart(canvas);
    if (shown) shown.destroy();
    const plot = plots[i];
    new Chart(canvas, {
      type: 'scatter',
      data: { datasets: plot.series.map((series, k) => dataset(series, k, plot.kind)) },
      options: {
        animation: false,
        maintainAspectRatio: false,
        scales: { x: scale(plot.x), y: scale(plot.y) },
        plugins: {
          legend: { labels: { color: text, usePointStyle: true } },
          tooltip: { callbacks: { label: (item) => `${item.raw.label}: ${item.raw.x}, ${item.raw.y}` } },
        },
      },
    });
  });
}

drawPlots();
window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawPlots);
