// The steps of the certified predicate as they were recorded: each of them as text, and those that the theory states as
// definitions of Coq, over any machine that has the operations (coq/numbers/Machine.v).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cmath>
#include <set>
#include <stdexcept>

#include "proofs/certified/graph.h"
#include "proofs/emit.h"
#include "kernel/include/axiscert/certified.h"

namespace axiscert::proofs {
namespace {

using namespace certified;
constexpr Index no_node = ~Index{0};

// A name of a step that no other has.
std::string full_name(const RecordedStep& step) {
  return fmt::format("{}_{}_binary{}", step.name, step.fused ? "fma" : "plain", step.bits);
}

// The nodes that these results need, with the names by which they are written: t0, t1, ... in order.
class NamedNodes {
 public:
  NamedNodes(const RecordedStep& step, const std::vector<Result>& results)
      : graph_(step.graph), name_(graph_.nodes().size()) {
    std::vector<Index> ends;
    for (const Result& result : results) ends.push_back(result.node);
    int next = 0;
    for (const Index i : graph_.needed_by(ends)) {
      const Node& node = graph_.nodes()[i];
      if (node.op == Op::input) name_[i] = node.name;
      else if (info(node.op).operands == 0) name_[i] = "";
      else {
        name_[i] = fmt::format("t{}", next++);
        computed_.push_back(i);
      }
    }
  }
  const std::vector<Index>& computed() const { return computed_; }
  const Node& node(Index i) const { return graph_.nodes()[i]; }
  // Constants have no name: they are written where they are used.
  const std::string& name(Index i) const { return name_[i]; }

