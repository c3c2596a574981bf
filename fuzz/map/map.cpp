#include "fuzz/map/map.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/files/sphere_triangle_query.h"
#include "fuzz/map/canvas.h"
#include "kernel/sphere_triangle/reference/scalar.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/filters/decided_check.h"
#include "fuzz/search/moves/moves.h"
#include "fuzz/search/proved.h"
#include "kernel/ask.h"
#include "kernel/sphere_triangle/shown_sides.h"

namespace axiscert {
namespace {

constexpr std::size_t second_opinion_pixels = 4096;

// The truth about one pixel's query, and the kernel's answer to it.
struct Pixel {
  Truth truth;  // truth of a valid query; without formulae
  ComparisonBits exact, ties;
  ComparisonBits certain;     // comparisons for which the sign of the published one is certain
  ComparisonBits all_exact;   // the published comparisons with non-strict sides: equal to the truth's
  ComparisonBits not_finite;  // comparisons with a computed side that is not finite
  Outcome said;
  std::optional<Verdict> right;
  bool outside = false;
};

bool holds(AxisBits axes, std::size_t axis) { return has_bit(axes, axis); }

// Whether the certain comparisons settle the axis: all of its comparisons are certain, or a certain one fails.
bool is_axis_settled(std::size_t axis, ComparisonBits bits, ComparisonBits certain) {
  const ComparisonBits all = axis_comparisons[axis];
  return (all & ~certain) == 0 || (all & certain & ~bits) != 0;
}

// Settled if an axis is certain to separate, or if it is certain that none does.
bool is_verdict_settled(ComparisonBits bits, ComparisonBits certain) {
  bool every_axis = true;
  for (std::size_t axis = 0; axis < axis_count; ++axis) {
    const bool settled = is_axis_settled(axis, bits, certain);
    if (settled && holds(axes_of(bits), axis)) return true;
    every_axis = every_axis && settled;
  }
  return every_axis;
}

Shown verdict_shown(const Pixel& p) {
  std::optional<bool> right;
  if (p.right) right = *p.right == Verdict::separated;
  return {p.truth.verdict == Verdict::separated,
          p.truth.touching,
          is_verdict_settled(p.all_exact, p.certain),
          said_by(p.said),
          right,
          false,
          p.said.verdict,
          p.outside};
}

Shown axis_shown(const Pixel& p, std::size_t axis) {
  const bool yes = holds(axes_of(p.exact), axis);
  const bool strictly = holds(axes_of(static_cast<ComparisonBits>(p.exact & ~p.ties)), axis);
  const bool with_ties = holds(axes_of(static_cast<ComparisonBits>(p.exact | p.ties)), axis);
  std::optional<bool> said;
  if (p.said.bits) said = holds(axes_of(*p.said.bits), axis);
  return {yes,      strictly != with_ties, is_axis_settled(axis, p.exact, p.certain), said, yes, false, p.said.verdict,
          p.outside};
}

Shown comparison_shown(const Pixel& p, std::size_t k) {
  const bool yes = has_bit(p.exact, k);
  std::optional<bool> said;
  if (p.said.bits) said = has_bit(*p.said.bits, k);
  return {yes, has_bit(p.ties, k),       has_bit(p.certain, k), said,
          yes, has_bit(p.not_finite, k), p.said.verdict,        p.outside};
}

Shown subject_shown(const MapSubject& subject, const Pixel& p) {
  switch (subject.level) {
    case Level::verdict:
      return verdict_shown(p);
    case Level::axis:
      return axis_shown(p, subject.index);
    case Level::comparison:
      return comparison_shown(p, subject.index);
  }
  return {};
}

template <class Real>
class Drawing {
 public:
  Drawing(const MapPlan& plan, std::vector<Canvas>& canvases)
      : plan_(plan), witness_(sphere_triangle_query_in<Real>(plan.witness)), canvases_(canvases) {
    constexpr double u = std::numeric_limits<Real>::epsilon() / 2;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      const auto proved = proved_error(*plan.kernel, precision_of<Real>, static_cast<Comparison>(k));
      // The double nearest to a decimal may be below it; the product with a power of two is exact.
      if (proved) bounds_[k] = std::nextafter(proved->value(), std::numeric_limits<double>::infinity()) * u;
    }
    has_bounds_ = std::any_of(bounds_.begin(), bounds_.end(), [](const auto& b) { return b.has_value(); });
  }

