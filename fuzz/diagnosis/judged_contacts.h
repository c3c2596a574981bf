// The numbers that a kernel gives beside its verdicts, judged on clear queries: of one family, by which their rules are
// found, and of all.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/diagnosis/other_units.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/diagnosis/subject.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json.h"

namespace axiscert::diagnosis::contacts {

constexpr std::size_t most_queries = 1024;
// Clear queries of each verdict of each family, asked where one family shows nothing wrong. For box-box/cofactor in
// binary32 they are 464 exact judgements, which take 2 s; all properties share them.
constexpr std::size_t most_of_family = 16;
constexpr std::uint64_t positions_of_family = 128;

// The size of ordinary rounding, in shares of the scene and in radians.
template <class Real>
constexpr double small = 0x1p11 * std::numeric_limits<Real>::epsilon();

// The same for features and points where a triangle, or what two edges have in common, is thin: an error of a small
// length h moves the nearest point of a convex body at the distance d by up to sqrt(2 h d). That is 16 sqrt(epsilon) of
// the scene where h is 128 epsilons of it and d all of it.
template <class Real>
const double coarse = 16 * std::sqrt(static_cast<double>(std::numeric_limits<Real>::epsilon()));

template <class Real>
std::vector<JudgedContact<Real>> judged(Subject<Real>& subject, const Queries<Real>& queries, bool of_families) {
  const Kernel& kernel = subject.kernel();
  const Oracles& oracles = oracles_of(kernel);
  std::vector<JudgedContact<Real>> all;
  if (queries.empty()) return all;
  const std::vector<std::size_t> lengths = unit_of_length(kernel).columns;
  const Reply<Real> reply = subject.ask_measures(queries);
  std::vector<JudgedContact<Real>>& known = subject.judged_contacts(of_families);
  known.resize(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Verdict said = reply.verdicts[i];
    if (!has_judged_contact(kernel, said, [&] { return oracles.truth(queries[i]); })) continue;
    std::vector<double> measures = reply.measures(i);
    if (!known[i].is_of(said, measures)) {
      const auto judge = oracles.contact_judge(queries[i]);
      if (judge == nullptr) continue;
      JudgedContact<Real> one{queries[i], Numbers<double>(queries[i].size()), said, std::move(measures), {}, {}};
      for (std::size_t k = 0; k < queries[i].size(); ++k) one.wide[k] = static_cast<double>(queries[i][k]);
      one.found = judge->judge(said, one.measures);
      one.exact = judge->place();
      const double scene = judge->scene();
      one.extent = scene;
      for (const std::size_t k : lengths) {
        one.reach = std::max(one.reach, std::fabs(one.wide[k]) / scene);
        one.extent = std::max(one.extent, std::fabs(one.wide[k]));
      }
      known[i] = std::move(one);
    }
    if (!known[i].found.missed) all.push_back(known[i]);
  }
  return all;
}

template <class Real>
std::vector<JudgedContact<Real>> judged_queries(Subject<Real>& subject) {
  const Kernel& kernel = subject.kernel();
  Queries<Real> queries;
  for (const auto& clear : clear_queries<Real>(kernel, most_queries)) {
    if (is_promised(kernel, clear.numbers)) queries.push_back(clear.numbers);
  }
  return judged(subject, queries, false);
}

// Clear queries of every family: a fault of few scenes, such as those of boxes along the axes, of deep ones or of small
// ones, may be on none of the others. Not of motions, whose numbers are far off for rounding where they graze.
template <class Real>
std::vector<JudgedContact<Real>> judged_of_families(Subject<Real>& subject) {
  const Kernel& kernel = subject.kernel();
  Queries<Real>& queries = subject.queries_of_families();
  if (is_of_motions(*kernel.predicate)) return {};
  for (const Family* family : queries.empty() ? all_families_of(*kernel.predicate) : std::vector<const Family*>()) {
    std::size_t contacts = 0, others = 0;
    for (std::uint64_t position = 0; family->entry == kernel.entry && position < positions_of_family; ++position) {
      const Numbers<Real> query = family->make<Real>(subject.seed(), position);
      const std::optional<Verdict> verdict = oracles_of(kernel).clear_verdict(query);
      if (!verdict || !is_promised(kernel, query)) continue;
      if ((*verdict == Verdict::contact ? contacts : others)++ < most_of_family) queries.push_back(query);
    }
  }
  return judged(subject, queries, true);
}

// The wrong numbers on those.
template <class Real>
struct OnFamilies {
  std::size_t of = 0, wrong = 0;
  double largest = 0;
  std::optional<JudgedContact<Real>> shown = {};  // with the largest error

