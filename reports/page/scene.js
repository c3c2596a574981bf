// The sphere and the triangle of a witness, which pointer or arrow keys turn. The drawing is only for the eye:
// binary64, after scaling; the exact facts about the query are stated next to it.

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

// The query translated to the centre and scaled so that the greatest of |A-P|, |B-P|, |C-P|, r is 1; null where a
// number is not finite or all are zero.
function scene_of(witness) {
  const points = ['a', 'b', 'c', 'p'].map((member) => witness[member].map(parse_hex));
  const r = parse_hex(witness.r);
  const greatest = Math.max(...points.flat().map(Math.abs), Math.abs(r));
  if (!(greatest < Infinity)) return null;
  // First scaled to a magnitude of 1, by a power of two: otherwise differences of the largest numbers overflow.
  const shrink = (x) => (greatest === 0 ? 0 : (x / 2 ** Math.trunc(Math.log2(greatest) / 2)) /
                         2 ** (Math.trunc(Math.log2(greatest)) - Math.trunc(Math.log2(greatest) / 2)));
  const [a, b, c, p] = points.map((point) => point.map(shrink));
  const triangle = [a, b, c].map((vertex) => vec.sub(vertex, p));
  const scale = Math.max(...triangle.map(vec.size), Math.abs(shrink(r)));
  if (!(scale > 0)) return null;
  const scaled = triangle.map((vertex) => vec.mul(vertex, 1 / scale));
  return {triangle: scaled, r: shrink(r) / scale, closest: closest_point(scaled)};
}

function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const view_size = 360;

// Circles of latitude 0 and of two longitudes, to show that the sphere turns.
function great_circles() {
  const circle = (u, v) => Array.from({length: 49}, (_, i) => {
    const t = Math.PI * i / 24;
    return vec.add(vec.mul(u, Math.cos(t)), vec.mul(v, Math.sin(t)));
  });
  return [circle([1, 0, 0], [0, 0, 1]), circle([1, 0, 0], [0, 1, 0]), circle([0, 1, 0], [0, 0, 1])];
}