  // Draws the pixels from `first` to before `last`, row by row.
  void draw(std::size_t first, std::size_t last, ProgressCount& progress) const {
    const Implementation<Real> kernel = plan_.kernel->on<Real>(plan_.target);
    Cascade<Real> cascade(filter_on<Real>(plan_.target));
    QueryBatch<Real> batch(batch_pixels, coordinate_count);
    Reply<Real> reply;
    for (std::size_t at = first; at < last; at += batch.size()) {
      batch.clear();
      for (std::size_t i = at; i < std::min(last, at + batch_pixels); ++i) {
        batch.push_back(query_at(plan_.plane, witness_, i % plan_.plane.columns(), i / plan_.plane.columns()));
      }
      ask(kernel, batch.columns(), reply);
      const std::vector<DecidedSigns>& decided = cascade.decide(batch);
      for (std::size_t i = 0; i < batch.size(); ++i) {
        const Query<Real> q = batch[i];
        if (!is_valid(q)) continue;  // remains no_query, as initialised
        check(at + i, decided[i], q);
        put(at + i, pixel(decided[i], reply, i, q));
      }
      progress.asked(batch.size());
    }
  }

 private:
  void check(std::size_t position, const DecidedSigns& decided, const Query<Real>& q) const {
    const bool hardest = decided.step == Step::integers && position % integer_check_stride == 0;
    if (hardest || position % second_opinion_pixels == 0) require_same(decided, exact_truth(q, true), q);
  }

  Pixel pixel(const DecidedSigns& decided, const Reply<Real>& reply, std::size_t i, const Query<Real>& q) const {
    const Signs& signs = decided.signs;
    const Kernel& kernel = *plan_.kernel;
    Pixel p{{verdict_of(signs), is_touching(signs, q.r == 0)},
            0,
            0,
            decided.certain_in_lanes,
            signs.bits(Strictness::nonstrict),
            0,
            reply.outcome(i),
            std::nullopt};
    p.right = right_verdict(p.truth, kernel.touching);
    p.outside = !is_within(kernel.limits, q);
    if (!has_comparison_maps(kernel)) return p;
    if (kind_of(kernel.formulae) == FormulaeKind::rung) {  // rungs have the published signs on every query
      p.exact = signs.bits(kernel.strictness);
      p.ties = signs.ties;
    } else {
      const FormulaTruth own = formula_truth(kernel.formulae, q);
      p.exact = own.bits(kernel.strictness);
      p.ties = own.ties;
    }
    if (kernel.exposes == Exposure::sides && p.said.bits) look_at_sides(sides_at(reply.answers, i), q, p);
    return p;
  }

  bool are_as_claimed(const Sides<Real>& sides, const Query<Real>& q) const {
    const Kernel& kernel = *plan_.kernel;
    Sides<Real> claimed;
    reference(kernel.formulae, kernel.arithmetic, kernel.strictness, q, &claimed);
    return claimed.lhs == sides.lhs && claimed.rhs == sides.rhs;
  }

  void look_at_sides(const Sides<Real>& sides, const Query<Real>& q, Pixel& p) const {
    const bool in_box = has_bounds_ && is_in_box(q);
    for (std::size_t k = 0; k < comparison_count; ++k) {
      const auto bit = one_bit<ComparisonBits>(k);
      const double lhs = sides.lhs[k], rhs = sides.rhs[k];
      if (!std::isfinite(lhs) || !std::isfinite(rhs)) p.not_finite |= bit;
      if (!in_box || !bounds_[k]) continue;
      // Rounding is monotone: if the rounded difference exceeds a double, so does the exact one.
      bool certain = std::fabs(lhs - rhs) > *bounds_[k];
      const bool is_wrong = has_bit(*p.said.bits, k) != has_bit(p.exact, k);
      // The bound is for the sides that the kernel claims to compute; those of foreign code may be others.
      if (certain && is_wrong && !are_as_claimed(sides, q)) certain = false;
      p.certain = static_cast<ComparisonBits>(certain ? p.certain | bit : p.certain & ~bit);
      if (certain && is_wrong) {
        throw HarnessFault(fmt::format("{}: the proved bound of {} is refuted by {}", plan_.kernel->id,
                                       comparisons[k].name, query_line({"refuted", precision_of<Real>, q})));
      }
    }
  }

  void put(std::size_t position, const Pixel& p) const {
    for (std::size_t s = 0; s < plan_.subjects.size(); ++s) {
      canvases_[s].put(position, subject_shown(plan_.subjects[s], p));
    }
  }

