// A picture in three dimensions that pointer or arrow keys turn: what the pictures of all predicates share. It is only for the
// eye: binary64, after scaling; the exact facts about the query are stated next to it.

// The double that equals a C hex-float; NaN for text that is not a finite number. The power of two is applied in
// halves: neither overflows or underflows where the result does not.
function parse_hex(text) {
  const parts = /^(-?)0x([0-9a-f]+)(?:[.]([0-9a-f]*))?p([-+]?[0-9]+)$/i.exec(text);
  if (!parts) return NaN;
  const fraction = parts[3] ?? '';
  const exponent = Number(parts[4]) - 4 * fraction.length;
  const half = Math.trunc(exponent / 2);
  const value = Number.parseInt(parts[2] + fraction, 16) * 2 ** half * 2 ** (exponent - half);
  return parts[1] ? -value : value;
}

const vec = {
  add: (u, v) => u.map((x, i) => x + v[i]),
  sub: (u, v) => u.map((x, i) => x - v[i]),
  mul: (u, k) => u.map((x) => x * k),
  dot: (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2],
  cross: (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]],
  size: (u) => Math.hypot(...u),
};

// The point of the triangle nearest to the origin, and the feature on which it lies: `face`, or one or two of the
// vertices.
function closest_point([a, b, c]) {
  const n = vec.cross(vec.sub(b, a), vec.sub(c, a));
  const nn = vec.dot(n, n);
  const inside = (u, v) => vec.dot(vec.cross(u, v), n) > 0;  // the origin's foot is on the inner side of uv
  if (nn > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
    return {point: vec.mul(n, vec.dot(a, n) / nn), feature: 'face', vertices: [0, 1, 2]};
  }
  const edges = [[0, 1, a, b], [1, 2, b, c], [2, 0, c, a]].map(([i, j, u, v]) => {
    const w = vec.sub(v, u);
    const ww = vec.dot(w, w);
    const t = ww > 0 ? Math.min(1, Math.max(0, -vec.dot(u, w) / ww)) : 0;
    return {point: vec.add(u, vec.mul(w, t)), vertices: t === 0 ? [i] : t === 1 ? [j] : [i, j]};
  });
  const nearest = edges.reduce((x, y) => (vec.size(y.point) < vec.size(x.point) ? y : x));
  return {...nearest, feature: nearest.vertices.length === 1 ? 'vertex' : 'edge'};
}

// The numbers of the query's groups, a point or one number each, divided by a power of two that brings the greatest to
// a magnitude of 1: otherwise differences of the largest numbers overflow. `unit(x)` divides another number by it. Null
// where a number is not finite.
function near_one(query, groups) {
  const numbers = groups.map((group) => [query[group]].flat().map(parse_hex));
  const greatest = Math.max(...numbers.flat().map(Math.abs));
  if (!(greatest < Infinity)) return null;
  const exponent = greatest === 0 ? 0 : Math.trunc(Math.log2(greatest));
  const half = Math.trunc(exponent / 2);
  const unit = (x) => x / 2 ** half / 2 ** (exponent - half);
  return {unit, ...Object.fromEntries(groups.map((group, i) => {
    const scaled = numbers[i].map(unit);
    return [group, scaled.length === 1 ? scaled[0] : scaled];
  }))};
}

function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const view_size = 360;
const view_middle = [view_size / 2, view_size / 2];

// Circles of latitude 0 and of two longitudes, to show that a sphere turns.
function great_circles() {
  const circle = (u, v) => Array.from({length: 49}, (_, i) => {
    const t = Math.PI * i / 24;
    return vec.add(vec.mul(u, Math.cos(t)), vec.mul(v, Math.sin(t)));
  });
  return [circle([1, 0, 0], [0, 0, 1]), circle([1, 0, 0], [0, 1, 0]), circle([0, 1, 0], [0, 0, 1])];
}