 private:
  const Graph& graph_;
  std::vector<std::string> name_;
  std::vector<Index> computed_;
};

std::string text_of_constant(const Node& node) {
  if (node.op == Op::constant) return fmt::format("{:a}", node.number);
  if (node.op == Op::flag_constant) return node.word ? "true" : "false";
  return fmt::format("{:#x}", node.word);
}
}  // namespace

std::string text_of(const RecordedStep& step) {
  std::vector<Result> shown = step.results;
  for (const AskedOfLanes& question : step.asked) {
    for (const Index flag : question.flags) shown.push_back({"", flag});
  }
  const NamedNodes named(step, shown);
  const auto operand = [&](Index i) { return named.name(i).empty() ? text_of_constant(named.node(i)) : named.name(i); };
  std::string text = fmt::format("step {}\n", full_name(step));
  for (const Index i : named.computed()) {
    const Node& node = named.node(i);
    text += fmt::format("  {} = {}", named.name(i), info(node.op).name);
    for (std::size_t k = 0; k < info(node.op).operands; ++k) text += " " + operand(node.operands[k]);
    text += "\n";
  }
  for (std::size_t k = 0; k < step.asked.size(); ++k) {
    text += fmt::format("  asked whether {}", step.asked[k].of_all ? "all hold:" : "none holds:");
    for (const Index flag : step.asked[k].flags) text += " " + operand(flag);
    text += fmt::format("; answered {}\n", k < step.answers.size() && step.answers[k] ? "yes" : "no");
  }
  for (const Result& result : step.results) text += fmt::format("  {}: {}\n", result.name, operand(result.node));
  for (const RecordedStep& other : step.otherwise) text += text_of(other);
  return text;
}

namespace {

// n and e in Coq's notation, x = n 2^e with an odd n, for x that is finite and not 0.
struct CoqDyadic {
  std::string n, e;
};
CoqDyadic coq_dyadic(double x) {
  if (!std::isfinite(x) || x == 0) throw std::logic_error("emit_certified: a constant is not finite, or zero");
  int exponent = 0;
  double significand = std::frexp(x, &exponent);
  while (significand != std::floor(significand)) {
    significand *= 2;
    --exponent;
  }
  const auto in_z = [](long long z) { return z < 0 ? fmt::format("({})", z) : fmt::format("{}", z); };
  return {in_z(static_cast<long long>(significand)), in_z(exponent)};
}
std::string coq_number(double x) {
  if (std::isinf(x) && x > 0) return "(m_infinity m)";
  if (x == 0) return "(m_zero m)";
  const CoqDyadic value = coq_dyadic(x);
  return fmt::format("(m_constant m {} {})", value.n, value.e);
}
// The promise of certified.h about phantoms.
std::string promised_depth(std::string_view format, double depth) {
  const CoqDyadic value = coq_dyadic(depth);
  return fmt::format("\n(* n and e of n 2^e *)\nDefinition promised_phantom_depth_{} : Z * Z := ({}, {}).\n", format,
                     value.n, value.e);
}
// The constants of a step other than 0, in their order, as n and e: for steps that the theory does not state whole.
std::string coq_constants(const RecordedStep& step) {
  std::vector<Index> ends;
  for (const Result& result : step.results) ends.push_back(result.node);
  std::set<double> values;
  for (const Index i : step.graph.needed_by(ends)) {
    const Node& node = step.graph.nodes()[i];
    if (node.op == Op::constant && node.number != 0) values.insert(node.number);
  }
  std::string list;
  for (const double x : values) {
    const CoqDyadic value = coq_dyadic(x);
    list += fmt::format("{}({}, {})", list.empty() ? "" : "; ", value.n, value.e);
  }
  return fmt::format("\nDefinition {}_constants : list (Z * Z) :=\n  [{}].\n", full_name(step), list);
}
std::string coq_constant(const Node& node) {
  if (node.op == Op::constant) return coq_number(node.number);
  if (node.op == Op::flag_constant) return node.word ? "true" : "false";
  throw std::logic_error("emit_certified: the theory has no words");
}
// 2^-e for x in [2^e, 2^(e + 1)), as the conservative test computes it from x's bits: the operand x, or null.
const Index* inverse_power_of(const Graph& graph, const Node& node, int bits) {
  const auto at = [&](Index i) -> const Node& { return graph.nodes()[i]; };
  const std::uint64_t exponent = bits == 32 ? 0x7f800000u : 0x7ff0000000000000u;
  const std::uint64_t twice_bias = bits == 32 ? 0x7f000000u : 0x7fe0000000000000u;
  if (node.op != Op::from_bits) return nullptr;
  const Node& difference = at(node.operands[0]);
  if (difference.op != Op::word_subtract) return nullptr;
  const Node &from = at(difference.operands[0]), &masked = at(difference.operands[1]);
  if (from.op != Op::word_constant || from.word != twice_bias || masked.op != Op::word_and) return nullptr;
  const Node &word = at(masked.operands[0]), &mask = at(masked.operands[1]);
  if (word.op != Op::bits || mask.op != Op::word_constant || mask.word != exponent) return nullptr;
  return &word.operands[0];
}
std::string coq_step(const Node& node, const std::array<std::string, 3>& x) {
  switch (node.op) {
    case Op::both:
      return fmt::format("{} && {}", x[0], x[1]);
    case Op::either:
      return fmt::format("{} || {}", x[0], x[1]);
    case Op::opposite:
      return fmt::format("negb {}", x[0]);
    case Op::choose:
      return fmt::format("if {} then {} else {}", x[0], x[1], x[2]);
    default:
      break;
  }
  std::string text = fmt::format("m_{} m", info(node.op).name);
  for (std::size_t k = 0; k < info(node.op).operands; ++k) text += " " + x[k];
  return text;
}

// The flag of which a word has each bit, or `none`: words of what is known are made by joining single bits where a flag
// holds.
void find_bits(const Graph& graph, Index word, std::vector<Index>& bits) {
  const Node& node = graph.nodes()[word];
  const auto at = [&](std::size_t k) -> const Node& { return graph.nodes()[node.operands[k]]; };
  if (node.op == Op::word_or) {
    find_bits(graph, node.operands[0], bits);
    find_bits(graph, node.operands[1], bits);
  } else if (node.op == Op::word_and && at(0).op == Op::all_ones && at(1).op == Op::word_constant &&
             std::has_single_bit(at(1).word)) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(at(1).word));
    if (bits.at(bit) != no_node) throw std::logic_error("emit_certified: a bit of two flags");
    bits[bit] = at(0).operands[0];
  } else if (node.op != Op::word_constant || node.word != 0) {
    throw std::logic_error("emit_certified: a word that is not made of bits");
  }
}

