// The comparisons over the reals as LaTeX, for a paper: one body for each set of formulae, to be \input where amsmath
// is loaded.
#include <fmt/format.h>

#include <cctype>

#include "proofs/emit.h"

namespace axiscert::proofs {
namespace {

constexpr std::string_view header =
    "% The comparisons of {}, over the reals; needs amsmath.\n"
    "% Written by write_proofs from the formulae: do not edit.\n"
    "% A, B, C: the vertices; P, r: the sphere's centre and radius; a, b, c: the vertices less P.\n";

// Q1_x is Q_{1,x}, AB_x is \mathit{AB}_{x}, Ax is A_{x}, t12 is t_{12}.
std::string latex_name(const std::string& name) {
  const std::size_t bar = name.find('_');
  std::string letters = name.substr(0, bar), index, component = bar == std::string::npos ? "" : name.substr(bar + 1);
  while (std::isdigit(static_cast<unsigned char>(letters.back()))) {
    index.insert(0, 1, letters.back());
    letters.pop_back();
  }
  const bool is_input = letters.size() == 2 && letters[1] >= 'x' && bar == std::string::npos;
  if (is_input) {
    component = letters[1];
    letters.pop_back();
  }
  const std::string subscript = index + (index.empty() || component.empty() ? "" : ",") + component;
  const std::string symbol = letters.size() == 1 ? letters : "\\mathit{" + letters + "}";
  return subscript.empty() ? symbol : symbol + "_{" + subscript + "}";
}

std::string in_text(const std::string& words) {
  std::string text;
  for (const char c : words) text += c == '_' ? "\\_" : std::string(1, c);
  return text;
}

std::string align(const std::string& rows) {
  return "\\begin{align*}\n" + rows.substr(0, rows.rfind(" \\\\")) + "\n\\end{align*}\n";
}

std::string body(const Recording& recording) {
  std::vector<std::size_t> sides;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    sides.push_back(recording.lhs[k]);
    sides.push_back(recording.rhs[k]);
  }
  Notation notation;
  notation.times = " \\cdot ";
  notation.name = latex_name;
  const InfixProgram text = infix(recording.program, sides, notation);
  std::string definitions, rows;
  for (const Definition& d : text.definitions) definitions += fmt::format("  {} &= {} \\\\\n", d.name, d.value);
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const std::string title = in_text(std::string(comparisons[k].name));
    rows += fmt::format("  \\text{{{}:}}\\quad & {} > {} \\\\\n", title, text.results[2 * k], text.results[2 * k + 1]);
  }
  return align(definitions) + align(rows);
}

}  // namespace

Files latex_files() {
  Files files;
  for (const Form form : {Form::published, Form::reduced}) {
    files[fmt::format("latex/{}.tex", name(form))] =
        fmt::format(header, name(form)) + body(record(form, Contraction::plain));
  }
  return files;
}

}  // namespace axiscert::proofs
