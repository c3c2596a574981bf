// The sides of every comparison as definitions of Coq: over the reals, and with every operation rounded.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "proofs/bounds.h"
#include "proofs/emit.h"

namespace axiscert::proofs {
namespace {

constexpr const char* header =
    R"(From Coq Require Import Reals.
Open Scope R_scope.

(* Written by write_proofs from kernel/sphere_triangle/formulae.h and kernel/sphere_triangle/forms/reduced.h, through the recorder: do not edit.

   F_exact_K_lhs, F_exact_K_rhs: the sides of comparison K of the formulae F over the reals.
   F_float_K_lhs, F_float_K_rhs: as the kernel computes them, every operation rounded, in its operation order.
   F_fma_K_lhs, F_fma_K_rhs: the same where dot and cross products use fused multiply-add. *)
)";

std::string definition(const Recording& recording, std::string_view kind, Comparison which, bool is_lhs,
                       const std::string& round) {
  const auto& sides = is_lhs ? recording.lhs : recording.rhs;
  Notation notation;
  notation.round = round;
  const InfixProgram text = infix(recording.program, {sides[static_cast<std::size_t>(which)]}, notation);
  std::string body;
  for (const Definition& d : text.definitions) body += fmt::format("  let {} := {} in\n", d.name, d.value);
  return fmt::format("Definition {}_{}_{}_{} (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=\n{}  {}.\n",
                     name(recording.form), kind, identifier(which), is_lhs ? "lhs" : "rhs", body, text.results[0]);
}

std::string definitions(Form form, Contraction contraction, std::string_view kind, const std::string& round) {
  const Recording recording = record(form, contraction);
  std::string text;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    for (const bool is_lhs : {true, false}) {
      text += "\n" + definition(recording, kind, static_cast<Comparison>(k), is_lhs, round);
    }
  }
  return text;
}

}  // namespace

Files coq_files() {
  std::string text = header;
  for (const Form form : {Form::published, Form::reduced}) {
    text += definitions(form, Contraction::plain, "exact", "");
  }
  text += "\nSection Rounded.\nVariable rnd : R -> R.\n";
  Files files;
  for (const Form form : {Form::published, Form::reduced}) {
    for (const Contraction contraction : {Contraction::plain, Contraction::fma}) {
      const std::string_view kind = contraction == Contraction::plain ? "float" : "fma";
      const std::string program = definitions(form, contraction, kind, "rnd ");
      text += program;
      files[program_path(fmt::format("{}_{}", name(form), name(contraction)))] = program;
    }
  }
  files["coq/formulae/Recorded.v"] = text + "\nEnd Rounded.\n";
  return files;
}

// The ranges that the scripts rely on, stated in Coq about the recorded quantities and proved by the lemmas of
// Ranges.v.

namespace {

constexpr const char* ranges_header =
    R"(From Coq Require Import Reals Lra.
From Axiscert Require Import Ranges.
Open Scope R_scope.

(* Written by write_proofs from the formulae and proofs/bounds.cpp: do not edit.

   Each quantity of the recorded program that a Gappa script of the scaled domain has a range for, and the range. *)
)";

// The coordinates, spelled as in the scripts; with a mark, those of a second triangle.
std::vector<std::string> coordinates(const std::string& mark) {
  std::vector<std::string> all;
  for (const char vertex : {'a', 'b', 'c'}) {
    for (const char i : {'x', 'y', 'z'}) all.push_back(fmt::format("{}_{}{}", vertex, i, mark));
  }
  return all;
}

// The index of the first vertex of an edge: 0 for AB, 1 for BC, 2 for CA, and 0 for a quantity that belongs to no edge.
int first_vertex(std::string_view quantity) {
  constexpr std::string_view numbers = "123", opposites = "CAB";
  const char last = quantity.back();
  if (const auto at = numbers.find(last); at != numbers.npos) return static_cast<int>(at);
  if (const auto at = opposites.find(last); quantity.size() == 2 && at != opposites.npos) return static_cast<int>(at);
  return 0;
}

// A lemma's arguments for a component (0, 1, 2) of a quantity.
std::string arguments(const Range& range, int component, const std::string& mark) {
  std::istringstream words{std::string(range.arguments)};
  std::string text;
  for (std::string word; words >> word;) {
    const int coordinate = (word[0] - 'x' + component) % 3, vertex = (word[1] - '0' + first_vertex(range.quantity)) % 3;
    text += fmt::format(" {}_{}{}", "abc"[vertex], "xyz"[coordinate], mark);
  }
  return text;
}

