#include "fuzz/instruments/safe_margin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "exact/judge/critical_radius.h"
#include "exact/judge/oracles.h"
#include "fuzz/instruments/for_each_judged.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/merge.h"
#include "fuzz/text/number_text.h"
#include "kernel/ask.h"
#include "kernel/base/error.h"
#include "kernel/query.h"

namespace axiscert {
namespace {

constexpr int decade_of_nothing = -400;  // below that of every number

// The powers of ten from 10^-323, the least that is not rounded to 0, to the greatest, each to the nearest double.
constexpr int least_power = -323;
std::vector<double> powers_of_ten() {
  std::vector<double> powers;
  for (int e = least_power; e <= std::numeric_limits<double>::max_exponent10; ++e)
    powers.push_back(parse_number<double>(fmt::format("1e{}", e)));
  return powers;
}

// The exponent of a number's shortest decimal. Such a decimal is on the same side of 10^e as the number is of the
// double nearest to 10^e, or both are at it, since rounding is monotone. A size that is infinite belongs to the
// greatest decade.
int scene_decade(double size) {
  if (size == 0) return decade_of_nothing;
  static const std::vector<double> powers = powers_of_ten();
  const auto above = std::upper_bound(powers.begin(), powers.end(), size);
  return least_power - 1 + static_cast<int>(above - powers.begin());
}

}  // namespace

SceneMeasure::SceneMeasure(const Predicate& predicate)
    : oracles_(oracles_of(predicate)), columns_(predicate.entries[0].columns), centre_(columns_.size()) {
  const std::optional<CriticalLength> length = oracles_.critical_length();
  if (!length || !length->centre) return;
  for (const ColumnGroup& group : groups_of(predicate.entries[0])) {
    for (std::size_t k = 0; k < group.size && group.size == 3; ++k)
      if (columns_[group.first + k].role == Role::coordinate) centre_[group.first + k] = *length->centre + k;
  }
}

template <class Real>
double SceneMeasure::size(const Numbers<Real>& query) const {
  double size = 0;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    double x = static_cast<double>(query[k]);
    if (centre_[k]) x -= static_cast<double>(query[*centre_[k]]);
    size = std::max(size, std::abs(x));
  }
  return size;
}
template double SceneMeasure::size(const Numbers<float>&) const;
template double SceneMeasure::size(const Numbers<double>&) const;

template <class Real>
MarginScene SceneMeasure::of(const Numbers<Real>& query) const {
  return {oracles_.is_degenerate(query), scene_decade(size(query))};
}
template MarginScene SceneMeasure::of(const Numbers<float>&) const;
template MarginScene SceneMeasure::of(const Numbers<double>&) const;

namespace {

constexpr std::uint64_t margin_batch = 1024, margin_block = 4 * margin_batch;

CriticalLength critical_length_of(const Kernel& kernel) {
  if (const auto length = oracles_of(*kernel.predicate).critical_length()) return *length;
  throw HarnessFault(fmt::format("{} has no critical length", kernel.predicate->id));
}

// The right verdict, as the kernel's convention has it; empty where neither is wrong, where the numbers are no query,
// and where the kernel promises nothing.
template <class Real>
std::optional<Verdict> promised_verdict(const Kernel& kernel, const Truth& truth, const Numbers<Real>& query) {
  if (truth.verdict == Verdict::invalid || !is_promised(kernel, query)) return std::nullopt;
  return right_verdict(truth, kernel.touching);
}

// Finds, for queries that the kernel misses, the growth that each needs.
template <class Real>
class MarginFinder {
 public:
  // `kernel` is that of the plan, begun.
  MarginFinder(const SafeMarginPlan& plan, const Implementation<Real>& kernel, SafeMargin& into)
      : plan_(plan),
        length_(critical_length_of(*plan.kernel)),
        scene_(*plan.kernel->predicate),
        range_(radii_within<Real>(plan.kernel->limits)),
        kernel_(kernel),
        into_(into) {}

  MarginScene scene(const Numbers<Real>& query) const { return scene_.of(query); }
  std::size_t radius() const { return length_.column; }
  Real greatest() const { return range_.greatest; }

  // Counts a query that is a contact, in the part of its scene. One that the kernel calls separated is for add_missed.
  void count_contact(MarginPart& part, Verdict said, ContactAnswers& among) {
    among.add(said);
    ++part.contacts;
    part.without_verdict += said != Verdict::contact && said != Verdict::separated;
  }