// Points on the screen of an arc around `centre`, from one angle to a greater one. Of a circle that is far larger than
// the picture, many where it passes the picture and few elsewhere.
function arc([x, y], radius, from, to) {
  const steps = (start, end, n) => Array.from({length: n + 1}, (_, i) => start + (end - start) * i / n);
  const [dx, dy] = [view_middle[0] - x, view_middle[1] - y];
  const width = 2 * view_size / radius;  // in radians: what is in the picture is within half of that
  let angles = steps(from, to, 72);
  if (width < 0.5) {
    const towards = Math.atan2(dy, dx);
    for (const middle of [towards - 2 * Math.PI, towards, towards + 2 * Math.PI, towards + 4 * Math.PI]) {
      const [start, end] = [Math.max(from, middle - width), Math.min(to, middle + width)];
      if (start < end) angles = [...angles, ...steps(start, end, 96)];
    }
    angles.sort((u, v) => u - v);
  }
  return angles.map((angle) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]);
}

// The part of a polygon, or of a line, inside a box around the picture: a renderer loses what is too far away.
function clipped(points, is_closed) {
  const far = 20 * view_size;
  const edges = [[0, 1, -far], [0, -1, -far - view_size], [1, 1, -far], [1, -1, -far - view_size]];
  return edges.reduce((given, [k, sign, least]) => {
    const inside = (point) => sign * point[k] >= least;
    const cut = (u, v) => {
      const s = (least - sign * u[k]) / (sign * v[k] - sign * u[k]);
      return [u[0] + s * (v[0] - u[0]), u[1] + s * (v[1] - u[1])];
    };
    return given.flatMap((point, i) => {
      const before = i > 0 ? given[i - 1] : is_closed ? given[given.length - 1] : null;
      const crossing = before && inside(before) !== inside(point) ? [cut(before, point)] : [];
      return inside(point) ? [...crossing, point] : crossing;
    });
  }, points.filter((point) => point.every(Number.isFinite)));
}

// A picture. What is derived from it has `looks()`, the views by their name, the first of which is shown first, each
// with the point in its middle and half its width; and `shapes()`, everything that is in it.
class SceneView {
  constructor(scene, what) {
    this.scene = scene;
    this.yaw = 0.6;
    this.pitch = 0.45;
    this.root = svg('svg', {viewBox: `0 0 ${view_size} ${view_size}`, class: 'scene', tabindex: '0', role: 'application',
                            'aria-label': `${what} in three dimensions. Arrow keys turn it, plus and minus scale it.`});
    this.note = el('p', 'scene-note');
    this.root.addEventListener('pointerdown', (event) => this.root.setPointerCapture(event.pointerId));
    this.root.addEventListener('pointermove', (event) => {
      if (event.buttons === 0) return;
      this.turn(event.movementX / 120, event.movementY / 120);
    });
    this.root.addEventListener('keydown', (event) => this.key(event));
    this.look(Object.keys(this.looks())[0]);
  }

