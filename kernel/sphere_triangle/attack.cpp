// Attacks the bounds of docs/gpu.md: of each form the greatest error of a side that permitted evaluations reach, beside
// the bound for any ring circuit; of the conservative test, missed contacts and the deepest phantom, by what is behind
// barriers.
//
//   permitted_attack sides|conservative [TRIALS [SEED]]    prints a table
//
// Queries have numbers below 1, a part of them very small ones; the worst are changed by little as long as they become
// worse. Errors are counted in w = 2^-23, the most that a faithful rounding is off, relative.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "kernel/base/error.h"
#include "kernel/permitted/adversary.h"
#include "kernel/sphere_triangle/attack_conservative.h"
#include "kernel/permitted/permissions.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert::permitted {
namespace {

using Query = std::array<float, 13>;
using Exact = long double;  // 64 bits: of numbers near 1 off by 2^-60, w by 2^-37
using ExactVector = portable::Vec3<Exact>;
constexpr Exact w = 0x1p-23L;
constexpr std::size_t tries = 24;  // choices of the values behind barriers

const Permissions& wgsl_kept() { return std::ranges::find(parts, "wgsl-kept", &Part::name)->permissions; }

struct Scene {
  std::array<ExactVector, 3> at;  // relative to the centre
  Exact r;
};
Scene scene_of(const Query& q) {
  const auto at = [&](std::size_t k) { return ExactVector{q[k], q[k + 1], q[k + 2]}; };
  return {{at(0) - at(9), at(3) - at(9), at(6) - at(9)}, q[12]};
}
Exact length(const ExactVector& v) { return std::sqrt(dot(v, v)); }
Exact reach_of(const Scene& scene) {
  return std::max({length(scene.at[0]), length(scene.at[1]), length(scene.at[2]), scene.r});
}
Exact distance_of(const Scene& scene) {
  return length(methods::ClosestPoint::closest(
      portable::CentredProblem<Exact>{scene.at[0], scene.at[1], scene.at[2], 0}, Exact(0)));
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  float unit() { return static_cast<float>(static_cast<double>(engine_() >> 11) * 0x1p-53 * 2 - 1); }

  Query query() {
    Query q;
    for (float& x : q) x = unit();
    const std::uint64_t kind = below(4);
    const float thin = std::ldexp(1.0F, -static_cast<int>(below(26)));
    if (kind == 1) {  // C near the line AB
      const float s = unit();
      for (std::size_t k = 0; k < 3; ++k) q[6 + k] = q[k] + s * (q[3 + k] - q[k]) + thin * q[6 + k];
    } else if (kind == 2) {  // B near A
      for (std::size_t k = 0; k < 3; ++k) q[3 + k] = q[k] + thin * q[3 + k];
    }
    if (below(2) == 0) {
      for (std::size_t k = 9; k < 12; ++k) q[k] = 0;  // so that the vertices are exact
    } else if (below(4) != 0) {                       // P near a point of the triangle, or of an edge
      const float s = std::fabs(unit()), t = below(2) == 0 ? 0 : (1 - s) * std::fabs(unit()),
                  away = std::ldexp(1.0F, -4 - static_cast<int>(below(14)));
      for (std::size_t k = 0; k < 3; ++k)
        q[9 + k] = q[k] + s * (q[3 + k] - q[k]) + t * (q[6 + k] - q[k]) + away * unit();
    }
    q[12] = std::fabs(q[12]);
    return q;
  }
  Query changed(Query q) {
    for (std::uint64_t n = 1 + below(3); n > 0; --n) {
      float& x = q[below(12)];
      if (below(2) == 0) x += std::ldexp(unit(), -static_cast<int>(below(24)));
      else x = std::nextafter(x, below(2) == 0 ? 4.0F : -4.0F);
      x = std::clamp(x, -1.0F, 1.0F);
    }
    return q;
  }

 private:
  std::mt19937_64 engine_;
};

// Calls score(query) on random queries and climbs from the best; returns the greatest score.
template <class Score>
Exact greatest_score(Random& random, std::size_t trials, Score&& score) {
  Query best{};
  Exact most = 0;
  std::size_t failed = 0;
  for (std::size_t i = 0; i < trials; ++i) {
    const bool climbs = most > 0 && i > trials / 4 && failed < trials / 4;
    const Query q = climbs ? random.changed(best) : random.query();
    const Exact found = score(q);
    failed = found > most ? 0 : failed + 1;
    if (found > most) {
      most = found;
      best = q;
    }
  }
  return most;
}

// A node over the reals, from the values behind barriers: its value, the sum of the sizes of the monomials that it
// expands to, how many these are, and of which degree.
struct Expanded {
  Exact value, size;
  double monomials, degree;
};
std::vector<Expanded> expanded(const Graph& graph, Evaluation& evaluation, std::span<const float> inputs) {
  std::vector<Expanded> all;
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    const Node& node = graph.nodes()[i];
    const auto child = [&](const Value v) {
      Expanded of = all[v.node];
      if (v.is_negative) of.value = -of.value;
      return of;
    };
    Expanded made{0, 0, 0, 0};
    switch (node.kind) {
      case Kind::input:
        made.value = inputs[static_cast<std::size_t>(node.payload)];
        made = {made.value, std::fabs(made.value), 1, 1};
        break;
      case Kind::constant:
        made = {node.payload, std::fabs(node.payload), node.payload == 0 ? 0.0 : 1.0, 1};
        break;
      case Kind::kept:
        made.value = evaluation.of({i}).greatest;  // it is fixed
        made = {made.value, std::fabs(made.value), 1, 1};
        break;
      case Kind::magnitude:
        made = child(node.children[0]);
        made.value = std::fabs(made.value);
        break;
      case Kind::sum:
        for (const Value term : node.children) {
          const Expanded of = child(term);
          made = {made.value + of.value, made.size + of.size, made.monomials + of.monomials,
                  std::max(made.degree, of.degree)};
        }
        break;
      case Kind::product:
        made = {1, 1, 1, 0};
        for (const Value factor : node.children) {
          const Expanded of = child(factor);
          made = {made.value * of.value, made.size * of.size, made.monomials * of.monomials, made.degree + of.degree};
        }
        break;
      default:
        throw HarnessFault("the bounds are of sums and products");
    }
    all.push_back(made);
  }
  return all;
}

