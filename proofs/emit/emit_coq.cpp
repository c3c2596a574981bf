// The sides of every comparison as definitions of Coq: over the reals, and with every operation rounded.
#include <fmt/format.h>

#include "proofs/emit/emit.h"
#include "proofs/emit/infix.h"

namespace axiscert::proofs {
namespace {

constexpr const char* header =
    R"(From Coq Require Import Reals.
Open Scope R_scope.

(* Written by write_proofs from kernel/sphere_triangle/formulae.h and kernel/sphere_triangle/rungs/reduced.h, through the recorder: do not edit.

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

}  // namespace axiscert::proofs
