#include "reports/wording/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <tuple>

#include "fuzz/text/json.h"
#include "fuzz/text/merge.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

// Number of queries that can count as a failure: valid, and within the kernel's limits.
std::uint64_t valid_queries(const FamilyCounts& family) {
  const std::optional<OutsideTally>& outside = family.verdict.outside_limits;
  return family.trials - family.truth.invalid - (outside ? outside->trials : 0);
}

// The six digits of a text of a number too large for binary64 are kept by the logarithm.
double magnitude(const Json& number) {
  if (number.is_number()) return std::log10(number.get<double>());
  const auto& text = number.get_ref<const std::string&>();
  const std::size_t e = text.find('e');
  double mantissa = 0, exponent = 0;
  std::from_chars(text.data(), text.data() + e, mantissa);
  std::from_chars(text.data() + e + 2, text.data() + text.size(), exponent);
  return exponent + std::log10(mantissa);
}

}  // namespace

const EnumArray<Link, CauseWords> link_words = {{
    {"The formulae are wrong even in exact arithmetic: no precision mends it.",
     "The formulae are wrong over the reals: take others, as those of `nonstrict` or `reduced-along-nonstrict`.",
     "docs/precision.md#the-reduced-rung"},
    {"Rounding each operation to the precision changed the answer, exponents unlimited.",
     "Let r grow by the safe margin, or take a form that rounds less, or libaxiscert.",
     "docs/precision.md#the-reduced-rung"},
    {"Overflow or underflow changed the answer: with unlimited exponents it would not have.",
     "Bring the scene to a unit of length in which nothing over- or underflows.",
     "docs/error_model.md#units-of-length"},
    {"The kernel differs from the scalar reference of its own formulae and order of operations.",
     "The code does not compute its own formulae: compare it, `axiscert check`, with the reference.",
     "docs/error_model.md#the-chain"},
    {"The kernel has no reference to compare it with: which link its own arithmetic breaks between the exact formulae, "
     "or "
     "the truth where it claims none, and its answer is not known.",
     "Compare the verdict with the exact one: `axiscert check` the witness.", "docs/error_model.md#the-chain"},
}};

std::optional<FamilyRecord> all_families(const KernelRecord& kernel) {
  if (kernel.families.empty()) return std::nullopt;
  FamilyRecord total;
  FamilyCounts& counts = total;
  counts = kernel.families[0];
  for (std::size_t i = 1; i < kernel.families.size(); ++i) merge_fields<FamilyCounts>(counts, kernel.families[i]);
  total.critical_radius = kernel.critical_radius;
  return total;
}

std::string interrupted_text(const Record& record) {
  const PlanRecord& plan = record.plan;
  const auto sum = [&](const CountsByFamily& counts) {
    std::uint64_t all = 0;
    for (const auto& [family, by_precision] : counts) {
      for (const Precision precision : plan.precisions) {
        const auto count = by_precision.find(precision);
        if (count != by_precision.end()) all += count->second;
      }
    }
    return all;
  };
  const std::string of = plan.planned ? fmt::format(" of {}", thousands(sum(*plan.planned))) : "";
  return fmt::format("interrupted after {}{} queries", thousands(sum(plan.trials)), of);
}

double per_million(std::uint64_t count, const FamilyCounts& family) {
  const std::uint64_t n = valid_queries(family);
  return n == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(n);
}

std::string unquoted_text(const Json& value) {
  return value.is_null() ? "-" : value.is_string() ? value.get<std::string>() : value.dump();
}

std::string thousands(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3)
    text.insert(static_cast<std::size_t>(i), 1, ',');
  return text;
}

std::string share_rounded_down(std::uint64_t part, std::uint64_t of) {
  if (part == 0) return "none";
  const auto tenths = static_cast<std::uint64_t>(1000 * static_cast<long double>(part) / static_cast<long double>(of));
  if (tenths == 0) return "less than 0.1 %";
  return tenths % 10 == 0 ? fmt::format("{} %", tenths / 10) : fmt::format("{}.{} %", tenths / 10, tenths % 10);
}

void add_count(std::vector<std::string>& words, std::uint64_t count, std::string_view what) {
  if (count != 0) words.push_back(fmt::format("{} {}", thousands(count), what));
}

std::vector<std::string> no_verdict_words(const NoVerdict& counts, std::string_view declined) {
  std::vector<std::string> words;
  add_count(words, counts.declined, declined);
  add_count(words, counts.invalid, "called invalid");
  add_count(words, counts.unanswered, "without an answer");
  return words;
}

std::string amount(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (value < 1000 || value >= 1e15) return text;
  double rounded = 0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  const std::size_t point = text.find('e') == text.npos ? text.find('.') : text.npos;
  return thousands(static_cast<std::uint64_t>(rounded)) + (point == text.npos ? "" : text.substr(point));
}

std::string error_amount(const std::optional<Decimal6>& error) {
  if (!error) return "not measured";
  const double value = error->value();
  return std::isfinite(value) ? amount(value) : error->text();
}

std::string error_amount(const Json& figure) {
  if (figure.is_null()) return "not measured";
  return figure.is_number() ? amount(figure.get<double>()) : figure.get<std::string>();
}

bool is_less(const Json& x, const Json& y) {
  if (x.is_number() && y.is_number()) return x.get<double>() < y.get<double>();
  return magnitude(x) < magnitude(y);
}

