// Every mutant of a base, enumerated from its operations, comparisons and axes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "kernel/base/error.h"
#include "kernel/mutants/forms.h"
#include "kernel/mutants/mutant.h"

namespace axiscert::mutants {
namespace {

std::string dashed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

struct FaultDescription {
  std::string name, what;
};
template <class Fault>
FaultDescription described(Fault fault) {
#define AXISCERT_DESCRIBED(name, what) {#name, what},
  static const std::vector<FaultDescription> operations = {AXISCERT_OPERATION_FAULTS(AXISCERT_DESCRIBED)};
  static const std::vector<FaultDescription> comparisons = {AXISCERT_COMPARISON_FAULTS(AXISCERT_DESCRIBED)};
  static const std::vector<FaultDescription> kernels = {AXISCERT_KERNEL_FAULTS(AXISCERT_DESCRIBED)};
#undef AXISCERT_DESCRIBED
  const auto i = index_of(fault);
  if constexpr (std::is_same_v<Fault, OperationFault>) return operations[i];
  else if constexpr (std::is_same_v<Fault, ComparisonFault>) return comparisons[i];
  else return kernels[i];
}

class List {
 public:
  explicit List(std::size_t base) : base_(bases[base]), operations_(operations_of(base)) {
    const Predicate& predicate = predicate_of(base);
    for (std::size_t i = 0; i < operations_.all.size(); ++i) add_operation(i);
    for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
      for (const ComparisonFault fault :
           {ComparisonFault::strictness, ComparisonFault::reverse, ComparisonFault::always, ComparisonFault::epsilon,
            ComparisonFault::slack, ComparisonFault::flush}) {
        Mutant& m = add(fault, std::string(predicate.comparisons[i].name), "");
        m.comparison = fault;
        m.place = i;
      }
    }
    for (std::size_t i = 0; i < predicate.clauses.size(); ++i)
      add_kernel(KernelFault::drop, std::string(predicate.clauses[i].name), i);
    for (const Verdict verdict : {Verdict::contact, Verdict::separated}) {
      Mutant& m = add_kernel(KernelFault::small_area, std::string(name(verdict)), index_of(verdict));
      m.operation.kept = operations_.squared_normal;
    }
    for (std::size_t lane = 0; lane < 8; ++lane) add_kernel(KernelFault::lane, std::to_string(lane), lane);
    for (const std::size_t width : {2, 4, 8, 16}) add_kernel(KernelFault::tail, std::to_string(width), width);
    add_kernel(KernelFault::ftz, "all", 0);
  }
  std::vector<Mutant> take() { return std::move(all_); }

 private:
  template <class Fault>
  Mutant& add(Fault fault, const std::string& place, const std::string& text) {
    Mutant m;
    const auto [fault_name, what] = described(fault);
    m.fault = dashed(fault_name);
    m.what = what;
    m.id = fmt::format("{}~{}:{}", base_, m.fault, place);
    m.where = text.empty() ? place : place + ": " + text;
    return all_.emplace_back(std::move(m));
  }
  Mutant& add_kernel(KernelFault fault, const std::string& place, std::size_t value) {
    Mutant& m = add(fault, place, "");
    m.kernel = fault;
    m.place = value;
    return m;
  }

  void add_operation(std::size_t number) {
    using enum OperationFault;
    const Operation& operation = operations_.all[number];
    const auto plant = [&](OperationFault fault) -> Mutant& {
      Mutant& m = add(fault, std::to_string(number), operation.text);
      m.operation.fault = fault;
      m.operation.at = operation.key;
      return m;
    };
    const bool is_product = operation.op == Operator::times, is_square = operation.left == operation.right;
    plant(operator_);
    plant(operation.op == Operator::minus ? swap_ : sign_);
    plant(left_);
    if (!is_square) plant(right_);
    if (is_product) {
      replace(plant, operation.left, index_left_, vertex_left_);
      if (!is_square) replace(plant, operation.right, index_right_, vertex_right_);
    } else {
      plant_fma(plant, operation);
    }
    plant(float_).in_binary32 = false;
  }