// The greatest error of a form's sides, in w of the monomials' sizes where nothing is flushed; and as a share of its
// bound, flushed or not.
struct WorstSide {
  Exact share = 0, attained = 0;
  double monomials = 0, degree = 0;
  std::size_t comparison = 0;
};

WorstSide attacked_sides(const Recording& recording, Evaluation& evaluation, std::span<const float> q,
                         std::uint32_t pattern) {
  WorstSide worst;
  evaluation.start(q);
  for (std::uint32_t node = 0, bit = 0; node < recording.graph.nodes().size(); ++node) {
    if (recording.graph.nodes()[node].kind != Kind::kept) continue;
    const Reach reach = evaluation.of({node});
    evaluation.fix(node, ((pattern >> (bit++ % 32)) & 1) != 0 ? reach.greatest : reach.least);
  }
  const std::vector<Expanded> all = expanded(recording.graph, evaluation, q);
  for (std::size_t i = 0; i < recording.sides.size(); ++i) {
    for (const Value side : {recording.sides[i].first, recording.sides[i].second}) {
      const Reach reach = evaluation.of({side.node});
      const Expanded& of = all[side.node];
      if (!(of.size > 0)) continue;
      const double operations = of.monomials + of.degree - 2;
      // Each of at most as many operations as there are numbers in the monomials is flushed, all numbers being below 2.
      const Exact flushed = of.monomials * of.degree * 0x1p-126L * std::pow(2.0L, static_cast<Exact>(of.degree));
      const Exact rounded = (std::pow(1 + w, static_cast<Exact>(operations)) - 1) * of.size;
      const Exact error = std::max(Exact(reach.greatest) - of.value, of.value - Exact(reach.least));
      if (rounded + flushed > 0) worst.share = std::max(worst.share, error / (rounded + flushed));
      if (flushed < rounded / 1024 && error / (w * of.size) > worst.attained) {
        const Exact share = worst.share;
        worst = {share, error / (w * of.size), of.monomials, of.degree, i};
      }
    }
  }
  return worst;
}

