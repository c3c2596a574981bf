'use strict';
// Chart.js in the page's own colours.

const scheme_colours = {
  // Eight that stay distinct for colour-blind readers, at 3:1 or more on the panel; a second round is dashed.
  light: ['#0a58b0', '#b3540e', '#14632d', '#a8201a', '#6d3fb0', '#00707a', '#8a6d00', '#7a3b62'],
  dark: ['#7fb6f8', '#f5a860', '#77d394', '#ff9a91', '#c3a3f5', '#5fd0d8', '#e6c94f', '#eaa0cc'],
};
const chart_marks = ['circle', 'rectRot', 'triangle', 'rect', 'cross', 'star'];
const dark_scheme = window.matchMedia('screen and (prefers-color-scheme: dark)');

function chart_colours() {
  const css = getComputedStyle(document.documentElement);
  return {text: css.getPropertyValue('--text').trim(), line: css.getPropertyValue('--line').trim(),
          series: scheme_colours[dark_scheme.matches ? 'dark' : 'light']};
}

// Labels only powers of ten where there are many.
function logarithmic_tick(...given) {
  if (Math.log10(this.max / this.min) < 4) return Chart.Ticks.formatters.logarithmic.apply(this, given);
  const exponent = Math.log10(given[0]);
  if (Math.abs(exponent - Math.round(exponent)) > 1e-9) return '';
  return given[0] < 1e-3 || given[0] >= 1e5 ? `1e${Math.round(exponent)}` : String(given[0]);
}

// One axis of a plot, starting at `min` where it is given; `names` are the labels of the whole numbers from 0.
function chart_scale(label, log, names, min) {
  const {text, line} = chart_colours();
  return {
    type: log ? 'logarithmic' : 'linear',
    min,
    title: {display: true, text: label, color: text},
    ticks: names?.length > 0
      ? {color: text, stepSize: 1, autoSkip: false, maxRotation: 60, callback: (value) => names[value] || ''}
      : log ? {color: text, maxRotation: 0, callback: logarithmic_tick} : {color: text},
    grid: {color: line},
  };
}