  // One that the kernel calls separated.
  void add_missed(const Numbers<Real>& query, const std::string& family, const std::string& id) {
    MarginPart& part = into_.parts[scene(query)];
    ++part.missed;
    const Real r = query[radius()] + Real(0);  // of -0, which is the radius 0 too, the bits are not in order
    const CriticalRadius<Real> critical =
        critical_radius(kernel_, QueryWithRadius<Real>{query, radius()}, {r, std::max(r, greatest_for(query))});
    const auto contact = [&](const Decimal6& value) {
      const Predicate& predicate = *plan_.kernel->predicate;
      return MissedContact{query_line({id, precision_of<Real>, query, &predicate}), family, format_number(r),
                           critical.radius ? format_number(*critical.radius) : "", value};
    };
    if (!critical.answered || (critical.radius && *critical.radius <= r)) {
      ++part.unmeasured;
      return;
    }
    if (!critical.radius) {
      ++part.hopeless;
      if (!into_.hopeless) into_.hopeless = contact({});
      return;
    }
    const Rational from = exact(r), to = exact(*critical.radius);
    const Decimal6 amount = round_up(Rational(to - from));
    for (std::optional<MissedContact>* kept : {&part.amount, &into_.amount})
      if (!*kept || amount > (*kept)->value) *kept = contact(amount);
    if (is_tiny(query)) {
      ++part.tiny;
      return;
    }
    const Decimal6 factor = round_up(Rational(to / from));
    for (std::optional<MissedContact>* kept : {&part.factor, &into_.factor})
      if (!*kept || factor > (*kept)->value) *kept = contact(factor);
  }

  // Twice the scene's size: a sphere of that radius holds the whole triangle, and a kernel that misses it even then is
  // mended by no margin.
  Real greatest_for(const Numbers<Real>& query) const {
    const double twice = 2 * scene_.size(query);
    return twice < static_cast<double>(range_.greatest) ? static_cast<Real>(twice) : range_.greatest;
  }

  // Is r below 2^-tiny_radius_exponent of the scene's size? Zero is tiny in each scene, also in one of no size.
  bool is_tiny(const Numbers<Real>& query) const {
    const auto r = static_cast<double>(query[radius()]);
    return r == 0 || std::ldexp(r, tiny_radius_exponent[precision_of<Real>]) < scene_.size(query);
  }

  // Asks at the least radius that is a contact.
  void probe(Numbers<Real> query, const std::string& family, const std::string& id) {
    const auto is_finite = [](Real x) { return std::isfinite(x); };
    if (!(query[radius()] >= 0) || !std::all_of(query.begin(), query.end(), is_finite)) return;
    const std::optional<Rational> squared = length_.squared(in_doubles(query));
    if (!squared) return;
    const auto least = sqrt_rounded_up<Real>(*squared);
    if (!least || *least < range_.least || *least > range_.greatest) return;
    query[radius()] = *least;
    add_if_missed(query, family, id, into_.probed);
  }
  void add_if_missed(const Numbers<Real>& query, const std::string& family, const std::string& id,
                     std::uint64_t& asked) {
    const Truth truth = oracles_of(*plan_.kernel).about(query, Opinion::first)->truth();
    const std::optional<Verdict> right = promised_verdict(*plan_.kernel, truth, query);
    if (!right) return;
    ++asked;
    if (*right != Verdict::contact) return;
    const Verdict said = ask(kernel_, query).verdicts[0];
    count_contact(into_.parts[scene(query)], said, into_.of_others);
    if (said == Verdict::separated) add_missed(query, family, id);
  }

 private:
  const SafeMarginPlan& plan_;
  const CriticalLength length_;
  const SceneMeasure scene_;
  const RadiusRange<Real> range_;
  const Implementation<Real>& kernel_;
  SafeMargin& into_;
};

std::string margin_address(const SafeMarginPlan& plan, const Source& source, std::uint64_t position) {
  return text(address_of(source, plan.asked->seed, plan.precision, position));
}

template <class Real>
void find_in(const SafeMarginPlan& plan, JudgedBatch<Real>& batch, SafeMargin& found) {
  MarginFinder<Real> finder(plan, batch.kernel(0), found);
  const std::string family = batch.source().name();
  const std::vector<Verdict>& said = batch.reply(0).verdicts;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Numbers<Real> query = batch[i];
    if (const auto right = promised_verdict(*plan.kernel, batch.truth(i), query)) {
      MarginPart& part = found.parts[finder.scene(query)];
      ++found.queries;
      ++part.queries;
      if (*right == Verdict::separated) found.phantoms += said[i] == Verdict::contact;
      else finder.count_contact(part, said[i], found.of_run);
      if (*right == Verdict::contact && said[i] == Verdict::separated)
        finder.add_missed(query, family, margin_address(plan, batch.source(), batch.position(i)));
    }
    if (batch.position(i) < plan.probes) {
      finder.probe(query, family, margin_address(plan, batch.source(), batch.position(i)) + " at the least radius");
    }
  }
}

// How r is grown in the scenes of one decade and kind.
struct Growth {
  Rational factor, amount;
};
using Growths = std::map<MarginScene, Growth>;

Growths growths_of(const SafeMargin& margin) {
  Growths growths;
  for (const auto& [scene, part] : margin.parts) {
    growths[scene] = {part.factor ? exact(part.factor->value) : Rational(1),
                      part.amount ? exact(part.amount->value) : Rational(0)};
  }
  return growths;
}