std::string touching_text(const KernelRecord& kernel) {
  switch (kernel.touching) {
    case TouchingPolicy::contact:
      break;
    case TouchingPolicy::separated:
      return "a touching sphere is separated";
    case TouchingPolicy::either:
      return "a touching sphere may be called either";
  }
  return "a touching sphere is in contact";
}

namespace {

// The part of its promise about motions that the kernel leaves out.
void add_policy(const KernelRecord& kernel, std::vector<std::string>& parts) {
  if (!kernel.motion) return;
  const PolicyRecord& policy = *kernel.motion;
  if (policy.start == StartPolicy::ignored) parts.emplace_back("no contact before the motion");
  if (policy.start == StartPolicy::approaching) parts.emplace_back("no contact before a motion that does not approach");
  if (policy.still == StillPolicy::ignored) parts.emplace_back("a displacement that is not zero");
  if (policy.sides == SidesPolicy::front) parts.emplace_back("triangles met from the front");
}

// The witness's place among those of its kernel, precision, family and kinds of wrong verdict.
using WitnessGroup = std::tuple<std::string, Precision, std::string, std::vector<FlipKind>>;

WitnessGroup group_of(const WitnessRecord& witness) {
  std::vector<FlipKind> kinds;
  for (const FlipRecord& flip : witness.flips) {
    if (flip.level == Level::verdict) kinds.push_back(flip.kind);
  }
  return {witness.kernel, witness.precision, witness.family, kinds};
}

}  // namespace

std::string limits_text(const KernelRecord& kernel) {
  if (!has_limits(kernel)) return "none: it promises to be right everywhere";
  std::vector<std::string> parts;
  add_policy(kernel, parts);
  if (!kernel.limits) return fmt::format("{}", fmt::join(parts, ", "));
  const LimitsRecord& limits = *kernel.limits;
  const auto range = [&](const std::string& what, std::optional<double> least, std::optional<double> greatest) {
    std::string part = what;
    if (least) part += fmt::format(" from {:.6g}", *least);
    if (greatest) part += fmt::format(" to {:.6g}", *greatest);
    if (part != what) parts.push_back(part);
  };
  range("|coordinates|", limits.least_coordinate, limits.greatest_coordinate);
  range("area", limits.least_area, std::nullopt);
  range("radius", limits.least_radius, limits.greatest_radius);
  if (limits.margin) parts.push_back(fmt::format("contact, or apart by more than a margin of {:.6g}", *limits.margin));
  if (limits.sides == SidesPolicy::front) parts.emplace_back("in front of the triangle");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<const WitnessRecord*> worst_witnesses(const Record& record, std::size_t limit) {
  std::vector<const WitnessRecord*> witnesses;
  for (const WitnessRecord& witness : record.witnesses) witnesses.push_back(&witness);
  const auto deeper = [](const WitnessRecord* x, const WitnessRecord* y) { return x->depth > y->depth; };
  std::stable_sort(witnesses.begin(), witnesses.end(), deeper);

  std::map<WitnessGroup, std::size_t> seen;
  std::map<const WitnessRecord*, std::size_t> rank;
  for (const WitnessRecord* w : witnesses) rank[w] = seen[group_of(*w)]++;
  std::stable_sort(witnesses.begin(), witnesses.end(),
                   [&](const WitnessRecord* x, const WitnessRecord* y) { return rank[x] < rank[y]; });
  witnesses.resize(std::min(limit, witnesses.size()));
  std::stable_sort(witnesses.begin(), witnesses.end(), deeper);
  return witnesses;
}

namespace {

std::string times(std::uint64_t count) { return count == 1 ? "once" : thousands(count) + " times"; }

bool are_alike(const FindingRecord& x, const FindingRecord& y) {
  return x.kernel == y.kernel && x.precision == y.precision && x.kind == y.kind;
}

}  // namespace

std::string finding_text(const FindingRecord& finding) {
  const std::string in = finding.precision ? fmt::format(" {}", name(*finding.precision)) : "";
  const std::string who = fmt::format("{}{}: {}", finding.kernel, in, name(finding.kind));
  if (!finding.family) return fmt::format("{}: {}", who, finding.detail);
  return fmt::format("{} on family {}, {}, first at {}: {}", who, *finding.family, times(finding.count),
                     finding.address.value_or(""), finding.detail);
}

std::string FindingGroup::others_text() const {
  std::vector<std::string> families;
  for (const FindingRecord* other : others) {
    families.push_back(fmt::format("{} ({})", other->family.value_or(""), times(other->count)));
  }
  return families.empty() ? "" : fmt::format("also on family {}", fmt::join(families, ", "));
}

std::vector<FindingGroup> finding_groups(const Record& record) {
  std::vector<FindingGroup> groups;
  for (const FindingRecord& finding : record.findings) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const FindingGroup& group) {
      return finding.family && are_alike(*group.first, finding);
    });
    if (same == groups.end()) groups.push_back({&finding, {}});
    else same->others.push_back(&finding);
  }
  return groups;
}

bool is_about(const FindingRecord& finding, const KernelRecord& kernel) {
  return finding.kernel == kernel.id && (!finding.precision || *finding.precision == kernel.precision);
}

std::vector<std::string> not_judged(const Record& record) {
  std::vector<std::string> ids;
  for (const Name& id : record.plan.kernels) {
    const auto& entries = record.kernels;
    const bool judged = std::any_of(entries.begin(), entries.end(), [&](const KernelRecord& e) { return e.id == id; });
    if (!judged) ids.push_back(id);
  }
  return ids;
}

}  // namespace axiscert