  key(event) {
    const steps = {ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15]};
    if (steps[event.key]) this.turn(...steps[event.key]);
    else if (event.key === '+' || event.key === '=') this.zoom(1.4);
    else if (event.key === '-') this.zoom(1 / 1.4);
    else return;
    event.preventDefault();
  }

  turn(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.max(-1.57, Math.min(1.57, this.pitch + pitch));
    this.draw();
  }

  zoom(factor) {
    const {least, greatest} = this.limits();
    this.extent = Math.min(greatest, Math.max(least, this.extent / factor));
    this.draw();
  }

  // Beyond 10^9 a pixel is smaller than binary64 resolves.
  limits() { return {least: 1e-9, greatest: 4}; }

  look(at) {
    [this.middle, this.extent] = this.looks()[at];
    this.draw();
  }

  // Projection to the screen: x right, y down, z towards the eye.
  project(point) {
    const [x, y, z] = vec.sub(point, this.middle);
    const [s, c] = [Math.sin(this.yaw), Math.cos(this.yaw)];
    const [u, w] = [c * x + s * z, c * z - s * x];
    const [sp, cp] = [Math.sin(this.pitch), Math.cos(this.pitch)];
    const scale = this.scale();
    return [view_size / 2 + scale * u, view_size / 2 - scale * (cp * y - sp * w), sp * y + cp * w];
  }

  // Units of the picture for a length of 1.
  scale() { return view_size / 2 / this.extent; }

  place(point) { return this.project(point).slice(0, 2); }

  shape(tag, points, className) {
    const text = clipped(points, tag === 'polygon').map((point) => point.map((x) => x.toFixed(2)).join(',')).join(' ');
    return svg(tag, {points: text, class: className});
  }
  line(points, className) { return this.shape('polyline', points.map((point) => this.place(point)), className); }
  area(points, className) { return this.shape('polygon', points.map((point) => this.place(point)), className); }
  dot(point, className, size = 3.5) {
    const [cx, cy] = this.place(point);
    return svg('circle', {cx: cx.toFixed(2), cy: cy.toFixed(2), r: size, class: className});
  }

  // A sphere's outline, with rings inside; nothing where it is a point.
  sphere(centre, r, className, rings = true) {
    if (r === 0) return [];
    const outline = this.shape('polygon', arc(this.place(centre), r * this.scale(), 0, 2 * Math.PI), className);
    if (!rings) return [outline];
    return [outline, ...great_circles().map((ring) => this.line(ring.map((p) => vec.add(centre, vec.mul(p, r))), 'ring'))];
  }

  // The part of a triangle between these of its vertices, and a dot for one of them.
  feature(points) {
    if (points.length === 1) return this.dot(points[0], 'feature', 7);
    return points.length === 2 ? this.line(points, 'feature') : this.area(points, 'feature');
  }

  // Points with words, [point, words] each. Those that coincide on the screen share a label: "A=B" where they are
  // equal, "A,B" where one hides the other.
  labels(named) {
    const groups = [];
    for (const [point, words] of named) {
      const at = this.place(point);
      const near = groups.find((group) => Math.hypot(group.at[0] - at[0], group.at[1] - at[1]) < 14);
      if (!near) groups.push({at, point, words});
      else near.words += (near.point.every((x, k) => x === point[k]) ? '=' : words.length > 3 ? ', ' : ',') + words;
    }
    return groups.filter(({at}) => at.every((x) => x >= 0 && x <= view_size)).map(({at: [x, y], words}) => {
      // To the left of its point where it would leave the picture on the right, or else as far right as there is room.
      const width = 8 * words.length;
      const [at_x, anchor] = x + 7 + width < view_size ? [x + 7, 'start'] : x - 7 > width ? [x - 7, 'end'] : [view_size - 4, 'end'];
      const label = svg('text', {x: at_x, y: y < 24 ? y + 17 : y - 7, 'text-anchor': anchor});
      label.textContent = words;
      return label;
    });
  }

  draw() {
    this.root.replaceChildren(...this.shapes());
    const note = this.caution();
    if (this.note.textContent !== note) this.note.textContent = note;
  }

  // The parts of the view that are not to scale as it is now; empty where everything is.
  caution() { return ''; }
}

// A picture with its buttons, and sentences below.
function scene_box(view, ...words) {
  const button = (label, act) => {
    const node = el('button', 'copy', label);
    node.type = 'button';
    node.addEventListener('click', act);
    return node;
  };
  const looks = Object.keys(view.looks()).map((at) => button(at, () => view.look(at)));
  return el('figure', 'scene-box', view.root,
    el('div', 'controls tight', ...looks, button('+', () => view.zoom(1.4)), button('−', () => view.zoom(1 / 1.4))),
    view.note, el('figcaption', '', ...words));
}

// The predicates of which a page shows witnesses, by id; the script of a predicate's picture adds it. Each has the picture (`figure`), the groups of a
// query's numbers in the order in which people read them (`groups_of(query)`), the name of a suite of predicates in code to paste, what is so where
// the two touch, the name of its measure of time and the parts that its
// measure `feature` numbers, the commands that a page of it names, and kernels for a league. A predicate that is not here has
// its numbers alone.

const page_predicates = {};

// A query or a plan names its predicate unless that is implied.
const page_predicate_named = (of) => page_predicates[of.predicate ?? ''];
const page_has_command = (plan, command) => page_predicate_named(plan)?.commands?.includes(command) ?? false;

function page_predicate_of(query) {
  return page_predicate_named(query) ?? {groups_of: () => Object.keys(query.decimal ?? {}), figure: null, suite: 'Witness', touching: 'They touch.'};
}

function scene_figure(query) {
  const {figure} = page_predicate_of(query);
  if (figure === null) return el('p', 'empty', 'There is no picture for this predicate.');
  return figure(query) ?? el('p', 'empty', 'Not drawn: a number is not finite, or all are zero.');
}