// All six coordinates of an edge's ends, which a lemma about a sum takes.
std::string sum_arguments(const Range& range) {
  Range all = range;
  all.arguments = "x0 y0 z0 x1 y1 z1";
  return arguments(all, 0, "");
}

std::string over(const std::string& relation, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += fmt::format("{} {} -> ", relation, name);
  return text;
}

std::string definition(const Program& program, const std::string& quantity) {
  const auto given = coordinates("");
  const InfixProgram text = infix(program, {program.named(quantity)}, Notation{});
  std::string body;
  for (const auto& [name, value] : text.definitions) {
    if (std::find(given.begin(), given.end(), name) == given.end())
      body += fmt::format("  let {} := {} in\n", name, value);
  }
  return fmt::format("\nDefinition exact_{} ({} : R) : R :=\n{}  {}.\n", quantity, fmt::join(given, " "), body,
                     text.results[0]);
}

std::string number(std::string_view dyadic) { return dyadic == "0.75" ? "3 / 4" : std::string(dyadic); }

// The proof from the lemma, by arithmetic on polynomials.
std::string proof(const std::string& lemma, const std::string& quantity) {
  return fmt::format(
      "Proof.\n  intros. assert (L := {}). unfold exact_{}; cbv zeta.\n"
      "  unfold near, QC, Q in *. destruct L; try assumption. split; lra.\nQed.\n",
      lemma, quantity);
}

std::string theorems(const Range& range, const std::string& quantity, int component) {
  const auto given = coordinates(""), moved = coordinates("'");
  const std::string value = fmt::format("exact_{} {}", quantity, fmt::join(given, " "));
  std::string text =
      fmt::format("\nTheorem range_{} : forall {}, {}\n  {} <= {} <= {}.\n", quantity, fmt::join(given, " "),
                  over("unit", given), number(range.low), value, number(range.high));
  text += proof(fmt::format("{}_range{}", range.lemma, arguments(range, component, "")), quantity);
  if (range.change.empty()) return text;
  std::vector<std::string> pairs;
  for (std::size_t i = 0; i < given.size(); ++i) pairs.push_back(given[i] + " " + moved[i]);
  text += fmt::format(
      "\nTheorem change_{} : forall h {} {}, 0 <= h ->\n  {}\n  {}\n  {}\n  near ({} * h) ({})\n    (exact_{} {}).\n",
      quantity, fmt::join(given, " "), fmt::join(moved, " "), over("unit", given), over("unit", moved),
      over("near h", pairs), range.change, value, quantity, fmt::join(moved, " "));
  text += proof(
      fmt::format("{}_change h{}{}", range.lemma, arguments(range, component, ""), arguments(range, component, "'")),
      quantity);
  return text;
}

std::string sum_theorem(const Range& range) {
  const auto given = coordinates("");
  const auto part = [&](char i) {
    return fmt::format("Rabs (exact_{}_{} {})", range.quantity, i, fmt::join(given, " "));
  };
  std::string equal;
  for (int i = 0; i < 3; ++i) {
    equal += fmt::format("  unfold exact_{}_{}; cbv zeta.\n", range.quantity, "xyz"[i]);
  }
  return fmt::format(
      "\nTheorem sum_{0} : forall {1}, {2}\n  {3} +\n  {4} +\n  {5} <= {6} / 100.\nProof.\n  intros.\n"
      "  refine (Rle_trans _ _ _ (Req_le _ _ _) ({7}_sum{8} _ _ _ _ _ _)); try assumption.\n{9}"
      "  unfold Q. repeat apply f_equal2; apply f_equal; ring.\nQed.\n",
      range.quantity, fmt::join(given, " "), over("unit", given), part('x'), part('y'), part('z'),
      range.sum_in_hundredths, range.lemma, sum_arguments(range), equal);
}

}  // namespace

Files range_files() {
  const Recording published = record(Form::published, Contraction::plain);
  std::string text = ranges_header;
  for (const Range& range : ranges()) {
    if (range.lemma.empty()) continue;
    for (int i = 0; i < (range.is_vector ? 3 : 1); ++i) {
      const std::string quantity = std::string(range.quantity) + (range.is_vector ? std::string("_") + "xyz"[i] : "");
      text += definition(published.program, quantity);
      text += theorems(range, quantity, i);
    }
    if (range.sum_in_hundredths != 0) text += sum_theorem(range);
  }
  return {{"ranges/RangesClaimed.v", text}};
}

}  // namespace axiscert::proofs
