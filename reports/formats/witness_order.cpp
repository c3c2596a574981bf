#include "reports/formats/witness_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "fuzz/text/number_text.h"
#include "kernel/names.h"
#include "kernel/test.h"
#include "reports/run_folder/record_names.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr double greatest_ordinary = 0x1p20, least_ordinary_length = 0x1p-20;

bool is_ordinary_number(const Json& number, bool is_binary32, Role role) {
  const std::string text = number;
  const auto within = [role](auto x) {
    const double size = std::fabs(static_cast<double>(x));
    return x == 0 ||
           (std::isnormal(x) && size <= greatest_ordinary && (role != Role::length || size >= least_ordinary_length));
  };
  return is_binary32 ? within(parse_number<float>(text)) : within(parse_number<double>(text));
}

const Json* verdict_flip(const Json& witness) {
  for (const Json& flip : witness["flips"]) {
    if (flip["level"] == "verdict") return &flip;
  }
  return nullptr;
}

double depth_of(const Json& witness) { return witness["depth"].is_null() ? -1.0 : witness["depth"].get<double>(); }

// Where a witness stands in the page: the lesser the earlier.
using PagePlace = std::tuple<int, bool, double>;

PagePlace page_place_of(const Json& witness, const Json& plan, bool is_first_of_its_cause) {
  const int part = is_first_of_its_cause ? 0 : verdict_flip(witness) != nullptr ? 1 : 2;
  return {part, !is_ordinary(witness, plan), -depth_of(witness)};
}

// One witness of each cause: an ordinary one where there is one, the deepest of these.
std::set<const Json*> firsts_of_causes(const Json& record) {
  std::map<std::string, std::pair<PagePlace, const Json*>> first;
  for (const Json& witness : record["witnesses"]) {
    const Json* flip = verdict_flip(witness);
    if (flip == nullptr) continue;
    const std::string cause =
        Json{witness["kernel"], witness["precision"], (*flip)["kind"], (*flip)["links"], witness.value("class", "")}
            .dump();
    const PagePlace place = page_place_of(witness, record["plan"], true);
    const auto [found, is_new] = first.try_emplace(cause, place, &witness);
    if (!is_new && place < found->second.first) found->second = {place, &witness};
  }
  std::set<const Json*> all;
  for (const auto& [cause, one] : first) all.insert(one.second);
  return all;
}

}  // namespace

bool is_ordinary(const Json& witness, const Json& plan) {
  const TestEntry& entry = *entry_of(test_of(plan), witness);
  const bool is_binary32 = witness["precision"] == name(Precision::binary32);
  for (const ColumnGroup& group : groups_of(entry)) {
    const Json& numbers = witness[std::string(group.name)];
    const Role role = entry.columns[group.first].role;
    if (numbers.is_string() && !is_ordinary_number(numbers, is_binary32, role)) return false;
    if (numbers.is_string()) continue;
    for (const Json& number : numbers) {
      if (!is_ordinary_number(number, is_binary32, role)) return false;
    }
  }
  return true;
}

std::vector<const Json*> shown_witnesses(const Json& record, std::size_t limit, const std::set<std::string>& named) {
  const Json& plan = record["plan"];
  const std::set<const Json*> firsts = firsts_of_causes(record);
  std::vector<const Json*> chosen;
  std::set<const Json*> taken;
  const auto take = [&](const Json* witness) {
    if (chosen.size() < limit && taken.insert(witness).second) chosen.push_back(witness);
  };
  for (const Json* witness : firsts) take(witness);
  for (const Json& witness : record["witnesses"]) {
    if (named.contains(witness["id"].get<std::string>())) take(&witness);
  }
  for (const Json* witness : worst_witnesses(record, limit / 2)) take(witness);
  std::set<std::string> places;
  const auto opens_a_place = [&](const Json& witness) {
    bool opens = false;
    for (const Json& flip : witness["flips"]) {
      opens |= places
                   .insert(Json{witness["kernel"], witness["precision"], witness["family"], flip["name"], flip["kind"],
                                flip["decisive"]}
                               .dump())
                   .second;
    }
    return opens;
  };
  for (const Json* witness : chosen) opens_a_place(*witness);
  for (const Json& witness : record["witnesses"]) {
    if (chosen.size() >= limit) break;
    if (!taken.contains(&witness) && opens_a_place(witness)) take(&witness);
  }
  for (const Json* witness : worst_witnesses(record, limit)) take(witness);
  std::vector<std::pair<PagePlace, const Json*>> placed;
  for (const Json* witness : chosen)
    placed.emplace_back(page_place_of(*witness, plan, firsts.contains(witness)), witness);
  std::stable_sort(placed.begin(), placed.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  std::transform(placed.begin(), placed.end(), chosen.begin(), [](const auto& one) { return one.second; });
  return chosen;
}

}  // namespace axiscert
