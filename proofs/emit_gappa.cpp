// One Gappa script for each comparison, set of formulae, contraction, precision and domain: a bound on the error of lhs
// - rhs.
//
// A script contains three programs: the computed one (a_x, V_x, ...); on the scaled domain the exact one on the
// computed translated vertices (FV_x, ...); and the exact one on the exact translated vertices (Ma_x, MV_x, ...). The
// first differs from the second by rounding, the second from the third by translation. `a ~ Ma` tells Gappa which
// quantities to compare.
//
// The hypotheses are all from Ranges.v: ranges of exact quantities, and how much they change with the vertices. A `cut`
// is Hoelder's inequality: where each |v_i - Mv_i| <= D and |Mw_x| + |Mw_y| + |Mw_z| <= S, the sum of Mw_i (v_i - Mv_i)
// is at most D S. The script proves D first, then uses the cut.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>
#include <stdexcept>

#include "proofs/bounds.h"
#include "proofs/emit.h"

namespace axiscert::proofs {
namespace {

constexpr std::array<std::string_view, 3> components = {"_x", "_y", "_z"};

bool is_identifier(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}
bool is_input(const std::string& name) {
  return std::find(input_names.begin(), input_names.end(), name) != input_names.end();
}
bool is_translated(const std::string& name) {
  return name.size() == 3 && name[0] >= 'a' && name[0] <= 'c' && name[1] == '_';
}

// A program's definitions and its two sides; each side is a name or "0".
struct WrittenProgram {
  std::string prefix;
  std::vector<Definition> definitions;
  std::string lhs, rhs;
  bool defines(const std::string& name) const {
    return std::any_of(definitions.begin(), definitions.end(),
                       [&](const Definition& d) { return d.name == prefix + name; });
  }
};

// A sum of products of two vectors of the program, whose error is bounded by a cut.
struct Dot {
  std::string_view v, w;
  bool is_lhs;
};
// The sides of an edge's comparisons that are dot products.
std::optional<Dot> dot_of(Form form, Comparison which) {
  constexpr std::array<std::array<std::string_view, 3>, 3> of_edge = {
      {{"N1", "Q1", "QC"}, {"N2", "Q2", "QA"}, {"N3", "Q3", "QB"}}};
  const Kind kind = kind_of(which);
  if (kind != Kind::edge_radius && kind != Kind::edge_side) return std::nullopt;
  const auto& [N, Q, opposite] =
      of_edge[static_cast<std::size_t>(info(which).axis) - static_cast<std::size_t>(Axis::edge_ab)];
  if (form == Form::reduced) {
    return kind == Kind::edge_radius ? Dot{N, N, true} : Dot{N, "V", false};
  }
  return kind == Kind::edge_radius ? Dot{Q, Q, true} : Dot{Q, opposite, true};
}

class Script {
 public:
  Script(const Recording& recording, const Setting& setting, Comparison which)
      : setting_(setting), which_(which), recording_(recording), dot_(dot_of(setting.form, which)) {
    programs_ = {written("", "rnd"), written("M", "")};
    if (is_scaled()) programs_.push_back(written("F", ""));
  }

  std::string text() const {
    const bool single = setting_.precision == Precision::binary32;
    std::string text = fmt::format(
        "# The error of lhs - rhs: {} of {}, {}, {}, on the {} domain.\n"
        "# Written by write_proofs from the formulae: do not edit.\n"
        "@rnd = float<{},{},ne>;\n",
        info(which_).name, name(setting_.form), name(setting_.contraction), name(setting_.precision),
        name(setting_.domain), single ? 24 : 53, single ? -149 : -1074);
    if (!is_scaled()) {
      for (const std::string_view input : std::span(input_names).first(12)) {
        text += fmt::format("{0} = rnd({0}_);\n", input);
      }
    }
    text += "r = rnd(r_);\n";
    for (const WrittenProgram& program : programs_) {
      for (const Definition& d : program.definitions) text += fmt::format("{} = {};\n", d.name, d.value);
    }
    if (dot_) text += dot_definitions();
    std::string goals;
    for (const std::string& h : hypotheses()) goals += fmt::format("  {} ->\n", h);
    goals += conclusion();
    return text + "{\n" + goals + "\n}\n" + hints();
  }

