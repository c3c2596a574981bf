#include "reports/wording/causes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "fuzz/confirm/slack.h"
#include "fuzz/record/wrong_verdicts.h"
#include "fuzz/text/json.h"
#include "kernel/predicate.h"
#include "reports/wording/summary.h"

namespace axiscert {

std::string compared_text(const AbsoluteSizeRecord& sizes) {
  std::vector<std::string> texts;
  for (const ComparedQuantity& size : sizes.compared) {
    const double near = std::sqrt(size.least) * std::sqrt(size.greatest);
    texts.push_back(fmt::format("near {} (squared {}) were compared with {}", amount(near, 4), amount(near * near, 4),
                                size.quantity));
  }
  return texts.empty() ? "" : fmt::format("as if an absolute number {}", fmt::join(texts, ", or one "));
}

NearestPowers nearest_powers(const CountsBySize& by_size) {
  NearestPowers found;
  for (const auto& [exponent, count] : by_size) {
    if (exponent < 0) found.down = exponent;
    else if (!found.up) found.up = exponent;
  }
  return found;
}

bool are_outer(const CountsBySize& by_size, const ImageChangesRecord& scale) {
  const auto [down, up] = nearest_powers(by_size);
  const std::optional<PowerRangeRecord> range = scale.range.value_or(std::nullopt);
  return range && (!down || 2 * *down <= range->least) && (!up || 2 * *up >= range->greatest);
}

namespace {

// The family with the most bases, among those with queries in other units of length: where in each of them one
// number explains nearly all of them. What may as well be the range of a form is no such number.
std::string number_text(const KernelRecord& kernel) {
  constexpr std::uint64_t least_bases = 16;
  const AbsoluteSizeRecord* most = nullptr;
  for (const auto& [name, family] : kernel.families) {
    if (!family.invariance) continue;
    const auto scale = family.invariance->find(ImageKind::scale);
    if (scale == family.invariance->end() || !scale->second.wrong) continue;
    if (are_outer(scale->second.wrong->by_size, scale->second)) continue;
    for (const AbsoluteSizeRecord* sizes : {&scale->second.wrong->where_small, &scale->second.wrong->where_large}) {
      if (sizes->bases < least_bases) continue;
      if (sizes->compared.empty() || 20 * sizes->compared.front().explains < 19 * sizes->bases) return "";
      if (most == nullptr || sizes->bases > most->bases) most = sizes;
    }
  }
  return most == nullptr ? "" : compared_text(*most);
}

struct SlackText {
  std::string text;
  bool is_local = false, is_late = false;  // on less than a quarter of the queries
};
SlackText slack_text_of(const KernelRecord& kernel) {
  if (!kernel.slack || kernel.slack->found.empty()) return {};
  const std::vector<SlackRecord>& found = kernel.slack->found;
  SlackText slack{slack_text(found.front())};
  if (found.size() > 1)
    slack.text += fmt::format(", and on {} other kind{} of query", found.size() - 1, found.size() == 2 ? "" : "s");
  std::uint64_t shown = 0;
  for (const SlackRecord& one : found) shown += one.shown;
  slack.is_local = 4 * shown < kernel.slack->bracketed;
  slack.is_late = found.front().side == SlackSide::late;
  return slack;
}

// Where no class is the cause: the axes at which it is decided, most often first; of a kernel that shows its verdicts
// alone, that these would be named.
std::string axes_text(const KernelRecord& kernel) {
  if (kernel.cause->is_known) return "";
  std::map<std::string, std::uint64_t> decisive;
  std::uint64_t all = 0;
  for (const auto& [name, family] : kernel.families) {
    if (!family.axes) return "a kernel that shows its comparisons is told which of them decide (docs/plugins.md)";
    for (const auto& [axis, tally] : *family.axes) {
      decisive[axis] += tally.decisive;
      all += tally.decisive;
    }
  }
  std::vector<std::pair<std::uint64_t, std::string>> often;
  for (const auto& [axis, count] : decisive)
    if (count * 20 >= all && count != 0) often.emplace_back(count, axis);
  std::ranges::sort(often, std::greater<>());
  std::vector<std::string> texts;
  for (const auto& [count, axis] : often) texts.push_back(fmt::format("{} {}", axis, thousands(count)));
  return texts.empty() ? "" : fmt::format("axes that decide wrongly: {}", fmt::join(texts, ", "));
}

}  // namespace

std::string cause_sentence(const KernelRecord& kernel) {
  const SlackText slack = slack_text_of(kernel);
  std::vector<std::string> texts;
  const auto add = [&](const std::string& text) {
    if (!text.empty()) texts.push_back(text);
  };
  if (!slack.is_local) add(slack.text);
  add(number_text(kernel));
  const bool is_class_first = slack.is_local && slack.is_late;
  if (!is_class_first && slack.is_local) add(slack.text);
  // Beside these, a class that is none says nothing.
  const bool is_said = kernel.cause && (kernel.cause->is_known || (texts.empty() && slack.text.empty()));
  if (is_said) add(kernel.cause->sentence());
  if (is_class_first) add(slack.text);
  if (is_said) add(axes_text(kernel));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string cause_line(const KernelRecord& kernel) {
  const std::string sentence = cause_sentence(kernel);
  return sentence.empty() ? "" : fmt::format("{} {}: {}", kernel.id, name(kernel.precision), sentence);
}

namespace {

// "a (0, 0, 0), b (1, 0, 0), r 2": the numbers by the groups of their entry; without names where it has others.
std::string numbers_text(const CauseWitness& witness, const PlanRecord& plan) {
  const Json query = Json::parse(static_cast<const std::string&>(witness.query));
  const PredicateEntry* entry = nullptr;
  for (const Predicate* predicate : predicates()) {
    if (predicate->id != plan.predicate) continue;
    for (const PredicateEntry& one : predicate->entries) {
      const bool is_named = !query.contains("entry") || query["entry"] == one.name;
      if (entry == nullptr && is_named && one.columns.size() == witness.numbers.size()) entry = &one;
    }
  }
  std::string text;
  const auto add = [&](std::string_view name, std::size_t first, std::size_t size) {
    std::string numbers;
    for (std::size_t k = first; k < first + size; ++k)
      numbers += (k == first ? "" : ", ") + static_cast<const std::string&>(witness.numbers[k]);
    if (size != 1) numbers = "(" + numbers + ")";
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, numbers);
  };
  if (entry == nullptr) {
    add("numbers", 0, witness.numbers.size());
  } else {
    for (const ColumnGroup& group : groups_of(*entry)) add(group.name, group.first, group.size);
  }
  return text;
}

}  // namespace

std::string cause_witness_line(const KernelRecord& kernel, const PlanRecord& plan) {
  if (!kernel.cause || !kernel.cause->witness) return "";
  const CauseWitness& witness = *kernel.cause->witness;
  return fmt::format("it says {}, and the truth is {}: {} ({})", name(witness.answered), name(witness.truth),
                     numbers_text(witness, plan), witness.address);
}

const EnumArray<InputClass, CauseWords> class_words = {{
    {"the sphere touches the triangle exactly: the last bit of any rounding decides",
     "Let r grow by the safe margin, or use a test that is right at the tie, as libaxiscert is.",
     "docs/certified.md#what-is-promised"},
    {"the depth is at most 64 u: rounding alone may explain it",
     "Rounding: let r grow by the safe margin, or use libaxiscert.", "docs/certified.md#what-is-promised"},
    {"a length is past the range in which formulae of degree 6 neither overflow nor underflow",
     "Bring the scene to a unit of length in which its numbers lie within the window of degree 6.",
     "docs/error_model.md#units-of-length"},
    {"two vertices of the triangle are equal",
     "Drop triangles with two equal vertices when the mesh is read, or take a test that is right on them.",
     "docs/precision.md#the-reduced-rung"},
    {"the three vertices are on a line: the triangle has no area",
     "Drop triangles without area when the mesh is read, or take a test that is right on them.",
     "docs/precision.md#the-reduced-rung"},
    {"the triangle is less than a thousandth as high as it is long",
     "Mend slivers when the mesh is read, or take a test with more precision for them.",
     "docs/precision.md#the-ladder"},
    {"the origin is at least 64 times as far away as the scene is long: the kernel loses digits of the coordinates",
     "Subtract an origin near the scene before the numbers are rounded to the test's precision.",
     "docs/precision.md#flips-caused-by-the-query-and-by-the-formula"},
    {"neither the shape, the place nor the scale of the input excuses it: look for a fault of logic, or for a constant "
     "such as an epsilon",
     "Look for a fault of logic, or an absolute number: `axiscert check` the witness, and `axiscert map` it.",
     "docs/error_model.md#the-class-of-the-input"},
}};

bool has_classes(const KernelRecord& kernel) {
  return std::any_of(kernel.families.begin(), kernel.families.end(),
                     [](const auto& family) { return family.second.classes.has_value(); });
}

std::vector<ClassRow> class_rows(const KernelRecord& kernel) {
  std::vector<ClassRow> rows;
  for (const InputClass which : enumerators<InputClass>) {
    ClassRow row{which, 0, 0, 0, "", ""};
    for (const auto& [family, result] : kernel.families) {
      if (!result.classes) continue;
      const auto found = result.classes->find(which);
      if (found == result.classes->end()) continue;
      const ClassRecord& of = found->second;
      row.missed += of.false_separation;
      row.phantom += of.false_contact;
      if (row.witness.empty() || of.deepest.best() > row.deepest) {
        row.deepest = of.deepest.best();
        row.family = family;
        row.witness = of.witness;
      }
    }
    if (row.missed + row.phantom != 0) rows.push_back(row);
  }
  return rows;
}

std::string nearest_sentence(const KernelRecord& kernel) {
  if (!kernel.nearest || !*kernel.nearest) return "";
  const NearestRecord& nearest = **kernel.nearest;
  return fmt::format(
      "{}{}, wrong on {} % of the queries on which either is ({} of {}, among {}: the first {} of each family and the "
      "deepest)",
      2 * nearest.both >= nearest.either ? "Nearest of the built-in kernels: "
                                         : "No built-in kernel fails alike; the nearest is ",
      nearest.kernel, amount(100 * static_cast<double>(nearest.both) / static_cast<double>(nearest.either), 3),
      thousands(nearest.both), thousands(nearest.either), thousands(nearest.queries), thousands(nearest_queries));
}

Json classes_data(const KernelRecord& kernel) {
  if (!has_classes(kernel)) return nullptr;
  Json rows = Json::array();
  for (const ClassRow& row : class_rows(kernel)) {
    rows.push_back({{"class", input_class_names[row.which]},
                    {"meaning", class_words[row.which].meaning},
                    {"missed", row.missed},
                    {"phantom", row.phantom},
                    {"deepest", row.deepest},
                    {"family", row.family},
                    {"witness", row.witness}});
  }
  return {{"rows", std::move(rows)}, {"nearest", nearest_sentence(kernel)}};
}

}  // namespace axiscert
