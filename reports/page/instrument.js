// Draws an instrument's plots and scenes.
function drawPlots() {
  const {text, series: colours} = chart_colours();
  const scale = (axis) => chart_scale(axis.label, axis.log, axis.names);
  const dataset = (series, i, kind) => ({
    label: series.name,
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