 private:
  const WrittenProgram& computed() const { return programs_[0]; }
  bool is_scaled() const { return setting_.domain == Domain::scaled; }
  int digits() const { return setting_.precision == Precision::binary32 ? 24 : 53; }
  std::string sixteenths(int n) const { return fmt::format("{}b-{}", n, digits() + 4); }
  std::string side(bool is_lhs, const std::string& prefix) const {
    const auto program = std::find_if(programs_.begin(), programs_.end(), [&](auto& p) { return p.prefix == prefix; });
    return is_lhs ? program->lhs : program->rhs;
  }

  WrittenProgram written(const std::string& prefix, const std::string& round) const {
    Notation notation;
    notation.round = round;
    notation.name = [&](const std::string& name) {
      if (is_input(name) || (prefix == "F" && is_translated(name))) return name;
      return (prefix == "F" && name == "rr" ? "M" : prefix) + name;  // the radius is not translated
    };
    const auto k = static_cast<std::size_t>(which_);
    InfixProgram text = infix(recording_.program, {recording_.lhs[k], recording_.rhs[k]}, notation);
    WrittenProgram result{prefix, std::move(text.definitions), text.results[0], text.results[1]};
    std::erase_if(result.definitions, [&](Definition& d) {
      if (prefix == "F") return is_translated(d.name) || d.name == "Mrr";
      if (!is_scaled() || !is_translated(d.name.substr(prefix.size()))) return false;
      d.value = "rnd(M" + d.name + ")";  // an exact coordinate is a variable
      return prefix == "M";
    });
    for (const auto& [side, name] : {std::pair(&result.lhs, "lhs"), std::pair(&result.rhs, "rhs")}) {
      if (is_identifier(*side)) continue;
      result.definitions.push_back({prefix + name, *side});
      *side = prefix + name;
    }
    return result;
  }

  // The first-order error due to either vector, and the exact product of the computed vectors.
  std::string dot_definitions() const {
    const auto sum = [&](auto&& term) {
      return setting_.contraction == Contraction::fma
                 ? fmt::format("{2} + ({1} + {0})", term("_x"), term("_y"), term("_z"))
                 : fmt::format("{} + {} + {}", term("_x"), term("_y"), term("_z"));
    };
    const auto& [v, w, is_lhs] = *dot_;
    const auto first_order = [&](std::string_view weight, std::string_view error) {
      return sum([&](std::string_view i) { return fmt::format("M{0}{2} * ({1}{2} - M{1}{2})", weight, error, i); });
    };
    std::string text =
        fmt::format("product = {};\n", sum([&](std::string_view i) { return fmt::format("{}{} * {}{}", v, i, w, i); }));
    text += fmt::format("by_{} = {};\n", w, first_order(v, w));
    if (v != w) text += fmt::format("by_{} = {};\n", v, first_order(w, v));
    return text;
  }

  int sum_in_hundredths(std::string_view vector) const {
    for (const Range& range : ranges()) {
      if (range.domain == setting_.domain && range.quantity == vector) return range.sum_in_hundredths;
    }
    throw std::logic_error("no range of " + std::string(vector));
  }

  std::vector<std::string> hypotheses() const {
    std::vector<std::string> all;
    if (is_scaled()) {
      for (const Definition& d : computed().definitions) {
        if (is_translated(d.name)) all.push_back(fmt::format("M{} in [-1,1]", d.name));
      }
    } else {
      for (const std::string_view input : std::span(input_names).first(12)) {
        all.push_back(fmt::format("{} in [-1,1]", input));
      }
    }
    all.push_back("r in [0,1]");
    for (const Range& range : ranges()) {
      if (range.domain != setting_.domain) continue;
      for (const std::string_view i : components) {
        const std::string q = std::string(range.quantity) + std::string(range.is_vector ? i : "");
        if (!computed().defines(q)) continue;
        for (const WrittenProgram& program : programs_) {
          if (program.prefix.empty()) continue;
          all.push_back(fmt::format("{}{} in [{},{}]", program.prefix, q, range.low, range.high));
        }
        if (!range.change.empty()) {
          // h = u/2, half an ulp below 1.
          all.push_back(fmt::format("|F{0} - M{0}| <= {1}b-{2}", q, range.change, digits() + 1));
        }
        if (!range.is_vector) break;
      }
    }
    return all;
  }

