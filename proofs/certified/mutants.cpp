#include "proofs/certified/mutants.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace axiscert::proofs::certified {
namespace {

bool depends_on_order(Op op) {
  switch (op) {
    case Op::subtract:
    case Op::divide:
    case Op::with_sign:
    case Op::fused:
    case Op::word_subtract:
    case Op::less:
    case Op::at_most:
    case Op::word_less:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::vector<Mutant> mutants_of(const RecordedStep& step) {
  std::vector<Index> ends;
  for (const Result& result : step.results) ends.push_back(result.node);
  std::vector<Mutant> all;
  for (const Index i : step.graph.needed_by(ends)) {
    const Node& node = step.graph.nodes()[i];
    const auto add = [&](std::string fault, const auto& change) {
      Node changed = node;
      change(changed);
      all.push_back({std::move(fault), i, std::move(changed)});
    };
    if (node.op == Op::constant && node.number != 0 && std::isfinite(node.number)) {  // half of infinity is infinity
      add(fmt::format("{:a} halved", node.number), [](Node& n) { n.number /= 2; });
      add(fmt::format("{:a} doubled", node.number), [](Node& n) { n.number *= 2; });
    }
    if (node.op == Op::choose) {
      add(fmt::format("choose {}: the other", i), [](Node& n) { std::swap(n.operands[1], n.operands[2]); });
    } else if (node.op == Op::fused) {
      add(fmt::format("fused {}: a factor exchanged with the term", i),
          [](Node& n) { std::swap(n.operands[1], n.operands[2]); });
    } else if (depends_on_order(node.op)) {
      add(fmt::format("{} {}: operands exchanged", info(node.op).name, i),
          [](Node& n) { std::swap(n.operands[0], n.operands[1]); });
    }
    if (node.op == Op::both || node.op == Op::either) {
      for (const std::size_t kept : {0, 1}) {
        add(fmt::format("{} {}: the {} condition dropped", info(node.op).name, i, kept == 0 ? "second" : "first"),
            [kept](Node& n) { n.operands[1 - kept] = n.operands[kept]; });
      }
    }
  }
  return all;
}

RecordedStep with(const Mutant& mutant, RecordedStep step) {
  step.graph.replace(mutant.at, mutant.node);
  return step;
}

}  // namespace axiscert::proofs::certified