class SceneView {
  constructor(scene) {
    this.scene = scene;
    this.yaw = 0.6;
    this.pitch = 0.45;
    this.root = svg('svg', {viewBox: `0 0 ${view_size} ${view_size}`, class: 'scene', tabindex: '0', role: 'application',
                            'aria-label': 'Sphere and triangle in three dimensions. Arrow keys turn it, plus and minus scale it.'});
    this.root.addEventListener('pointerdown', (event) => this.root.setPointerCapture(event.pointerId));
    this.root.addEventListener('pointermove', (event) => {
      if (event.buttons === 0) return;
      this.turn(event.movementX / 120, event.movementY / 120);
    });
    this.root.addEventListener('keydown', (event) => this.key(event));
    this.look('scene');
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

  // Beyond 10^9 a pixel is smaller than binary64 resolves.
  zoom(factor) {
    this.extent = Math.min(4, Math.max(1e-9, this.extent / factor));
    this.draw();
  }

  // Looks at the whole, at the triangle, or at the gap between the sphere and the nearest point.
  look(at) {
    const {triangle, r, closest} = this.scene;
    const distance = vec.size(closest.point);
    this.middle = [0, 0, 0];
    this.extent = 1.15 * Math.max(r, ...triangle.map(vec.size));
    if (at === 'triangle') {
      this.middle = vec.mul(triangle.reduce(vec.add), 1 / 3);
      this.extent = 1.3 * Math.max(1e-9, ...triangle.map((vertex) => vec.size(vec.sub(vertex, this.middle))));
    } else if (at === 'gap') {
      this.middle = closest.point;
      this.extent = Math.max(1e-9, 4 * Math.abs(distance - r), distance * 1e-7);
    }
    this.draw();
  }

  // Projection to the screen: x right, y down, z towards the eye.
  project(point) {
    const [x, y, z] = vec.sub(point, this.middle);
    const [s, c] = [Math.sin(this.yaw), Math.cos(this.yaw)];
    const [u, w] = [c * x + s * z, c * z - s * x];
    const [sp, cp] = [Math.sin(this.pitch), Math.cos(this.pitch)];
    const scale = view_size / 2 / this.extent;
    return [view_size / 2 + scale * u, view_size / 2 - scale * (cp * y - sp * w), sp * y + cp * w];
  }

  // Only near the middle: far ends are cut off before the renderer's single precision loses them.
  path(points) {
    const far = 1e5;
    return points.map((point) => this.project(point).slice(0, 2).map((x) => Math.max(-far, Math.min(far, x)).toFixed(2)).join(','))
      .join(' ');
  }

  text(point, words) {
    const [x, y] = this.project(point);
    const label = svg('text', {x: x + 7, y: y - 7});
    label.textContent = words;
    return label;
  }

  // Points that coincide on the screen share a label: "A=B" where they are equal, "A,B" where one hides the other.
  labels() {
    const groups = [];
    [[0, 0, 0], ...this.scene.triangle].forEach((point, i) => {
      const at = this.project(point);
      const near = groups.find((group) => Math.hypot(group.at[0] - at[0], group.at[1] - at[1]) < 14);
      if (!near) groups.push({at, point, words: 'PABC'[i]});
      else near.words += (near.point.every((x, k) => x === point[k]) ? '=' : ',') + 'PABC'[i];
    });
    return groups.map(({point, words}) => this.text(point, words));
  }

  draw() {
    const {triangle, r, closest} = this.scene;
    const centre = [0, 0, 0];
    const [x, y] = this.project(centre);
    const radius = Math.min(1e5, r * view_size / 2 / this.extent);
    const rings = great_circles().map((ring) => svg('polyline', {points: this.path(ring.map((p) => vec.mul(p, r))), class: 'ring'}));
    const marked = closest.vertices.map((i) => triangle[i]);
    const feature = closest.feature === 'face' ? svg('polygon', {points: this.path(marked), class: 'feature'})
      : closest.feature === 'edge' ? svg('polyline', {points: this.path(marked), class: 'feature'})
        : svg('circle', {cx: this.project(marked[0])[0], cy: this.project(marked[0])[1], r: 7, class: 'feature'});
    const dot = (point, className) => {
      const [cx, cy] = this.project(point);
      return svg('circle', {cx, cy, r: 3.5, class: className});
    };
    this.root.replaceChildren(
      svg('circle', {cx: x, cy: y, r: radius, class: 'ball'}), ...rings,
      svg('polygon', {points: this.path(triangle), class: 'triangle'}), feature,
      svg('polyline', {points: this.path([centre, closest.point]), class: 'gap'}),
      dot(centre, 'centre'), dot(closest.point, 'nearest'), ...triangle.map((vertex) => dot(vertex, 'vertex')),
      ...this.labels());
  }
}

function feature_words({closest, r}) {
  const letters = closest.vertices.map((i) => 'ABC'[i]).sort().join('');
  const name = closest.feature === 'face' ? 'the face' : `${closest.feature} ${letters}`;
  const distance = vec.size(closest.point);
  const gap = distance - r;
  return `Nearest feature: ${name}. As a share of the greatest of |A−P|, |B−P|, |C−P| and r: distance ${amount(distance, 4)}, ` +
    `radius ${amount(r, 4)}, ${gap > 0 ? 'gap' : 'overlap'} about ${amount(Math.abs(gap), 3)}. ` +
    'Drawn in binary64; the truth next to it is exact.';
}

function scene_figure(witness) {
  const scene = scene_of(witness);
  if (scene === null) return el('p', 'empty', 'Not drawn: a number is not finite, or all are zero.');
  const view = new SceneView(scene);
  const button = (label, act) => {
    const node = el('button', 'copy', label);
    node.type = 'button';
    node.addEventListener('click', act);
    return node;
  };
  return el('figure', 'scene-box', view.root,
    el('div', 'controls tight', button('Whole', () => view.look('scene')), button('Triangle', () => view.look('triangle')),
       button('Nearest point', () => view.look('gap')), button('+', () => view.zoom(1.4)), button('−', () => view.zoom(1 / 1.4))),
    el('figcaption', '', feature_words(scene)));
}