  std::string error() const {
    const std::string l = side(true, ""), r = side(false, "");
    if (r == "0") return fmt::format("{} - M{}", l, l);
    if (l == "0") return fmt::format("{} - M{}", r, r);
    return fmt::format("({} - {}) - (M{} - M{})", l, r, l, r);
  }

  std::string conclusion() const {
    const int proved = bound(setting_, which_);
    const std::string goal = proved == 0 ? error() + " in ?" : fmt::format("|{}| <= {}", error(), sixteenths(proved));
    if (!dot_) return "  " + goal;
    const auto& [v, w, is_lhs] = *dot_;
    // Only the error of w is bounded by a cut: the weights v are those that sum to less than three times their
    // greatest.
    const int step = vector_bound(setting_, w);
    if (step == 0) return fmt::format("  {0}_x - M{0}_x in ? /\\ {0}_y - M{0}_y in ? /\\ {0}_z - M{0}_z in ?", w);
    std::string steps;
    for (const std::string_view i : components) {
      steps += fmt::format("{}|{}{} - M{}{}| <= {}", steps.empty() ? "" : " /\\ ", w, i, w, i, sixteenths(step));
    }
    const std::string hypothesis =
        fmt::format("|by_{}| <= {}", w, sixteenths((sum_in_hundredths(v) * step + 99) / 100));
    if (proved == 0) return fmt::format("  {} ->\n  {}", hypothesis, goal);
    return fmt::format("  ({}) /\\\n  ({} ->\n  {})", steps, hypothesis, goal);
  }

  std::string hints() const {
    std::string text;
    for (const Definition& d : computed().definitions) {
      if (is_translated(d.name)) continue;
      text += fmt::format("{0} ~ M{0};\n", d.name);
      if (is_scaled() && d.name != "rr") text += fmt::format("{0} ~ F{0};\nF{0} ~ M{0};\n", d.name);
    }
    if (!is_scaled()) {
      for (const auto& [from, to] :
           {std::pair("a", "b"), std::pair("b", "c"), std::pair("c", "a"), std::pair("a", "c")}) {
        for (const char i : {'x', 'y', 'z'}) {
          if (!computed().defines(fmt::format("{}_{}", from, i)) || !computed().defines(fmt::format("{}_{}", to, i)))
            continue;
          text += fmt::format("M{1}_{2} - M{0}_{2} -> {4}{2} - {3}{2};\n", from, to, i, upper(from), upper(to));
        }
      }
    }
    if (dot_) {
      const auto& [v, w, is_lhs] = *dot_;
      const std::string l = side(is_lhs, "");
      text += fmt::format("{0} ~ product;\n{0} - M{0} -> ({0} - product) + (product - M{0});\n", l);
      std::string second;
      for (const std::string_view i : components) {
        second += fmt::format("{3}({0}{2} - M{0}{2}) * ({1}{2} - M{1}{2})", v, w, i, second.empty() ? "" : " + ");
      }
      text += fmt::format("product - M{} -> (by_{} + by_{}) + ({});\n", l, w, v, second);
    }
    return text;
  }

  static std::string upper(const std::string& name) {
    return std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(name[0]))));
  }

  Setting setting_;
  Comparison which_;
  const Recording& recording_;
  std::optional<Dot> dot_;
  std::vector<WrittenProgram> programs_;  // computed, M, and F where the domain is scaled
};

}  // namespace

Files gappa_files() {
  Files files;
  for (const Form form : {Form::published, Form::reduced}) {
    for (const Contraction contraction : {Contraction::plain, Contraction::fma}) {
      const Recording recording = record(form, contraction);
      for (const Precision precision : {Precision::binary32, Precision::binary64}) {
        for (const Domain domain : {Domain::scaled, Domain::absolute}) {
          for (std::size_t k = 0; k < comparison_count; ++k) {
            const auto which = static_cast<Comparison>(k);
            const Setting setting{form, contraction, precision, domain};
            if (form != Form::published && is_shared(which)) continue;
            files[script_path(setting, which)] = Script(recording, setting, which).text();
          }
        }
      }
    }
  }
  return files;
}

}  // namespace axiscert::proofs
