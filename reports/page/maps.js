// Maps around witnesses, where `axiscert map` left them in the run's folder.

// Text written by another command, whatever its shape.
function cell_words(value) {
  if (value === null || value === undefined) return '';
  if (Array.isArray(value)) return value.map(cell_words).join(', ');
  if (typeof value === 'object') return Object.entries(value).map(([key, some]) => `${key}: ${cell_words(some)}`).join('; ');
  return typeof value === 'number' ? amount(value) : String(value);
}

// The classes of pixels that a picture has, with their numbers.
function map_legend(legend, counts) {
  const present = legend.filter((entry) => counts === null || counts[entry.class] > 0);
  return el('ul', 'map-legend', ...present.map((entry) => {
    const swatch = el('span', 'swatch');
    // Only a hexadecimal colour becomes a style.
    if (/^#[0-9a-f]{6}$/i.test(cell_words(entry.colour))) swatch.style.background = entry.colour;
    return el('li', '', swatch, ` ${cell_words(entry.meaning)}`,
              counts === null ? null : el('span', 'zero', ` ${cell_words(counts[entry.class])}`));
  }));
}

function side_words(side, kind) {
  const step = side?.step ?? 1;
  return `${cell_words(side?.numbers)}, ${kind === 'exponents' ? `a factor of 2${step === 1 ? '' : `^${step}`}` : step === 1 ? 'one ulp' : `${step} ulps`} a pixel`;
}

function picture_figure(legend, map, picture) {
  const link = el('a', 'name', picture.file);
  link.href = picture.file.split('/').map(encodeURIComponent).join('/');
  const image = picture.image === null
    ? el('p', 'empty', `Left out of this file for its size, ${count(picture.bytes)} bytes; it is a file next to this one.`) : el('img');
  if (picture.image !== null) {
    image.src = picture.image;
    image.alt = `${cell_words(picture.name)} of ${cell_words(map.kernel)} around ${cell_words(map.witness?.id ?? map.name)}: ` +
      legend.filter((entry) => picture.counts?.[entry.class] > 0)
        .map((entry) => `${cell_words(picture.counts[entry.class])} pixels ${cell_words(entry.class)}`).join(', ');
  }
  return el('div', 'map-picture', image, el('div', '', el('p', '', el('strong', '', cell_words(picture.name)), ' ', link),
                                            map_legend(legend, picture.counts)));
}

function map_figure(data, legend, map) {
  const place = el('div');
  // Pictures in which the kernel is wrong come first; among those, the verdict.
  const wrong = (picture) => (picture.counts?.false_separation ?? 0) + (picture.counts?.missed_separation ?? 0);
  const pictures = [...map.pictures].sort((x, y) => (wrong(y) > 0) - (wrong(x) > 0));
  const show = (index) => place.replaceChildren(picture_figure(legend, map, pictures[index]));
  const id = map.witness?.id;
  const figure = el('figure', 'map', el('figcaption', '', el('strong', '', cell_words(map.name)),
    `: ${cell_words(map.kernel)}, ${cell_words(map.precision)}; to the right ${side_words(map.along, map.kind)}, upwards ${side_words(map.across, map.kind)}`,
    id === undefined ? '' : '; around witness ', id === undefined ? '' : witness_link(data, id)));
  if (pictures.length > 0) {
    figure.append(el('div', 'controls', choice('Picture', pictures.map((picture) =>
      `${cell_words(picture.name)}${wrong(picture) > 0 ? `: ${count(wrong(picture))} wrong` : ''}`), show)), place);
    show(0);
  }
  if (map.command !== null) figure.append(command(cell_words(map.command)));
  return figure;
}

function show_maps(data) {
  const place = document.getElementById('maps-list');
  const {maps} = data.attached;
  if (maps === null || maps.maps.length === 0) return leave_out(place);
  place.append(el('p', 'lead', 'A plane through the space of queries around a witness, one ulp for each pixel: where signs are wrong, the ' +
    'exact boundary, and the band in which a filter is uncertain.'), ...maps.maps.map((map) => map_figure(data, maps.legend, map)));
}
