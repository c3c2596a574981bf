#include "examples/character/comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/base/error.h"
#include "reports/instrument/instrument.h"

namespace axiscert::character {
namespace {

// The kernel's answers for the candidates of asks first_ask to last_ask - 1.
std::vector<Verdict> answers(const Ground& ground, const Walk& walk, const Implementation<float>& kernel,
                             std::size_t first_ask, std::size_t last_ask) {
  const std::size_t first = walk.asks[first_ask].first;
  QueryBatch<float> batch(walk.asks[last_ask - 1].first + walk.asks[last_ask - 1].count - first, coordinate_count);
  for (std::size_t a = first_ask; a < last_ask; ++a) {
    const Ask& ask = walk.asks[a];
    for (std::size_t i = 0; i < ask.count; ++i) {
      batch.push_back(ground.query(ask.sphere, walk.triangles[ask.first + i]));
    }
  }
  std::vector<Verdict> found(batch.size());
  if (!found.empty()) kernel.verdicts(batch.columns(), found.data());
  return found;
}

// The certified answer to the kernel's own question, and whether a different answer is wrong.
struct Truth {
  bool contact, counts;
};
Truth truth_of(const Walk& walk, std::size_t i, TouchingPolicy touching) {
  const bool closed = walk.closed[i] == AXISCERT_CONTACT, open = walk.open[i] == AXISCERT_CONTACT;
  switch (touching) {
    case TouchingPolicy::contact:
      return {closed, true};
    case TouchingPolicy::separated:
      return {open, true};
    case TouchingPolicy::either:
      return {closed, closed == open};
  }
  return {closed, true};
}

void confirm(const Query<float>& q, bool contact, TouchingPolicy touching, const std::string& kernel) {
  const int order = distance_order(q);
  if (contact == (touching == TouchingPolicy::separated ? order < 0 : order <= 0)) return;
  throw HarnessFault(
      fmt::format("the certified predicate answers {} for a sphere and a triangle where {} differs, and "
                  "CGAL's exact distance agrees with {}",
                  contact ? "contact" : "separated", kernel, kernel));
}

class Judge {
 public:
  Judge(const Ground& ground, const Walk& walk, const Kernel& kernel) : ground_(ground), walk_(walk) {
    comparison_.kernel = kernel.id;
    comparison_.touching = kernel.touching;
  }

  void ask(std::size_t a, const Verdict* said) {
    const Ask& ask = walk_.asks[a];
    Tally& tally = comparison_.tallies[static_cast<std::size_t>(ask.moment)];
    bool touches = false, counts = true, found = false;
    for (std::size_t i = 0; i < ask.count; ++i) {
      const Truth truth = truth_of(walk_, ask.first + i, comparison_.touching);
      const bool contact = said[i] == Verdict::contact;
      touches |= truth.contact;
      counts &= truth.counts;
      found |= contact;
      if (truth.counts && contact != truth.contact) add(a, walk_.triangles[ask.first + i], truth.contact, tally);
    }
    if (touches == found || !counts) return;
    for (Tally* sum : {&tally, &comparison_.all}) ++(touches ? sum->lost : sum->phantom);
    if (touches && ask.moment == Moment::rest) comparison_.lost.push_back(a);
  }

  Comparison comparison() && { return std::move(comparison_); }

 private:
  void add(std::size_t a, std::uint32_t t, bool missed, Tally& tally) {
    const Query<float> q = ground_.query(walk_.asks[a].sphere, t);
    confirm(q, missed, comparison_.touching, comparison_.kernel);
    const Wrong wrong{a, t, missed, depth(q, squared_distance(q))};
    tally.errors.add(wrong);
    comparison_.all.errors.add(wrong);
    (ground_.has_area(t) ? comparison_.with_area : comparison_.without_area).add(wrong);
    comparison_.wrong.push_back(wrong);
  }