  const MapPlan& plan_;
  const Query<Real> witness_;
  std::vector<Canvas>& canvases_;
  // bound of |computed lhs - rhs| if the sign may be wrong
  std::array<std::optional<double>, comparison_count> bounds_;
  bool has_bounds_ = false;
};

// Marks the pixels that are not yes and have a neighbour to the left, right, above or below that is.
void mark_boundary(Canvas& canvas, std::size_t columns, std::size_t rows) {
  const auto is_yes = [&](std::size_t column, std::size_t row) {  // correct also if it wraps below 0
    return column < columns && row < rows && canvas.yes[row * columns + column] != 0;
  };
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      PixelClass& here = canvas.pixels[row * columns + column];
      if (here != PixelClass::no && here != PixelClass::no_uncertain) continue;
      if (is_yes(column - 1, row) || is_yes(column + 1, row) || is_yes(column, row - 1) || is_yes(column, row + 1)) {
        here = PixelClass::boundary;
      }
    }
  }
}

template <class Real>
void draw(const MapPlan& plan, std::vector<Canvas>& canvases, const ShowProgress& report) {
  const Drawing<Real> drawing(plan, canvases);
  const std::size_t pixels = plan.plane.columns() * plan.plane.rows();
  const std::size_t blocks = (pixels + block_pixels - 1) / block_pixels;
  ProgressCount progress(report, blocks);
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    drawing.draw(block * block_pixels, std::min(pixels, (block + 1) * block_pixels), progress);
    progress.finished();
  });
}

}  // namespace

PixelClass class_of(const Shown& s) {
  if (s.outside) return PixelClass::outside_limits;
  if (!s.said) {
    if (s.answer == Verdict::undecided) return PixelClass::undecided;
    return s.answer == Verdict::invalid ? PixelClass::invalid : PixelClass::unanswered;
  }
  if (s.right && *s.said != *s.right) {
    return *s.said ? PixelClass::false_separation : PixelClass::missed_separation;
  }
  if (s.not_finite) return PixelClass::not_finite;
  if (s.tie) return PixelClass::tie;
  if (s.yes) return s.certain ? PixelClass::yes : PixelClass::yes_uncertain;
  return s.certain ? PixelClass::no : PixelClass::no_uncertain;
}

std::optional<bool> said_by(const Outcome& said) {
  if (said.verdict != Verdict::separated && said.verdict != Verdict::contact) return std::nullopt;
  return said.verdict == Verdict::separated;
}

std::string_view name(const MapSubject& subject, const TestDescription& test) {
  return name(test, Flip{subject.level, subject.index, FlipKind::false_separation, false, {}});
}

std::vector<MapSubject> map_subjects(const TestDescription& test) {
  std::vector<MapSubject> all = {{Level::verdict, 0}};
  for (std::size_t i = 0; i < test.clauses.size(); ++i) all.push_back({Level::axis, static_cast<std::uint8_t>(i)});
  for (std::size_t i = 0; i < test.comparisons.size(); ++i) {
    if (test.comparisons[i].name == test.clauses[test.comparisons[i].clause].name) continue;
    all.push_back({Level::comparison, static_cast<std::uint8_t>(i)});
  }
  return all;
}

bool has_comparison_maps(const Kernel& kernel) {
  const bool has_formulae = kernel.test == &first_test() ? has_comparisons(kernel.formulae) : !kernel.claims.empty();
  return kernel.exposes != Exposure::verdict && has_formulae;
}

std::vector<MapPicture> draw_map(const MapPlan& plan, const ShowProgress& report) {
  const std::size_t pixels = plan.plane.columns() * plan.plane.rows();
  const Canvas empty{std::vector<PixelClass>(pixels, PixelClass::no_query), std::vector<char>(pixels, 0)};
  std::vector<Canvas> canvases(plan.subjects.size(), empty);
  if (plan.kernel->test != &first_test()) draw_by_oracles(plan, canvases, report);
  else if (plan.witness.precision == Precision::binary32) draw<float>(plan, canvases, report);
  else draw<double>(plan, canvases, report);
  std::vector<MapPicture> pictures;
  for (std::size_t s = 0; s < canvases.size(); ++s) {
    mark_boundary(canvases[s], plan.plane.columns(), plan.plane.rows());
    MapPicture picture{plan.subjects[s], std::move(canvases[s].pixels), {}};
    for (const PixelClass c : picture.pixels) ++picture.counts[c];
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace axiscert
