#include "reports/wording/causes.h"

#include <fmt/format.h>

#include "fuzz/slack/slack.h"
#include "fuzz/text/json.h"
#include "kernel/predicate.h"

namespace axiscert {

std::string cause_sentence(const KernelRecord& kernel) {
  std::string sentence;
  if (kernel.slack && !kernel.slack->found.empty()) {
    const std::vector<SlackRecord>& found = kernel.slack->found;
    sentence = slack_text(found.front());
    if (found.size() > 1) sentence += fmt::format(", as queries of {} more kinds show", found.size() - 1);
  }
  // Beside a slack, a class that is none says nothing.
  if (kernel.cause && (sentence.empty() || kernel.cause->is_known))
    sentence += (sentence.empty() ? "" : "; ") + kernel.cause->sentence();
  return sentence;
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

}  // namespace axiscert
