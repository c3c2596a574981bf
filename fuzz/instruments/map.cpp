#include "fuzz/instruments/map.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/judge/oracles.h"
#include "fuzz/search/moves.h"
#include "fuzz/search/confirm.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

// A new foreign process is begun for each block, as for a unit of a run. Some microseconds a pixel with filters are
// some hundred without.
constexpr std::size_t filtered_block = std::size_t{1} << 14, exact_block = filtered_block / 16;
constexpr std::size_t batch_pixels = 256, second_opinion_pixels = 4096;

// The content of one pixel of one picture.
struct ShownPixel {
  bool yes, tie, certain;
  std::optional<bool> said;   // empty: the kernel gave no such answer
  std::optional<bool> right;  // empty: neither answer is wrong
  bool not_finite = false;
  Verdict answer = Verdict::unanswered;  // the verdict, which says why `said` is empty
  bool outside = false;                  // of the kernel's limits
};

PixelClass class_of(const ShownPixel& s) {
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

// A verdict in the form of an answer: whether it is `separated`; empty where it is neither that nor contact.
std::optional<bool> said_by(const Outcome& said) {
  if (said.verdict != Verdict::separated && said.verdict != Verdict::contact) return std::nullopt;
  return said.verdict == Verdict::separated;
}

// The classes of a picture, and for each pixel whether the exact answer is yes.
struct Canvas {
  std::vector<PixelClass> pixels;
  std::vector<char> yes;

  void put(std::size_t pixel, const ShownPixel& shown) {
    pixels[pixel] = class_of(shown);
    yes[pixel] = static_cast<char>(shown.yes);
  }
};

// The truth about one pixel's query, and the kernel's answer to it.
struct Pixel {
  Truth truth;
  ComparisonBits of_truth = 0;         // the comparisons that hold where the truth follows from them
  ComparisonBits exact = 0, ties = 0;  // of the formulae that the kernel claims
  ComparisonBits certain = 0;          // comparisons whose sign a bound determines
  ComparisonBits not_finite = 0;       // comparisons with a computed side that is not finite
  Outcome said;
  std::optional<Verdict> right;
  bool outside = false;
};

// The content of the pictures at a pixel.
class PixelShown {
 public:
  PixelShown(const Predicate& predicate, const Pixel& pixel)
      : predicate_(predicate),
        p_(pixel),
        exact_(clauses_of(predicate, p_.exact)),
        strictly_(clauses_of(predicate, p_.exact & ~p_.ties)),
        with_ties_(clauses_of(predicate, p_.exact | p_.ties)) {
    if (p_.said.bits) said_ = clauses_of(predicate, *p_.said.bits);
  }

  ShownPixel of(const MapSubject& subject) const {
    switch (subject.level) {
      case Level::verdict:
        return verdict();
      case Level::axis:
        return clause(subject.index);
      case Level::comparison:
        return comparison(subject.index);
    }
    return {};
  }

 private:
  ShownPixel verdict() const {
    std::optional<bool> right;
    if (p_.right) right = *p_.right == Verdict::separated;
    return {p_.truth.verdict == Verdict::separated,
            p_.truth.touching,
            is_verdict_settled(),
            said_by(p_.said),
            right,
            false,
            p_.said.verdict,
            p_.outside};
  }
  // A clause ties where it holds with its ties and not without them.
  ShownPixel clause(std::size_t i) const {
    const bool yes = has_bit(exact_, i);
    std::optional<bool> said;
    if (said_) said = has_bit(*said_, i);
    return {yes,
            has_bit(strictly_, i) != has_bit(with_ties_, i),
            is_clause_settled(i, p_.exact),
            said,
            yes,
            false,
            p_.said.verdict,
            p_.outside};
  }
  ShownPixel comparison(std::size_t k) const {
    const bool yes = has_bit(p_.exact, k);
    std::optional<bool> said;
    if (p_.said.bits) said = has_bit(*p_.said.bits, k);
    return {yes, has_bit(p_.ties, k),       has_bit(p_.certain, k), said,
            yes, has_bit(p_.not_finite, k), p_.said.verdict,        p_.outside};
  }

  // Whether the certain comparisons settle the clause: all of its comparisons are certain, or a certain one fails.
  bool is_clause_settled(std::size_t i, ComparisonBits bits) const {
    const ComparisonBits all = predicate_.clauses[i].comparisons;
    return (all & ~p_.certain) == 0 || (all & p_.certain & ~bits) != 0;
  }
  // Settled if a clause is certain to separate, or if every one is settled.
  bool is_verdict_settled() const {
    const ClauseBits holding = clauses_of(predicate_, p_.of_truth);
    bool every_clause = true;
    for (std::size_t i = 0; i < predicate_.clauses.size(); ++i) {
      const bool settled = is_clause_settled(i, p_.of_truth);
      if (settled && has_bit(holding, i)) return true;
      every_clause = every_clause && settled;
    }
    return every_clause;
  }

  const Predicate& predicate_;
  const Pixel& p_;
  const ClauseBits exact_, strictly_, with_ties_;
  std::optional<ClauseBits> said_;
};

template <class Real>
class Drawing {
 public:
  Drawing(const MapPlan& plan, std::vector<Canvas>& canvases)
      : plan_(plan),
        witness_(std::get<Numbers<Real>>(plan.witness.numbers)),
        oracles_(oracles_of(*plan.kernel)),
        canvases_(canvases),
        bounds_(predicate().comparisons.size()),
        proved_(capabilities_of(predicate()).proved_bounds) {
    constexpr double u = std::numeric_limits<Real>::epsilon() / 2;
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      const auto proved = proved_error(*plan.kernel, precision_of<Real>, k);
      // The double nearest to a decimal may be below it; the product with a power of two is exact.
      if (proved) bounds_[k] = std::nextafter(proved->value(), std::numeric_limits<double>::infinity()) * u;
    }
    has_bounds_ = std::any_of(bounds_.begin(), bounds_.end(), [](const auto& b) { return b.has_value(); });
  }

  std::size_t pixels_at_once() const { return oracles_.has_filters() ? filtered_block : exact_block; }

  // Draws the pixels from `first` to before `last`, row by row.
  void draw(std::size_t first, std::size_t last, ProgressCount& progress) const {
    const Implementation<Real> kernel = plan_.kernel->on<Real>(plan_.target);
    const std::unique_ptr<BatchOracle<Real>> known = batches_of<Real>(oracles_, plan_.target);
    QueryBatch<Real> batch(batch_pixels, witness_.size());
    Reply<Real> reply;
    for (std::size_t at = first; at < last; at += batch.size()) {
      batch.clear();
      for (std::size_t i = at; i < std::min(last, at + batch_pixels); ++i) {
        batch.push_back(query_at(plan_.plane, witness_, i % plan_.plane.columns(), i / plan_.plane.columns()));
      }
      ask(kernel, batch.columns(), reply);
      known->decide(batch);
      for (std::size_t i = 0; i < batch.size(); ++i) {
        known->check(i, at + i, second_opinion_pixels);
        put(at + i, pixel(*known, reply, i, batch[i]));
      }
      progress.add_queries(batch.size());
    }
  }

 private:
  const Predicate& predicate() const { return *plan_.kernel->predicate; }

  // By filters where these know, else by the oracles.
  Pixel pixel(const BatchOracle<Real>& known, const Reply<Real>& reply, std::size_t i, const Numbers<Real>& q) const {
    const Kernel& kernel = *plan_.kernel;
    std::unique_ptr<AskedQuery> asked;
    const auto about = [&]() -> AskedQuery& {
      if (!asked) asked = oracles_.about(q);
      return *asked;
    };
    const std::optional<Truth> truth = known.known(i);
    Pixel p{.truth = truth ? *truth : about().truth(), .said = reply.outcome(i), .right = std::nullopt};
    if (p.truth.verdict == Verdict::invalid) return p;
    p.right = right_verdict(p.truth, kernel.touching);
    p.outside = !is_promised(oracles_, kernel.limits, kernel.motion, q);
    const std::optional<KnownSigns> signs = known.signs(i);
    p.of_truth = signs ? signs->holds : 0;
    p.certain = signs ? signs->certain : all_comparisons(predicate());
    if (!has_comparison_maps(kernel)) return p;
    if (const std::optional<KnownSigns> claimed = known.claimed(i, kernel)) {
      p.exact = claimed->holds;
      p.ties = claimed->ties;
    } else if (const std::optional<Reference> chain = about().chain(kernel)) {
      p.exact = chain->exact.bits.value_or(0);
      p.ties = chain->ties;
    }
    if (kernel.exposes == Exposure::sides && p.said.bits) look_at_sides(reply.answers, i, q, p);
    return p;
  }

  void look_at_sides(const Answers<Real>& answers, std::size_t i, const Numbers<Real>& q, Pixel& p) const {
    const bool is_covered = has_bounds_ && proved_->cover(q);
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      const auto bit = one_bit<ComparisonBits>(k);
      const double lhs = answers.lhs[k][i], rhs = answers.rhs[k][i];
      if (!std::isfinite(lhs) || !std::isfinite(rhs)) p.not_finite |= bit;
      if (!is_covered || !bounds_[k]) continue;
      // Rounding is monotone: if the rounded difference exceeds a double, so does the exact one.
      bool certain = std::fabs(lhs - rhs) > *bounds_[k];
      const bool is_wrong = has_bit(*p.said.bits, k) != has_bit(p.exact, k);
      // The bound is for the sides that the kernel claims to compute; those of foreign code may be others.
      if (certain && is_wrong && !proved_->are_as_claimed(*plan_.kernel, q, answers, i)) certain = false;
      p.certain = certain ? p.certain | bit : p.certain & ~bit;
      if (certain && is_wrong) {
        throw HarnessFault(fmt::format(
            "{}: the proved bound of {} is refuted by {}", plan_.kernel->id, predicate().comparisons[k].name,
            query_line({"refuted", precision_of<Real>, q, &predicate(), plan_.kernel->entry})));
      }
    }
  }

  void put(std::size_t position, const Pixel& p) const {
    if (p.truth.verdict == Verdict::invalid) return;  // remains no_query, as initialised
    const PixelShown shown(predicate(), p);
    for (std::size_t s = 0; s < plan_.subjects.size(); ++s) canvases_[s].put(position, shown.of(plan_.subjects[s]));
  }

  const MapPlan& plan_;
  const Numbers<Real> witness_;
  const Oracles& oracles_;
  std::vector<Canvas>& canvases_;
  // bound of |computed lhs - rhs| if the sign may be wrong
  std::vector<std::optional<double>> bounds_;
  const ProvedBounds* proved_;
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
  const std::size_t at_once = drawing.pixels_at_once(), blocks = (pixels + at_once - 1) / at_once;
  ProgressCount progress(report, blocks);
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    drawing.draw(block * at_once, std::min(pixels, (block + 1) * at_once), progress);
    progress.finish_unit();
  });
}

}  // namespace

