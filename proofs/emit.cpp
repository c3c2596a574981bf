#include "proofs/emit.h"

#include <fmt/format.h>

#include <algorithm>

namespace axiscert::proofs {
std::string program_path(std::string_view name) { return fmt::format("programs/{}.txt", name); }

Files proof_files() {
  Files all;
  all.merge(coq_files());
  all.merge(gappa_files());
  all.merge(range_files());
  all.merge(header_files());
  all.merge(fpcore_files());
  all.merge(latex_files());
  all.merge(certified_files());
  all.merge(block_files());
  return all;
}

namespace {

std::string bound(const Text& operand, int least) {
  return operand.binding >= least ? operand.text : "(" + operand.text + ")";
}

Text written(const Step& step, const Notation& notation, const std::vector<Text>& operands) {
  const auto operand = [&](std::size_t k) { return operands[k]; };
  const auto rounded = [&](Text t) {
    return notation.round.empty() ? t : Text{notation.round + "(" + t.text + ")", 3};
  };
  const auto product = [&] { return bound(operand(0), 2) + notation.times + bound(operand(1), 3); };
  switch (step.operation) {
    case Operation::input:
      return {notation.name(step.name), 3};
    case Operation::zero:
      return {"0", 3};
    case Operation::negate:
      return {"(-" + bound(operand(0), 3) + ")", 3};
    case Operation::add:
      return rounded({bound(operand(0), 1) + " + " + bound(operand(1), 2), 1});
    case Operation::subtract:
      return rounded({bound(operand(0), 1) + " - " + bound(operand(1), 2), 1});
    case Operation::multiply:
      return rounded({product(), 2});
    case Operation::fused:
      return rounded({product() + " + " + bound(operand(2), 2), 1});
  }
  return {};
}

}  // namespace

InfixProgram infix(const Program& program, const std::vector<std::size_t>& results, const Notation& notation) {
  return with_definitions(program, results, notation.name, [&](const Step& step, const std::vector<Text>& operands) {
    return written(step, notation, operands);
  });
}

InfixProgram with_definitions(const Program& program, const std::vector<std::size_t>& results, const NameWriter& name,
                              const StepWriter& write) {
  const auto& steps = program.steps();
  const std::vector<std::size_t> needed = program.needed_by(results);
  std::vector<int> uses(steps.size());
  for (const std::size_t i : needed) {
    for (std::size_t k = 0; k < operand_count(steps[i].operation); ++k) ++uses[steps[i].operands[k]];
  }
  InfixProgram text;
  std::vector<Text> texts(steps.size());
  for (const std::size_t i : needed) {
    std::vector<Text> operands;
    for (std::size_t k = 0; k < operand_count(steps[i].operation); ++k) operands.push_back(texts[steps[i].operands[k]]);
    texts[i] = write(steps[i], operands);
    const bool computes = operand_count(steps[i].operation) > 0;
    const bool shared = steps[i].operation != Operation::negate && uses[i] > 1;
    if (!computes || uses[i] == 0 || (steps[i].name.empty() && !shared)) continue;
    const std::string defined = name(steps[i].name.empty() ? "t" + std::to_string(i) : steps[i].name);
    text.definitions.push_back({defined, texts[i].text});
    texts[i] = {defined, 3};
  }
  for (const std::size_t result : results) text.results.push_back(texts[result].text);
  return text;
}

}  // namespace axiscert::proofs