  // A sum or difference is contracted with the one product in it. Of two products compilers take either; here it is the
  // right one, as g++ does in x y - z w.
  template <class Plant>
  void plant_fma(const Plant& plant, const Operation& operation) {
    const auto is_product = [&](Key key) {
      const Operation* found = operations_.find(key);
      return found && found->op == Operator::times;
    };
    const bool right = is_product(operation.right);
    if (!right && !is_product(operation.left)) return;
    Mutant& m = plant(OperationFault::fma_);
    m.operation.kept = right ? operation.right : operation.left;
    m.operation.product_is_left = !right;
  }

  // Replaces an operand that is a coordinate of a vector by another number.
  template <class Plant>
  void replace(const Plant& plant, Key operand, OperationFault index, OperationFault vertex) {
    const auto& vectors = operations_.vectors;
    for (std::size_t v = 0; v < vectors.size(); ++v) {
      const auto place = std::find(vectors[v].begin(), vectors[v].end(), operand);
      if (place == vectors[v].end()) continue;
      const std::size_t coordinate = static_cast<std::size_t>(place - vectors[v].begin());
      plant(index).operation.kept = vectors[v][(coordinate + 1) % 3];
      if (v < 3) plant(vertex).operation.kept = vectors[(v + 1) % 3][coordinate];
      return;
    }
  }

  std::string base_;
  const Operations& operations_;
  std::vector<Mutant> all_;
};

const std::vector<Mutant>& list_of(std::size_t base) {
  static const std::array<std::vector<Mutant>, bases.size()> lists = {List(0).take(), List(1).take(), List(2).take()};
  return lists[base];
}

}  // namespace

std::size_t base_index(std::string_view base) {
  const auto found = std::find(bases.begin(), bases.end(), base);
  if (found == bases.end()) {
    const std::vector<std::string_view> known(bases.begin(), bases.end());
    throw Error(fmt::format("'{}' is not a kernel that mutants are made of{} such kernels: {}", base,
                            did_you_mean(base, known), fmt::join(bases, ", ")));
  }
  return static_cast<std::size_t>(found - bases.begin());
}
std::size_t base_of(const Mutant& mutant) { return base_index(mutant.id.substr(0, mutant.id.find('~'))); }
const Predicate& predicate_of(std::size_t base) {
  return with_form(base, [](auto form) -> const Predicate& { return form.predicate(); });
}

std::span<const Mutant> mutants_of(std::string_view base) { return list_of(base_index(base)); }

std::string_view base_for(const Predicate& predicate) {
  for (std::size_t base = 0; base < bases.size(); ++base) {
    if (&predicate_of(base) == &predicate) return bases[base];
  }
  throw Error(fmt::format("no kernel of the predicate {} is one that mutants are made of; such kernels: {}",
                          predicate.id, fmt::join(bases, ", ")));
}

const Mutant& find_mutant(std::string_view id) {
  const std::span<const Mutant> all = mutants_of(id.substr(0, id.find('~')));
  const auto found = std::find_if(all.begin(), all.end(), [&](const Mutant& m) { return m.id == id; });
  if (found != all.end()) return *found;
  if (const Mutant* of_value = find_value_mutant(id)) return *of_value;
  std::vector<std::string_view> faults;
  for (const Mutant& m : all) {
    if (std::find(faults.begin(), faults.end(), m.fault) == faults.end()) faults.push_back(m.fault);
  }
  const std::vector<std::string> of_values = value_fault_names();
  for (const std::string& fault : of_values) faults.push_back(fault);
  const std::size_t tilde = id.find('~');
  const std::string_view place = tilde == id.npos ? std::string_view() : id.substr(tilde + 1);
  const std::string_view fault = place.substr(0, place.find(':'));
  const bool is_known = std::find(faults.begin(), faults.end(), fault) != faults.end();
  throw Error(fmt::format(
      "unknown mutant '{}'{} it is BASE~FAULT:PLACE, as in {}, or BASE~FAULT:PLACE:E; faults: {}; `axiscert "
      "mutate --list` has all",
      id, is_known ? ";" : did_you_mean(fault, faults), all.front().id,
      fmt::join(most_alike_first(fault, faults), ", ")));
}

}  // namespace axiscert::mutants