void attack_sides(std::size_t trials, std::uint64_t seed) {
  fmt::print("| form | part | side | n | d | bound, in w | attained | most of a bound |\n");
  fmt::print("|---|---|---|---:|---:|---:|---:|---:|\n");
  for (const char* id : {"reduced-nonstrict", "reduced-along-nonstrict", "published", "moving-sphere/twenty-nonstrict",
                         "box-box/projected", "box-box/textbook", "box-box/cofactor"}) {
    const Kernel& kernel = find_kernel(id);
    const std::size_t columns = kernel.predicate->entries[kernel.entry].columns.size();
    for (const char* part : {"wgsl-kept", "wgsl"}) {
      const Recording recording = recorder_of(kernel)(std::ranges::find(parts, part, &Part::name)->permissions);
      const auto& nodes = recording.graph.nodes();
      if (part == std::string_view("wgsl-kept") && std::ranges::find(nodes, Kind::kept, &Node::kind) == nodes.end())
        continue;
      Evaluation evaluation(recording.graph);
      Random random(seed);
      WorstSide worst;
      std::vector<float> q(columns), best;
      for (std::size_t trial = 0; trial < trials; ++trial) {
        if (trial > trials / 2 && !best.empty()) {
          q = best;
          for (std::uint64_t n = 1 + random.below(3); n > 0; --n) q[random.below(columns)] = random.unit();
        } else {
          // A quarter so small that products are flushed.
          const float scale = trial % 4 == 0 ? std::ldexp(1.0F, -static_cast<int>(random.below(44))) : 1;
          for (float& x : q) x = scale * random.unit();
        }
        const WorstSide found =
            attacked_sides(recording, evaluation, q, static_cast<std::uint32_t>(random.below(1u << 31)));
        const Exact share = std::max(worst.share, found.share);
        if (found.attained > worst.attained) {
          worst = found;
          best = q;
        }
        worst.share = share;
      }
      fmt::print("| `{}` | `{}` | `{}` | {} | {} | {} | {:.2g} | {:.2g}{} |\n", id, part,
                 kernel.predicate->comparisons[worst.comparison].name, worst.monomials, worst.degree,
                 worst.monomials + worst.degree - 2, static_cast<double>(worst.attained),
                 static_cast<double>(worst.share), worst.share > 1 ? " EXCEEDED" : "");
    }
  }
}

struct Attacked {
  std::string_view behind;
  ConservativeShape shape;
};
constexpr Attacked conservative_tests[] = {
    {"A B C, edges, dots, W, s, n, products", {Barriers::pieces, Between::stands, 10, 19.125}},
    {"the same, any ring circuit, larger margins", {Barriers::pieces, Between::distributed, 13, 23}},
    {"A B C, dots, W, s, n", {Barriers::axes, Between::stands, 16, 30}},
    {"A B C, dots", {Barriers::dots, Between::stands, 16, 30}},
};

void attack_conservative(std::size_t trials, std::uint64_t seed) {
  fmt::print("| behind barriers | missed | deepest, of M | deepest phantom, in sqrt(w) M |\n|---|---:|---:|---:|\n");
  const Predicate predicate = conservative_predicate();
  for (const Attacked& one : conservative_tests) {
    const Recording recording = conservative(wgsl_kept(), one.shape);
    Adversary separates(predicate, recording, Verdict::separated, tries),
        touches(predicate, recording, Verdict::contact, tries);
    Random random(seed);
    std::size_t missed = 0;
    // As deep as contacts are that some evaluation separates: its radius is the distance and some.
    const Exact deepest = greatest_score(random, trials, [&](Query q) {
      const Scene scene = scene_of(q);
      const Exact distance = distance_of(scene), M = reach_of(scene);
      if (!(distance >= 0)) return Exact(0);  // of a repeated vertex it is not known
      Exact most = 0;
      for (Exact depth = 1; depth > 1e-9L; depth /= 4) {
        q[12] = std::nextafter(static_cast<float>(distance + depth * M), 4.0F);
        if (separates.answer(q) != Verdict::separated) continue;
        const Exact found = (Exact(q[12]) - distance) / reach_of(scene_of(q));
        if (found <= 0) continue;
        ++missed;
        most = std::max(most, found);
        break;
      }
      return most;
    });
    // The greatest radius below the distance at which some evaluation is in contact.
    const Exact phantom = greatest_score(random, trials, [&](Query q) {
      const Scene scene = scene_of(q);
      const Exact distance = distance_of(scene);
      if (!(distance >= 0)) return Exact(0);
      float low = 0, high = static_cast<float>(distance);
      q[12] = low;
      if (touches.answer(q) == Verdict::contact) high = low;
      while (high - low > 1e-6F) {
        q[12] = low + (high - low) / 2;
        (touches.answer(q) == Verdict::contact ? high : low) = q[12];
      }
      q[12] = high;
      return (distance - Exact(high)) / reach_of(scene_of(q)) / std::sqrt(w);
    });
    fmt::print("| {} | {} | {:.2g} | {:.2g} |\n", one.behind, missed, static_cast<double>(deepest),
               static_cast<double>(phantom));
  }
}

}  // namespace
}  // namespace axiscert::permitted

int main(int argc, char** argv) {
  const std::string_view which = argc > 1 ? argv[1] : "";
  const std::size_t trials = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 200;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (which == "sides") {
    axiscert::permitted::attack_sides(trials, seed);
  } else if (which == "conservative") {
    axiscert::permitted::attack_conservative(trials, seed);
  } else {
    fmt::print(stderr, "permitted_attack sides|conservative [TRIALS [SEED]]\n");
    return 2;
  }
}
