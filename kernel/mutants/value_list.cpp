#include "kernel/mutants/mutant.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <mutex>

#include "kernel/base/error.h"
#include "kernel/mutants/forms.h"

namespace axiscert::mutants {
namespace {

struct NamedFault {
  std::string name, what;
  ValueFault fault;
  bool is_relative;
};

std::vector<NamedFault> faults_of_values() {
  std::vector<NamedFault> all;
  const auto add = [&](ValueFault fault, std::string name, const std::string& what) {
    std::replace(name.begin(), name.end(), '_', '-');
    all.push_back({name, what, fault, false});
    all.push_back({name + "-relative", what, fault, true});
  };
#define AXISCERT_ADD(name, what) add(ValueFault::name, #name, what);
  AXISCERT_VALUE_FAULTS(AXISCERT_ADD)
#undef AXISCERT_ADD
  return all;
}

struct Place {
  std::string id, what, relative_to;
  Quantity quantity;
  std::size_t comparison = 0;  // of a side
};

// A side stands for all: of an edge's line, of an edge's other side, of a vertex.
template <class Form>
std::vector<Place> places_in() {
  std::vector<Place> made;
  const auto add = [&](Quantity quantity, std::string id, const std::string& what, const std::string& relative_to) {
    if (quantity != Quantity::side) {
      made.push_back({std::move(id), what, relative_to, quantity});
      return;
    }
    for (const std::size_t which : {Form::edge_radius, Form::edge_side, Form::vertex_radius}) {
      const std::string_view name = Form::predicate().comparisons[which].name;
      made.push_back({std::string(name), fmt::format("the left side of {}", name), relative_to, quantity, which});
    }
  };
#define AXISCERT_ADD(name, id, what, relative_to) add(Quantity::name, id, what, relative_to);
  AXISCERT_QUANTITIES(AXISCERT_ADD)
#undef AXISCERT_ADD
  return made;
}
const std::vector<Place>& places(std::size_t base) {
  return with_form(base, [](auto form) -> const std::vector<Place>& {
    static const std::vector<Place> all = places_in<decltype(form)>();
    return all;
  });
}

// A relative answer on the extent of a scene would be none at all, or always.
bool exists(const NamedFault& fault, const Place& place) {
  return !(place.quantity == Quantity::verdict &&
           (fault.fault == ValueFault::clamp || fault.fault == ValueFault::zero ||
            (fault.is_relative && answers_early(fault.fault))));
}

Mutant made(std::string_view base, const NamedFault& fault, const Place& place, double magnitude) {
  Mutant m;
  m.fault = fault.name;
  m.id = fmt::format("{}~{}:{}:{}", base, fault.name, place.id, magnitude);
  const bool is_of_itself =
      adds(fault.fault) && place.quantity != Quantity::side && place.quantity != Quantity::verdict;
  const std::string relative_to = is_of_itself ? "itself" : place.relative_to;
  m.where = fmt::format("{}, E = {}{}", place.what, magnitude, fault.is_relative ? " of " + relative_to : "");
  m.what = fault.what;
  m.value = fault.fault;
  m.quantity = place.quantity;
  m.place = place.comparison;
  m.magnitude = magnitude;
  m.is_relative = fault.is_relative;
  const Operations& operations = operations_of(base_index(base));
  const Key at = place.quantity == Quantity::squared_radius   ? operations.squared_radius
                 : place.quantity == Quantity::squared_edge   ? operations.squared_edge
                 : place.quantity == Quantity::squared_normal ? operations.squared_normal
                                                              : Key{0};
  if (at != 0) {
    m.operation.fault = OperationFault::value_;
    m.operation.at = at;
  }
  return m;
}

// Kernels keep references to their mutants.
const Mutant* kept(Mutant mutant) {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<const Mutant>, std::less<>> all;
  const std::lock_guard lock(mutex);
  auto& place = all[mutant.id];
  if (!place) place = std::make_unique<const Mutant>(std::move(mutant));
  return place.get();
}

}  // namespace

std::vector<std::string> value_fault_names() {
  std::vector<std::string> names;
  for (const NamedFault& fault : faults_of_values()) names.push_back(fault.name);
  return names;
}

const Mutant* find_value_mutant(std::string_view id) {
  const std::size_t tilde = id.find('~'), first = id.find(':', tilde), last = id.rfind(':');
  if (tilde == id.npos || first == id.npos || last == first) return nullptr;
  const std::string_view base = id.substr(0, tilde), fault_name = id.substr(tilde + 1, first - tilde - 1),
                         place_id = id.substr(first + 1, last - first - 1), number = id.substr(last + 1);
  double magnitude = 0;
  const char* const end = number.data() + number.size();
  const auto [stop, problem] = std::from_chars(number.data(), end, magnitude);
  if (problem != std::errc() || stop != end || !(magnitude > 0 && magnitude < 1e300)) return nullptr;
  for (const NamedFault& fault : faults_of_values()) {
    if (fault.name != fault_name) continue;
    for (const Place& place : places(base_index(base))) {
      if (place.id == place_id && exists(fault, place)) return kept(made(base, fault, place, magnitude));
    }
  }
  return nullptr;
}

std::vector<const Mutant*> value_mutants_of(std::string_view base, std::span<const double> magnitudes) {
  mutants_of(base);  // throws for what is no base
  std::vector<const Mutant*> all;
  for (const double magnitude : magnitudes) {
    if (!(magnitude > 0 && magnitude < 1e300))
      throw Error(fmt::format("magnitude {}: give a number above 0 and below 1e300, as in 1e-6", magnitude));
  }
  for (const NamedFault& fault : faults_of_values()) {
    for (const Place& place : places(base_index(base))) {
      if (!exists(fault, place)) continue;
      for (const double magnitude : magnitudes) all.push_back(kept(made(base, fault, place, magnitude)));
    }
  }
  return all;
}

}  // namespace axiscert::mutants