std::string_view name(const MapSubject& subject, const Predicate& predicate) {
  return name(predicate, Flip{subject.level, subject.index, FlipKind::false_separation, false, {}});
}

std::vector<MapSubject> map_subjects(const Predicate& predicate) {
  std::vector<MapSubject> all = {{Level::verdict, 0}};
  for (std::size_t i = 0; i < predicate.clauses.size(); ++i) all.push_back({Level::axis, static_cast<std::uint8_t>(i)});
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    if (predicate.comparisons[i].name == predicate.clauses[predicate.comparisons[i].clause].name) continue;
    all.push_back({Level::comparison, static_cast<std::uint8_t>(i)});
  }
  return all;
}

bool has_comparison_maps(const Kernel& kernel) {
  return kernel.exposes != Exposure::verdict && has_comparisons(kernel);
}

std::vector<MapPicture> draw_map(const MapPlan& plan, const ShowProgress& report) {
  const std::size_t pixels = plan.plane.columns() * plan.plane.rows();
  const Canvas empty{std::vector<PixelClass>(pixels, PixelClass::no_query), std::vector<char>(pixels, 0)};
  std::vector<Canvas> canvases(plan.subjects.size(), empty);
  if (plan.witness.precision == Precision::binary32) draw<float>(plan, canvases, report);
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