// The flags of an outcode's bits, one for each face of the box, in place of the word.
RecordedStep with_outcode_bits(RecordedStep step) {
  constexpr std::string_view faces[] = {"low_x", "high_x", "low_y", "high_y", "low_z", "high_z"};
  // The flag of a bit of a word that is joined of single bits, each of them, or all, chosen by a flag or else zero.
  const auto flag_of = [&](const auto& self, Index word, std::uint64_t bit) -> Index {
    const Node node = step.graph.nodes()[word];
    if (node.op == Op::word_constant) return step.graph.flag(node.word == bit);
    if (node.op == Op::word_or) {
      return step.graph.node(Op::either, {self(self, node.operands[0], bit), self(self, node.operands[1], bit)});
    }
    const auto is_zero = [](const Node& of) { return of.op == Op::word_constant && of.word == 0; };
    if (node.op != Op::choose || !is_zero(step.graph.nodes()[node.operands[2]])) {
      throw std::logic_error("emit_certified: an outcode that is not made of bits");
    }
    return step.graph.node(Op::both, {node.operands[0], self(self, node.operands[1], bit)});
  };
  const Index outcode = step.result("outcode");
  std::erase_if(step.results, [](const Result& result) { return result.name == "outcode"; });
  for (std::size_t face = 0; face < 6; ++face) {
    step.results.push_back({fmt::format("a_{}", faces[face]), flag_of(flag_of, outcode, std::uint64_t{1} << face)});
  }
  return step;
}

std::vector<Result> results_of(const RecordedStep& step, Sort sort) {
  std::vector<Result> results;
  for (const Result& result : step.results) {
    if (info(step.graph.nodes()[result.node].op).sort == sort) results.push_back(result);
  }
  return results;
}
// A step with the bits of what it knows, by the result `known`, named as in exact_step.h, in place of its results.
RecordedStep with_known_bits(RecordedStep step, std::string_view known) {
  constexpr std::string_view axes[] = {"a", "b", "c", "plane", "ab", "bc", "ca"};
  std::vector<Index> bits(23, no_node);
  find_bits(step.graph, step.result(known), bits);
  step.results.clear();
  for (std::size_t group = 0; group < 3; ++group) {
    for (std::size_t axis = 0; axis < 7; ++axis) {
      const Index flag = bits.at(8 * group + axis);
      constexpr std::string_view groups[] = {"fails", "radius", "sides"};
      if (flag == no_node) throw std::logic_error("emit_certified: a bit of no flag");
      step.results.push_back({fmt::format("{}_{}", groups[group], axes[axis]), flag});
    }
  }
  return step;
}

// Results of one sort as a list.
std::string coq_definition(const RecordedStep& step, Sort sort, std::string_view of, std::string_view type) {
  const std::vector<Result> results = results_of(step, sort);
  if (results.empty()) return {};
  const NamedNodes named(step, results);
  const auto operand = [&](Index i) { return named.name(i).empty() ? coq_constant(named.node(i)) : named.name(i); };
  std::string names, list;
  for (const Result& result : results) {
    names += (names.empty() ? "" : " ") + result.name;
    list += (list.empty() ? "" : "; ") + operand(result.node);
  }
  std::string text = fmt::format(
      "\n(* {} *)\nDefinition {}_{} (m : machine) (ax ay az bx by_ bz cx cy cz px py pz r : m_number m) "
      ": list {} :=\n",
      names, full_name(step), of, type);
  const auto in_coq = [](std::string name) { return name == "by" ? "by_" : name; };
  for (const Index i : named.computed()) {
    const Node& node = named.node(i);
    if (info(node.op).sort == Sort::word) continue;  // the theory has none
    if (const Index* x = inverse_power_of(step.graph, node, step.bits)) {
      text += fmt::format("  let {} := m_inverse_power m {} in\n", named.name(i), in_coq(operand(*x)));
      continue;
    }
    std::array<std::string, 3> operands;
    for (std::size_t k = 0; k < info(node.op).operands; ++k) operands[k] = in_coq(operand(node.operands[k]));
    text += fmt::format("  let {} := {} in\n", named.name(i), coq_step(node, operands));
  }
  return text + fmt::format("  [{}].\n", list);
}

