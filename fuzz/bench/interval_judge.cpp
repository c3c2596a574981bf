// The only source of the benchmark that computes in another rounding direction; it is built with -frounding-math.
#include <CGAL/Interval_nt.h>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "fuzz/bench/naive_judges.h"

namespace axiscert {
namespace {

// Intervals without a guard of their own around every operation: there is one around a block of queries.
using Interval = CGAL::Interval_nt<false>;

constexpr std::size_t block_size = 1024;

// The signs that the intervals decide; returns whether they decide all of them.
template <class Real>
bool signs_within_guard(const Query<Real>& q, Signs& signs) {
  const auto centred = centred_as<Interval>(q, [](Real x) { return Interval(static_cast<double>(x)); });
  bool all = true;
  portable::published_comparisons(centred, Interval(0), [&](Comparison which, const Interval& l, const Interval& r) {
    const CGAL::Uncertain<CGAL::Comparison_result> order = CGAL::compare(l, r);
    const auto bit = one_bit<SignBits>(which);
    if (!CGAL::is_certain(order)) all = false;
    else if (CGAL::get_certain(order) == CGAL::LARGER) signs.strict |= bit;
    else if (CGAL::get_certain(order) == CGAL::EQUAL) signs.ties |= bit;
  });
  return all;
}

}  // namespace

template <class Real>
std::uint64_t signs_by_intervals(const std::vector<Query<Real>>& queries, std::vector<Signs>& out) {
  out.assign(queries.size(), {});
  std::uint64_t open_queries = 0;
  std::vector<std::size_t> open;
  for (std::size_t first = 0; first < queries.size(); first += block_size) {
    const std::size_t last = std::min(first + block_size, queries.size());
    open.clear();
    {
      const Interval::Protector upward;
      for (std::size_t i = first; i < last; ++i) {
        if (is_valid(queries[i]) && !signs_within_guard(queries[i], out[i])) open.push_back(i);
      }
    }
    for (const std::size_t i : open) out[i] = signs_of(exact_sides(queries[i]));
    open_queries += open.size();
  }
  return open_queries;
}
template std::uint64_t signs_by_intervals<float>(const std::vector<Query<float>>&, std::vector<Signs>&);
template std::uint64_t signs_by_intervals<double>(const std::vector<Query<double>>&, std::vector<Signs>&);

}  // namespace axiscert