  const Ground& ground_;
  const Walk& walk_;
  Comparison comparison_;
};

}  // namespace

void Errors::add(const Wrong& wrong) {
  ++(wrong.missed ? missed : invented);
  double& deepest = wrong.missed ? deepest_missed : deepest_invented;
  deepest = std::max(deepest, wrong.depth);
}

WalkCountsByMoment asked(const Ground& ground, const Walk& walk) {
  WalkCountsByMoment all;
  for (const Ask& ask : walk.asks) {
    WalkCounts& sum = all[static_cast<std::size_t>(ask.moment)];
    ++sum.spheres;
    sum.triangles += ask.count;
    for (std::size_t i = ask.first; i < ask.first + ask.count; ++i) {
      if (walk.closed[i] != AXISCERT_CONTACT) continue;
      ++sum.contacts;
      if (walk.open[i] != AXISCERT_CONTACT) ++sum.touching;
      if (!ground.has_area(walk.triangles[i])) ++sum.without_area;
    }
  }
  return all;
}

Comparison compared(const Ground& ground, const Walk& walk, const Kernel& kernel) {
  constexpr std::size_t batch = 1 << 14;  // least number of triangles in a batch
  const Implementation<float> implementation = kernel.on<float>(resolve_target("auto"));
  Judge judge(ground, walk, kernel);
  for (std::size_t first = 0; first < walk.asks.size();) {
    std::size_t last = first + 1;
    while (last < walk.asks.size() && walk.asks[last].first < walk.asks[first].first + batch) ++last;
    const std::vector<Verdict> said = answers(ground, walk, implementation, first, last);
    for (std::size_t a = first; a < last; ++a) {
      judge.ask(a, said.data() + (walk.asks[a].first - walk.asks[first].first));
    }
    first = last;
  }
  return std::move(judge).comparison();
}

namespace {

using Row = std::vector<std::string>;

std::string text(std::uint64_t n) { return fmt::format("{}", n); }
std::string depth_text(std::uint64_t count, double depth) { return count == 0 ? "-" : fmt::format("{:.2e}", depth); }

std::string walk_table(const WalkCountsByMoment& asked) {
  std::vector<Row> rows;
  WalkCounts all;
  const auto add = [&rows](std::string_view moment, const WalkCounts& a) {
    rows.push_back({std::string(moment), text(a.spheres), text(a.triangles), text(a.contacts), text(a.touching),
                    text(a.without_area)});
  };
  for (std::size_t m = 0; m < moment_count; ++m) {
    const WalkCounts& a = asked[m];
    add(moment_names[m], a);
    all.spheres += a.spheres;
    all.triangles += a.triangles;
    all.contacts += a.contacts;
    all.touching += a.touching;
    all.without_area += a.without_area;
  }
  add("all", all);
  return aligned_table({"asked to", "spheres", "triangles", "contacts", "touching", "no area"}, rows);
}

std::string moments_table(std::span<const Comparison> comparisons) {
  std::vector<Row> rows;
  for (const Comparison& c : comparisons) {
    const auto add = [&](std::string_view moment, const Tally& t) {
      rows.push_back({c.kernel, std::string(moment), text(t.errors.missed), text(t.errors.invented), text(t.lost),
                      text(t.phantom)});
    };
    for (std::size_t m = 0; m < moment_count; ++m) add(moment_names[m], c.tallies[m]);
    add("all", c.all);
  }
  return aligned_table({"kernel", "asked to", "missed", "invented", "lost", "phantom"}, rows);
}

std::string depths_table(std::span<const Comparison> comparisons) {
  std::vector<Row> rows;
  for (const Comparison& c : comparisons) {
    const auto add = [&](const char* triangles, const Errors& e) {
      rows.push_back({c.kernel, triangles, text(e.missed), text(e.invented), depth_text(e.missed, e.deepest_missed),
                      depth_text(e.invented, e.deepest_invented)});
    };
    add("with area", c.with_area);
    add("without", c.without_area);
  }
  return aligned_table({"kernel", "triangles", "missed", "invented", "deepest missed", "deepest invented"}, rows);
}

}  // namespace

std::string table(const Ground& ground, const Walk& walk, std::span<const Comparison> comparisons) {
  return walk_table(asked(ground, walk)) + "\n" + moments_table(comparisons) + "\n" + depths_table(comparisons);
}

}  // namespace axiscert::character
