#include "reports/formats/witness_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "fuzz/text/number_text.h"
#include "kernel/names.h"
#include "kernel/predicate.h"
#include "reports/run_folder/record_checks.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr double greatest_ordinary = 0x1p20, least_ordinary_length = 0x1p-20;

bool is_ordinary_number(const std::string& text, Precision precision, Role role) {
  const auto within = [role](auto x) {
    const double size = std::fabs(static_cast<double>(x));
    return x == 0 ||
           (std::isnormal(x) && size <= greatest_ordinary && (role != Role::length || size >= least_ordinary_length));
  };
  return precision == Precision::binary32 ? within(parse_number<float>(text)) : within(parse_number<double>(text));
}

const FlipRecord* verdict_flip(const WitnessRecord& witness) {
  for (const FlipRecord& flip : witness.flips) {
    if (flip.level == Level::verdict) return &flip;
  }
  return nullptr;
}

// Where a witness stands in the page: the lesser the earlier.
using PagePlace = std::tuple<int, bool, double>;

PagePlace page_place_of(const WitnessRecord& witness, const PlanRecord& plan, bool is_first_of_its_cause) {
  const int part = is_first_of_its_cause ? 0 : verdict_flip(witness) != nullptr ? 1 : 2;
  return {part, !is_ordinary(witness, plan), -witness.depth.value_or(-1)};
}

// The digits of its numbers, in their shortest decimal form.
std::size_t digits_of(const WitnessRecord& witness) {
  std::size_t digits = 0;
  for (const auto& [group, numbers] : witness.numbers) {
    for (const std::string& number : numbers.numbers) {
      digits += witness.precision == Precision::binary32 ? fmt::formatted_size("{}", parse_number<float>(number))
                                                         : fmt::formatted_size("{}", parse_number<double>(number));
    }
  }
  return digits;
}

// One witness of each cause: an ordinary one where there is one, the shortest of these.
std::set<const WitnessRecord*> firsts_of_causes(const Record& record) {
  using Cause = std::tuple<std::string, Precision, FlipKind, std::vector<Link>, std::optional<InputClass>>;
  using Shortness = std::tuple<bool, std::size_t, double>;
  std::map<Cause, std::pair<Shortness, const WitnessRecord*>> first;
  for (const WitnessRecord& witness : record.witnesses) {
    const FlipRecord* flip = verdict_flip(witness);
    if (flip == nullptr) continue;
    const Shortness place = {!is_ordinary(witness, record.plan), digits_of(witness), -witness.depth.value_or(-1)};
    const auto [found, is_new] = first.try_emplace(
        {witness.kernel, witness.precision, flip->kind, flip->links, witness.input_class}, place, &witness);
    if (!is_new && place < found->second.first) found->second = {place, &witness};
  }
  std::set<const WitnessRecord*> all;
  for (const auto& [cause, one] : first) all.insert(one.second);
  return all;
}

}  // namespace

bool is_ordinary(const WitnessRecord& witness, const PlanRecord& plan) {
  const PredicateEntry& entry = *entry_of(predicate_of(plan), witness);
  for (const ColumnGroup& group : groups_of(entry)) {
    const Role role = entry.columns[group.first].role;
    for (const std::string& number : witness.numbers.at(group.name).numbers) {
      if (!is_ordinary_number(number, witness.precision, role)) return false;
    }
  }
  return true;
}

std::vector<const WitnessRecord*> shown_witnesses(const Record& record, std::size_t limit,
                                                  const std::set<std::string>& named) {
  const std::set<const WitnessRecord*> firsts = firsts_of_causes(record);
  std::vector<const WitnessRecord*> chosen;
  std::set<const WitnessRecord*> taken;
  const auto take = [&](const WitnessRecord* witness) {
    if (chosen.size() < limit && taken.insert(witness).second) chosen.push_back(witness);
  };
  for (const WitnessRecord* witness : firsts) take(witness);
  for (const WitnessRecord& witness : record.witnesses) {
    if (named.contains(witness.id)) take(&witness);
  }
  for (const WitnessRecord* witness : worst_witnesses(record, limit / 2)) take(witness);
  std::set<std::tuple<std::string, Precision, std::string, std::string, FlipKind, bool>> places;
  const auto opens_a_place = [&](const WitnessRecord& witness) {
    bool opens = false;
    for (const FlipRecord& flip : witness.flips) {
      opens |= places.insert({witness.kernel, witness.precision, witness.family, flip.name, flip.kind, flip.decisive})
                   .second;
    }
    return opens;
  };
  for (const WitnessRecord* witness : chosen) opens_a_place(*witness);
  for (const WitnessRecord& witness : record.witnesses) {
    if (chosen.size() >= limit) break;
    if (!taken.contains(&witness) && opens_a_place(witness)) take(&witness);
  }
  for (const WitnessRecord* witness : worst_witnesses(record, limit)) take(witness);
  std::vector<std::pair<PagePlace, const WitnessRecord*>> placed;
  for (const WitnessRecord* witness : chosen)
    placed.emplace_back(page_place_of(*witness, record.plan, firsts.contains(witness)), witness);
  std::stable_sort(placed.begin(), placed.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  std::transform(placed.begin(), placed.end(), chosen.begin(), [](const auto& one) { return one.second; });
  return chosen;
}

}  // namespace axiscert
