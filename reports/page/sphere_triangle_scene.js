// The sphere and the triangle of a query.

// The query translated to the centre and scaled so that the greatest of |A-P|, |B-P|, |C-P|, r is 1; null where a
// number is not finite or all are zero.
function scene_of(query) {
  const near = near_one(query, ['a', 'b', 'c', 'p', 'r']);
  if (near === null) return null;
  const triangle = [near.a, near.b, near.c].map((vertex) => vec.sub(vertex, near.p));
  const scale = Math.max(...triangle.map(vec.size), Math.abs(near.r));
  if (!(scale > 0)) return null;
  const scaled = triangle.map((vertex) => vec.mul(vertex, 1 / scale));
  return {triangle: scaled, r: near.r / scale, closest: closest_point(scaled), said: said_contact(query, near, scale)};
}

// The point and the normal that a kernel gave, seen from the centre; null where it gave none that can be drawn.
function said_contact(query, {p, unit}, scale) {
  const given = query.measures?.given ?? {};
  const numbers = (name, of) => ['x', 'y', 'z'].map((axis) => of(parse_hex(given[`${name}_${axis}`] ?? '')));
  const point = numbers('point', unit), normal = numbers('normal', (x) => x);
  const is_drawn = (v) => v.every(Number.isFinite) && vec.size(v) < 1e6;
  const at = is_drawn(point) ? vec.mul(vec.sub(point, p), 1 / scale) : null;
  return {point: at !== null && vec.size(at) < 1e6 ? at : null, normal: is_drawn(normal) && vec.size(normal) > 0 ? normal : null};
}

class SphereTriangleView extends SceneView {
  constructor(scene) { super(scene, 'Sphere and triangle'); }

  // The whole, the triangle, or the gap between the sphere and the nearest point; first a sphere that is small in the whole.
  looks() {
    const {triangle, r, closest} = this.scene;
    const distance = vec.size(closest.point);
    const middle = vec.mul(triangle.reduce(vec.add), 1 / 3);
    const whole = 1.15 * Math.max(r, ...triangle.map(vec.size));
    return {
      ...(r > 0 && r < whole / 15 ? {Sphere: [[0, 0, 0], 2 * Math.max(r, distance)]} : {}),
      Whole: [[0, 0, 0], whole],
      Triangle: [middle, 1.3 * Math.max(1e-9, ...triangle.map((vertex) => vec.size(vec.sub(vertex, middle))))],
      'Nearest point': [closest.point, Math.max(1e-9, 4 * Math.abs(distance - r), distance * 1e-7)],
    };
  }

  shapes() {
    const {triangle, r, closest} = this.scene;
    const centre = [0, 0, 0];
    const {point, normal} = this.scene.said;
    const from = point ?? closest.point;
    const arrow = normal === null ? [] : [this.line([from, vec.add(from, vec.mul(normal, Math.max(r, 0.25) / vec.size(normal)))], 'reported')];
    return [...arrow, ...(point === null ? [] : [this.dot(point, 'reported-point')]), ...this.sphere(centre, r, 'ball'), this.area(triangle, 'triangle'),
            this.feature(closest.vertices.map((i) => triangle[i])), this.line([centre, closest.point], 'gap'),
            this.dot(centre, 'centre'), this.dot(closest.point, 'nearest'), ...triangle.map((vertex) => this.dot(vertex, 'vertex')),
            ...this.labels([centre, ...triangle].map((point, i) => [point, 'PABC'[i]]))];
  }
}

function feature_words({closest, r, said}) {
  const letters = closest.vertices.map((i) => 'ABC'[i]).sort().join('');
  const name = closest.feature === 'face' ? 'the face' : `${closest.feature} ${letters}`;
  const distance = vec.size(closest.point);
  const gap = distance - r;
  const reported = said.point === null && said.normal === null ? '' : ' Reported by the kernel: ' +
    `${[said.point && 'the point with a ring', said.normal && 'the normal, a thick line'].filter(Boolean).join(' and ')}.`;
  return `Nearest feature: ${name}. As a share of the greatest of |A−P|, |B−P|, |C−P| and r: distance ${amount(distance, 4)}, ` +
    `radius ${amount(r, 4)}, ${gap > 0 ? 'gap' : 'overlap'} about ${amount(Math.abs(gap), 3)}. ` +
    `Drawn in binary64; the truth next to it is exact.${reported}`;
}

function sphere_triangle_figure(query) {
  const scene = scene_of(query);
  return scene === null ? null : scene_box(new SphereTriangleView(scene), feature_words(scene));
}

page_predicates['sphere-triangle'] = {
  parts: ['vertex_a', 'vertex_b', 'vertex_c', 'edge_ab', 'edge_bc', 'edge_ca', 'face'],
  groups_of: () => ['a', 'b', 'c', 'p', 'r'], figure: sphere_triangle_figure, suite: 'SphereTriangle', touching: 'The distance is exactly r.',
  commands: ['prove', 'search', 'map', 'ladder', 'precision', 'league', 'mutate'], league: ['published', 'certified'],
};
page_predicates[''] = page_predicates['sphere-triangle'];  // which is implied