// The queries of a batch that the kernel calls separated, with r grown in two ways.
template <class Real>
void grow_in(const SafeMarginPlan& plan, const Growths& growths, JudgedBatch<Real>& batch, SafeMargin& found) {
  const MarginFinder<Real> finder(plan, batch.kernel(0), found);
  struct SeparatedQuery {
    Verdict right;
    MarginScene scene;
  };
  std::vector<SeparatedQuery> separated;
  const std::size_t columns = batch.queries().column_count();
  QueryBatch<Real> by_factor(batch.size(), columns), by_amount(batch.size(), columns);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (batch.reply(0).verdicts[i] != Verdict::separated) continue;
    Numbers<Real> query = batch[i];
    const auto right = promised_verdict(*plan.kernel, batch.truth(i), query);
    if (!right) continue;
    const MarginScene scene = finder.scene(query);
    const Growth& growth = growths.at(scene);  // every query with a truth is in one
    separated.push_back({*right, scene});
    const Real r = query[finder.radius()];
    query[finder.radius()] = std::min(finder.greatest(), rounded_up_to<Real>(exact(r) * growth.factor));
    by_factor.push_back(query);
    query[finder.radius()] = std::min(finder.greatest(), rounded_up_to<Real>(exact(r) + growth.amount));
    by_amount.push_back(query);
  }
  if (separated.empty()) return;
  const auto count = [&](const QueryBatch<Real>& grown, std::uint64_t MarginPart::*phantoms,
                         std::uint64_t MarginPart::*missed) {
    Reply<Real> reply;
    ask(batch.kernel(0), grown.columns(), reply);
    for (std::size_t k = 0; k < separated.size(); ++k) {
      MarginPart& part = found.parts[separated[k].scene];
      if (separated[k].right == Verdict::separated) part.*phantoms += reply.verdicts[k] == Verdict::contact;
      else part.*missed += reply.verdicts[k] == Verdict::separated;
    }
  };
  count(by_factor, &MarginPart::phantoms_by_factor, &MarginPart::still_missed_by_factor);
  count(by_amount, &MarginPart::phantoms_by_amount, &MarginPart::still_missed_by_amount);
}

template <class Real>
SafeMargin margin_of(const SafeMarginPlan& plan, const std::atomic<bool>& interrupted, const ShowProgress& report) {
  SafeMargin margin{plan.precision};
  {
    const Implementation<Real> kernel = plan.kernel->on<Real>(plan.on->target);
    MarginFinder<Real> finder(plan, kernel, margin);
    for (const StoredQuery& stored : plan.found) {
      if (const auto* query = std::get_if<Numbers<Real>>(&stored.numbers))
        finder.add_if_missed(*query, "search", stored.id, margin.found);
    }
  }
  JudgedPlan judged;
  judged.sources = plan.asked->sources;
  for (const SourcePtr& source : judged.sources) judged.trials.push_back(plan.queries(*source));
  judged.seed = plan.asked->seed;
  judged.block_size = margin_block;
  judged.batch_size = margin_batch;
  judged.kernels = {plan.kernel};
  judged.target = plan.on->target;
  judged.by_filters = true;
  judged.second_opinion_stride = 0;
  judged.threads = plan.on->threads;
  judged.interrupted = &interrupted;
  const auto add = [&](std::string_view stage, const auto& visit) {
    const auto in_order = [](SafeMargin& all, const SafeMargin& later) { merge_fields(all, later); };
    const auto found = for_each_judged<Real>(judged, SafeMargin{plan.precision}, report, stage, visit, in_order);
    merge_fields(margin, found.counts);
    margin.complete &= found.complete;
  };
  add("the radius that each missed contact needs",
      [&](JudgedBatch<Real>& batch, SafeMargin& found) { find_in(plan, batch, found); });
  if (!margin.factor && !margin.amount) return margin;
  const Growths growths = growths_of(margin);
  add("the queries again with r grown",
      [&](JudgedBatch<Real>& batch, SafeMargin& found) { grow_in(plan, growths, batch, found); });
  return margin;
}

}  // namespace

template <class Real>
Real rounded_up_to(const Rational& value) {
  constexpr Real greatest = std::numeric_limits<Real>::max();
  const Real at = nearest<Real>(value);
  if (!(at < greatest)) return greatest;
  return exact(at) >= value ? at : std::nextafter(at, greatest);
}
template float rounded_up_to<float>(const Rational& value);
template double rounded_up_to<double>(const Rational& value);

MarginPart SafeMargin::total() const {
  MarginPart all;
  for (const auto& [scene, part] : parts) merge_fields(all, part);
  all.factor = all.amount = {};
  return all;
}

bool has_sphere_radius(const Predicate& predicate, std::size_t entry) {
  const std::optional<CriticalLength> length = oracles_of(predicate, entry).critical_length();
  return length && length->centre;
}

SafeMargin safe_margin(const SafeMarginPlan& plan, const std::atomic<bool>& interrupted, const ShowProgress& report) {
  return plan.precision == Precision::binary32 ? margin_of<float>(plan, interrupted, report)
                                               : margin_of<double>(plan, interrupted, report);
}

}  // namespace axiscert
