// Maps of a test that has oracles and no filters: each pixel is decided by exact arithmetic.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "exact/trait/oracles.h"
#include "fuzz/map/canvas.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

template <class Real>
class OracleDrawing {
 public:
  OracleDrawing(const MapPlan& plan, std::vector<Canvas>& canvases)
      : plan_(plan),
        witness_(std::get<Numbers<Real>>(plan.witness.numbers)),
        oracles_(oracles_of(*plan.kernel)),
        canvases_(canvases) {}

  // Draws the pixels from `first` to before `last`, row by row.
  void draw(std::size_t first, std::size_t last, ProgressCount& progress) const {
    const Implementation<Real> kernel = plan_.kernel->on<Real>(plan_.target);
    QueryBatch<Real> batch(batch_pixels, witness_.size());
    Reply<Real> reply;
    for (std::size_t at = first; at < last; at += batch.size()) {
      batch.clear();
      for (std::size_t i = at; i < std::min(last, at + batch_pixels); ++i) {
        batch.push_back(query_at(plan_.plane, witness_, i % plan_.plane.columns(), i / plan_.plane.columns()));
      }
      ask(kernel, batch.columns(), reply);
      for (std::size_t i = 0; i < batch.size(); ++i) put(at + i, batch[i], reply, i);
      progress.asked(batch.size());
    }
  }

 private:
  void put(std::size_t pixel, const Numbers<Real>& q, const Reply<Real>& reply, std::size_t in_batch) const {
    const std::unique_ptr<AskedQuery> asked = oracles_.about(q);
    const Truth truth = asked->truth();
    if (truth.verdict == Verdict::invalid) return;  // remains no_query, as initialised
    const Outcome said = reply.outcome(in_batch);
    const bool outside = !is_promised(*plan_.kernel, q);
    std::optional<Claimed> claim;
    if (has_comparison_maps(*plan_.kernel)) claim = asked->claimed(*plan_.kernel);
    for (std::size_t s = 0; s < plan_.subjects.size(); ++s) {
      const MapSubject& subject = plan_.subjects[s];
      if (subject.level == Level::verdict) {
        canvases_[s].put(pixel, of_verdict(truth, said, outside));
      } else if (claim && claim->sides) {
        const bool not_finite = subject.level == Level::comparison && has_infinite_side(reply, in_batch, subject.index);
        canvases_[s].put(pixel, of_bit(*claim->sides, said, subject, not_finite, outside));
      }
    }
  }

  Shown of_verdict(const Truth& truth, const Outcome& said, bool outside) const {
    std::optional<bool> right;
    if (const auto verdict = right_verdict(truth, plan_.kernel->touching)) right = *verdict == Verdict::separated;
    return {
        truth.verdict == Verdict::separated, truth.touching, true, said_by(said), right, false, said.verdict, outside};
  }

  // An axis ties where it holds with its ties and not without them.
  Shown of_bit(const ExactSides& sides, const Outcome& said, const MapSubject& subject, bool not_finite,
               bool outside) const {
    const auto holds = [&](ComparisonBits bits) {
      return has_bit(subject.level == Level::comparison ? bits : clauses_of(*plan_.kernel->test, bits), subject.index);
    };
    const bool yes = holds(sides.holds);
    const bool tie = holds(sides.holds | sides.ties) != holds(sides.holds & ~sides.ties);
    std::optional<bool> bit;
    if (said.bits) bit = holds(*said.bits);
    return {yes, tie, true, bit, yes, not_finite, said.verdict, outside};
  }

  bool has_infinite_side(const Reply<Real>& reply, std::size_t i, std::size_t comparison) const {
    if (plan_.kernel->exposes != Exposure::sides || !reply.has_bits) return false;
    return !std::isfinite(reply.answers.lhs[comparison][i]) || !std::isfinite(reply.answers.rhs[comparison][i]);
  }

  const MapPlan& plan_;
  const Numbers<Real> witness_;
  const Oracles& oracles_;
  std::vector<Canvas>& canvases_;
};

template <class Real>
void draw_blocks(const MapPlan& plan, std::vector<Canvas>& canvases, const ShowProgress& report) {
  // Some microseconds a pixel with filters are some hundred without.
  constexpr std::size_t pixels_at_once = block_pixels / 16;
  const OracleDrawing<Real> drawing(plan, canvases);
  const std::size_t pixels = plan.plane.columns() * plan.plane.rows();
  const std::size_t blocks = (pixels + pixels_at_once - 1) / pixels_at_once;
  ProgressCount progress(report, blocks);
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    drawing.draw(block * pixels_at_once, std::min(pixels, (block + 1) * pixels_at_once), progress);
    progress.finished();
  });
}

}  // namespace

void draw_by_oracles(const MapPlan& plan, std::vector<Canvas>& canvases, const ShowProgress& report) {
  if (plan.witness.precision == Precision::binary32) draw_blocks<float>(plan, canvases, report);
  else draw_blocks<double>(plan, canvases, report);
}

}  // namespace axiscert