// A tree of questions about values at these places.
std::string coq_tree(const AskedTree& tree, const std::vector<std::size_t>& place) {
  if (!tree.asked) return fmt::format("Answer {}", tree.answer);
  constexpr const char* signs[] = {"Is_positive", "Is_negative", "Is_zero", "Is_at_least_zero", "Is_at_most_zero"};
  std::string asked;
  if (tree.asked->kind == Asked::known) asked = fmt::format("Knows {} {}", tree.asked->of, tree.asked->axis);
  else if (tree.asked->kind == Asked::separates) asked = fmt::format("Separates {}", tree.asked->of);
  else asked = fmt::format("{} {}", signs[tree.asked->kind], place.at(tree.asked->of));
  return fmt::format("Ask ({}) ({}) ({})", asked, coq_tree(tree.after[0], place), coq_tree(tree.after[1], place));
}
// What the exact step makes of its margins' signs and of what is known.
std::string exact_verdict(const RecordedExact& exact, const std::vector<std::size_t>& place) {
  std::string text;
  for (const bool open : {false, true}) {
    std::string trees;
    for (const AskedTree& tree : exact.axes[open]) trees += (trees.empty() ? "" : ";\n   ") + coq_tree(tree, place);
    text += fmt::format("\n(* Whether each axis separates. *)\nDefinition recorded_{}_axes : list tree :=\n  [{}].\n",
                        open ? "open" : "closed", trees);
  }
  std::string told;
  for (const std::vector<AskedTree>& axis : exact.told) {
    std::string trees;
    for (const AskedTree& tree : axis) trees += (trees.empty() ? "" : ";\n    ") + coq_tree(tree, place);
    told += (told.empty() ? "[" : ";\n   [") + trees + "]";
  }
  text += fmt::format(
      "\n(* What certain signs tell of each axis, if the others fail: that it fails, its radius, its sides. *)\n"
      "Definition recorded_told : list (list tree) :=\n  [{}].\n",
      told);
  text += fmt::format("\nDefinition recorded_verdict : tree :=\n  {}.\n", coq_tree(exact.verdict, place));
  std::string needs;
  for (const bool needed : exact.needs_normal) needs += (needs.empty() ? "" : "; ") + fmt::format("{}", needed);
  return text +
         fmt::format(
             "\n(* Whether V is computed: by which of the plane, AB, BC, CA fail, and which edges' sides hold. *)\n"
             "Definition recorded_needs_normal : list bool :=\n  [{}].\n",
             needs);
}
// Which integers are taken for numbers of a span.
std::string exact_sizes(const RecordedExact& exact) {
  std::string sizes, runs;
  for (const RecordedSize& size : exact.sizes) {
    sizes += fmt::format("{}({}, {}, [{}])", sizes.empty() ? "" : "; ", size.size, size.negligible,
                         fmt::join(size.words, "; "));
  }
  for (std::size_t i = 0, count = 0; i < exact.size_for.size(); ++i) {
    ++count;
    if (i + 1 < exact.size_for.size() && exact.size_for[i + 1] == exact.size_for[i]) continue;
    runs += fmt::format("{}({}%nat, {})", runs.empty() ? "" : "; ", count, exact.size_for[i]);
    count = 0;
  }
  return fmt::format(
      "\n(* The exponent of the negligible radius, and the words of values of degree 1, 2, 3, 4 and 6. *)\n"
      "Definition recorded_sizes : list (Z * Z * list Z) :=\n  [{}]%Z.\n"
      "\n(* The size for numbers of a span of 0, 1, ... bits, as how many of them have which; 0: none. *)\n"
      "Definition recorded_size_runs : list (nat * Z) :=\n  [{}]%Z.\n",
      sizes, runs);
}

