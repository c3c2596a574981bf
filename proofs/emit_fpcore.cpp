// The sides of every comparison as FPCores (FPBench's FPCore 2.0), in the kernel's operation order, for FPBench's tools
// and others (Herbie, Daisy, FPTaylor through its converters). The scaled domain is the precondition.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "proofs/emit.h"
#include "proofs/bounds.h"

namespace axiscert::proofs {
namespace {

constexpr std::string_view header =
    "; The sides of the comparisons of {}, {}, {}: FPCore 2.0.\n"
    "; Written by write_proofs from the formulae: do not edit. A side that is zero has no core.\n"
    "; The precondition is the scaled domain; times 2^k it is every other size.\n";

Text prefix(const Step& step, const std::vector<Text>& operands) {
  const auto call = [&](std::string_view operation) {
    std::string text = fmt::format("({}", operation);
    for (const Text& operand : operands) text += " " + operand.text;
    return Text{text + ")", 3};
  };
  switch (step.operation) {
    case Operation::input:
      return {step.name, 3};
    case Operation::zero:
      return {"0", 3};
    case Operation::negate:
    case Operation::subtract:
      return call("-");
    case Operation::add:
      return call("+");
    case Operation::multiply:
      return call("*");
    case Operation::fused:
      return call("fma");
  }
  return {};
}

// The precondition on the coordinates that these inputs translate, and on the radius.
std::string precondition(const std::vector<std::string>& inputs) {
  std::string text = "(and";
  for (const std::string& input : inputs) {
    if (input == "r") text += " (<= 0 r 1)";
    else if (input[0] != 'P') text += fmt::format(" (<= -1 (- {} P{}) 1)", input, input[1]);
  }
  return text + ")";
}

std::string core(const Recording& recording, Precision precision, Comparison which, bool is_lhs) {
  const std::size_t result = (is_lhs ? recording.lhs : recording.rhs)[static_cast<std::size_t>(which)];
  const auto& steps = recording.program.steps();
  if (steps[result].operation == Operation::zero) return "";
  std::vector<std::string> inputs;
  for (const std::size_t i : recording.program.needed_by({result})) {
    if (steps[i].operation == Operation::input) inputs.push_back(steps[i].name);
  }
  const InfixProgram text = with_definitions(
      recording.program, {result}, [](const std::string& name) { return name; }, prefix);
  std::string bindings;
  for (const Definition& d : text.definitions) bindings += fmt::format("\n    [{} {}]", d.name, d.value);
  const std::string side = is_lhs ? "lhs" : "rhs";
  return fmt::format(
      "\n(FPCore {0}_{1}_{2} ({3})\n"
      "  :name \"{0} {4}, {5} of lhs > rhs\"\n"
      "  :cite (ericson-2010)\n"
      "  :precision {6}\n"
      "  :round nearestEven\n"
      "  :pre {7}\n"
      "  (let* ({8})\n"
      "    {9}))\n",
      name(recording.form), identifier(which), side, fmt::join(inputs, " "), info(which).name, side, name(precision),
      precondition(inputs), bindings, text.results[0]);
}

}  // namespace

Files fpcore_files() {
  Files files;
  for (const Form form : {Form::published, Form::reduced}) {
    for (const Contraction contraction : {Contraction::plain, Contraction::fma}) {
      const Recording recording = record(form, contraction);
      for (const Precision precision : {Precision::binary32, Precision::binary64}) {
        std::string text = fmt::format(header, name(form), name(contraction), name(precision));
        for (std::size_t k = 0; k < comparison_count; ++k) {
          for (const bool is_lhs : {true, false}) {
            text += core(recording, precision, static_cast<Comparison>(k), is_lhs);
          }
        }
        files[fmt::format("fpcore/{}/{}_{}.fpcore", name(precision), name(form), name(contraction))] = text;
      }
    }
  }
  return files;
}

}  // namespace axiscert::proofs
