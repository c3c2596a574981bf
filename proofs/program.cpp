#include "proofs/program.h"

#include <algorithm>
#include <stdexcept>

namespace axiscert::proofs {

std::size_t Program::input(std::string name) {
  steps_.push_back({Operation::input, {}, std::move(name)});
  return steps_.size() - 1;
}

std::size_t Program::step(Operation operation, std::array<std::size_t, 3> operands) {
  const auto same = [&](const Step& s) { return s.operation == operation && s.operands == operands; };
  const auto found = std::find_if(steps_.begin(), steps_.end(), same);
  const auto index = static_cast<std::size_t>(found - steps_.begin());
  if (found == steps_.end()) steps_.push_back({operation, operands, {}});
  return index;
}

void Program::name(std::size_t step, const std::string& name) {
  if (steps_[step].name.empty()) steps_[step].name = name;
}

std::size_t Program::named(const std::string& name) const {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (steps_[i].name == name) return i;
  }
  throw std::logic_error("the recorded program has no " + name);
}

std::vector<std::size_t> Program::needed_by(const std::vector<std::size_t>& results) const {
  std::vector<bool> needed(steps_.size());
  for (const std::size_t result : results) needed[result] = true;
  for (std::size_t i = steps_.size(); i-- > 0;) {
    if (!needed[i]) continue;
    for (std::size_t k = 0; k < operand_count(steps_[i].operation); ++k) needed[steps_[i].operands[k]] = true;
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (needed[i]) order.push_back(i);
  }
  return order;
}

std::string identifier(Comparison which) {
  std::string name(info(which).name);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

}  // namespace axiscert::proofs