// The exact step's margins as instructions: the k-th computes value 13 + k, the first thirteen are the query. As lists
// of Coq: the instructions, each with the degree by which the exact step chooses its words, and the places of the
// results.
std::string exact_program() {
  const RecordedExact exact = recorded_exact();
  std::vector<Index> ends;
  for (const Result& result : exact.results) ends.push_back(result.node);
  std::vector<std::size_t> place(exact.graph.nodes().size());
  std::size_t next = 0;
  std::string list;
  const std::vector<Index> needed = exact.graph.needed_by(ends);
  for (std::size_t i = 0; i < query_inputs.size(); ++i) {
    if (needed.at(i) != i) throw std::logic_error("emit_certified: the exact step does not use its whole query");
  }
  for (const Index i : needed) {
    const Node& node = exact.graph.nodes()[i];
    place[i] = next++;
    if (node.op == Op::input) continue;
    const char* name = node.op == Op::add ? "Plus" : node.op == Op::subtract ? "Minus" : "Times";
    list += fmt::format("{}({} {} {}, {})", list.empty() ? "  [" : ";\n   ", name, place[node.operands[0]],
                        place[node.operands[1]], exact.degree[i]);
  }
  std::string names, places;
  for (const Result& result : exact.results) {
    names += (names.empty() ? "" : " ") + result.name;
    places += (places.empty() ? "" : "; ") + fmt::format("{}", place[result.node]);
  }
  return fmt::format(
             "Definition recorded_exact : list (instruction * nat) :=\n{}].\n\n"
             "(* {} *)\nDefinition recorded_exact_results : list nat :=\n  [{}].\n",
             list, names, places) +
         exact_verdict(exact, place) + exact_sizes(exact);
}

constexpr const char* exact_header =
    R"((* Written by write_proofs from exact_test.h, exact_margins.h and widths.h of kernel/sphere_triangle/certified,
   through the recorder: do not edit.

   The instructions, each with the degree by which the exact step chooses its words; the places of the results; what it
   asks of these, and answers; the integers that it takes. *)
From Coq Require Import List ZArith.
From Axiscert Require Import ExactProgram.
Import ListNotations.
Open Scope nat_scope.

)";

constexpr const char* coq_header =
    R"(From Coq Require Import List Bool ZArith.
From Axiscert Require Import Machine.
Import ListNotations.
Open Scope Z_scope.
Open Scope bool_scope.

(* Written by write_proofs from the steps in kernel/sphere_triangle/certified, through the recorder: do not edit.

   STEP_plain_FORMAT_numbers, STEP_fma_FORMAT_numbers: the numbers that a step computes with and without fused
   multiply-add, named above each list. STEP_..._constants: the constants of a step of which no more is stated.
   STEP_..._answers: the flags that it answers. STEP_..._known, and for each sphere known_closed, known_open: the bits
   that it tells the next steps (Known in exact_step.h). *)
)";

bool is_stated(const RecordedStep& step) {
  return step.name == "coarse" || step.name == "pair" || step.name == "box" || step.name == "fine" ||
         step.name == "conservative";
}

}  // namespace

Files certified_files() {
  Files files;
  std::string coq = coq_header;
  coq +=
      promised_depth("binary32", AXISCERT_PHANTOM_DEPTH_F32) + promised_depth("binary64", AXISCERT_PHANTOM_DEPTH_F64);
  std::vector<RecordedStep> steps = recorded_steps();
  for (RecordedStep& box : recorded_box()) steps.push_back(std::move(box));
  for (const RecordedStep& recorded : steps) {
    files[program_path(full_name(recorded))] = text_of(recorded);
    if (recorded.name.starts_with("deep_")) coq += coq_constants(recorded);
    if (!is_stated(recorded)) continue;
    const RecordedStep step = recorded.name == "box" ? with_outcode_bits(recorded) : recorded;
    coq += coq_definition(step, Sort::number, "numbers", "(m_number m)");
    coq += coq_definition(step, Sort::flag, "answers", "bool");
    const auto add_known = [&](std::string_view known) {
      coq += coq_definition(with_known_bits(step, known), Sort::flag, known, "bool");
    };
    if (step.name == "coarse" && step.bits == 64) add_known("known");
    if (step.name == "fine") add_known("known_closed"), add_known("known_open");
  }
  for (const RecordedStep& step : recorded_scaling()) files[program_path(full_name(step))] = text_of(step);
  const std::string exact = exact_program();
  files["coq/certified/RecordedCertified.v"] = coq;
  files["coq/numbers/RecordedExact.v"] = exact_header + exact;
  files[program_path("exact")] = exact;
  return files;
}

}  // namespace axiscert::proofs