  std::string text(std::string_view what) const {
    return fmt::format(
        "{} right but for rounding on clear queries of one family, and {} of {} of all families are "
        "wrong, by up to {:.3g} of the scene.",
        what, wrong, of, largest);
  }
  Json measured() const { return {{"wrong", wrong}, {"of", of}, {"largest_error", largest}}; }
};
// `error` is how far off the number is where it is wrong, 0 where it is right, and empty where there is none.
template <class Real, class Error>
OnFamilies<Real> on_families(Subject<Real>& subject, Error&& error) {
  OnFamilies<Real> found;
  for (const JudgedContact<Real>& one : judged_of_families(subject)) {
    const std::optional<double> off = error(one);
    if (!off) continue;
    ++found.of;
    if (!(*off > 0)) continue;
    ++found.wrong;
    if (found.shown && *off <= found.largest) continue;
    found.largest = *off;
    found.shown = one;
  }
  return found;
}

// How far apart the two are, or minus how deep; of a sphere or a capsule its centre or segment, where the radius is the
// only length of the entry (a box has three).
template <class Real>
double side_of(const Subject<Real>& subject, const JudgedContact<Real>& one) {
  const std::vector<PredicateColumn>& columns = subject.entry().columns;
  const auto is_length = [](const PredicateColumn& column) { return column.role == Role::length; };
  const auto radius = std::ranges::find_if(columns, is_length);
  const bool is_round = std::ranges::count_if(columns, is_length) == 1;
  return *one.exact.separation + (is_round ? one.wide[static_cast<std::size_t>(radius - columns.begin())] : 0);
}

// Whether no rounding takes the normal to the other side. Of a sphere or a capsule the centre or the segment has to be
// on that side. The judges take no normal for a flip where it is by at most 2 u of the scene, of two bodies 128 u; a
// method in the coordinates of the world errs by as many u of the greatest of these.
template <class Real>
bool has_clear_side(const Subject<Real>& subject, const JudgedContact<Real>& one) {
  if (!one.exact.separation) return false;
  const double u = std::numeric_limits<Real>::epsilon() / 2;
  const double allowed = has_measure(subject.predicate(), MeasureKind::point_b) ? 128 * u : 2 * u;
  return std::fabs(side_of(subject, one)) > allowed * one.extent;
}

// Whether a normal is farther off than rounding may take it, where it has a clear side. Apart, and of a centre or
// segment outside, an error h of the nearest point at the distance d turns it by up to sqrt(2 h / d), h as in `coarse`.
// Bodies that overlap have another axis that is nearly the least: a push along it leaves little.
template <class Real>
bool is_far_off(const Subject<Real>& subject, const JudgedContact<Real>& one) {
  if (!has_clear_side(subject, one)) return false;
  const double side = side_of(subject, one);
  if (side < 0) {
    const double left = one.found.pushed ? one.found.pushed->left.value() : 0;
    return left > small<Real> * one.extent / -side;
  }
  return one.found.normal_angle.value_or(0) > coarse<Real> * std::sqrt(one.extent / side);
}

// A rule holds on so many of a hundred queries.
constexpr std::size_t percent = 95;

inline bool holds_on_most(std::size_t count, std::size_t all) { return 100 * count >= percent * all; }

// Whether the numbers that are given are those of a likeness, where these are not the exact ones: within `near` of each
// other, as shares of the greater.
inline bool is_like(const std::vector<double>& like, std::span<const double> given, double near) {
  if (like.size() != given.size()) return false;
  double most = 0, off = 0;
  for (std::size_t k = 0; k < like.size(); ++k) {
    most = std::max({most, std::fabs(like[k]), std::fabs(given[k])});
    off = std::max(off, std::fabs(like[k] - given[k]));
  }
  return off <= near * std::max(most, 1e-3);
}

// The first likeness that holds on nearly all queries, and on some whose number is wrong.
template <class Real, class IsWrong>
const ContactLikeness* likeness_of(const Subject<Real>& subject, const std::vector<JudgedContact<Real>>& all,
                                   MeasureKind kind, IsWrong&& is_wrong) {
  const std::size_t first = *first_measure(subject.predicate(), kind);
  for (const ContactLikeness* like : capabilities_of(subject.predicate()).contact_likenesses) {
    if (like->kind != kind) continue;
    std::size_t wrong = 0, alike = 0;
    for (const JudgedContact<Real>& one : all) {
      wrong += is_wrong(one);
      const std::vector<double> numbers = like->numbers(one.wide, subject.kernel().entry);
      if (one.measures.size() >= first + numbers.size())
        alike += is_like(numbers, std::span(one.measures).subspan(first, numbers.size()), 16 * small<Real>);
    }
    if (wrong != 0 && holds_on_most(alike, all.size())) return like;
  }
  return nullptr;
}

}  // namespace axiscert::diagnosis::contacts
