// What `axiscert families`, `predicates` and `kernels` list.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/kernel_record.h"
#include "kernel/kernel.h"
#include "kernel/predicate.h"
#include "reports/instrument/data.h"

namespace axiscert {

struct ListedFamily {
  Name name, predicate;
  std::string purpose;
  std::uint64_t version = 0;
  bool exact_arithmetic = false;
  std::uint64_t cost = 1;

  static constexpr std::string_view about = "One generator of queries.";
  static constexpr auto fields(auto&& visit) {
    using Of = ListedFamily;
    return visit(
        field(&Of::name, {"name", "What --family takes."}),
        field(&Of::predicate, {"predicate", "The predicate of its queries."}),
        field(&Of::purpose, {"purpose", "What kind of queries it makes, and why."}),
        field(&Of::version, {"version", "Raised when its queries change; part of their addresses."}),
        field(&Of::exact_arithmetic,
              {"exact_arithmetic", "Whether formulae of degree 6 round nothing on its queries."}),
        field(&Of::cost, {"cost", "How many times as long as a query of `general` one of its queries takes."}));
  }
};

struct FamiliesData : DataHead<FamiliesData> {
  std::vector<ListedFamily> families;

  static constexpr std::string_view format = "axiscert-families/2", title = "The families",
                                    about = "`axiscert families --format json`. It depends on the version alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = FamiliesData;
    return visit(base<Of, DataHead<Of>>(), field(&Of::families, {"families", "Every family of the predicate."}));
  }
};

struct ListedColumn {
  Name name;
  Role role = Role::coordinate;
  std::string group;

  static constexpr auto fields(auto&& visit) {
    using Of = ListedColumn;
    return visit(field(&Of::name, {"name", "Its name."}), field(&Of::role, {"role", "What kind of number it is."}),
                 field(&Of::group, {"group", "Its place in a line of JSON."}));
  }
};
struct ListedEntry {
  Name name, validity;
  std::vector<ListedColumn> columns;

  static constexpr auto fields(auto&& visit) {
    using Of = ListedEntry;
    return visit(field(&Of::name, {"name", "Its name."}),
                 field(&Of::validity, {"validity", "What makes a query valid."}),
                 field(&Of::columns, {"columns", "Its numbers, in order."}));
  }
};
struct ListedComparison {
  Name name, clause;

  static constexpr auto fields(auto&& visit) {
    using Of = ListedComparison;
    return visit(field(&Of::name, {"name", "Its name."}),
                 field(&Of::clause, {"clause", "The clause that it belongs to."}));
  }
};
struct ListedClause {
  Name name;
  std::vector<Name> comparisons;

  static constexpr auto fields(auto&& visit) {
    using Of = ListedClause;
    return visit(field(&Of::name, {"name", "Its name."}),
                 field(&Of::comparisons, {"comparisons", "It holds where all of these do."}));
  }
};
struct ListedMeasure {
  Name name, unit, error;

  static constexpr auto fields(auto&& visit) {
    using Of = ListedMeasure;
    return visit(field(&Of::name, {"name", "Its name."}), field(&Of::unit, {"unit", "Its unit."}),
                 field(&Of::error, {"error", "How its error is stated."}));
  }
};
struct ListedWrongAnswer {
  Name name;
  Verdict said = Verdict::contact, right = Verdict::contact;

  static constexpr auto fields(auto&& visit) {
    using Of = ListedWrongAnswer;
    return visit(field(&Of::name, {"name", "Its name."}), field(&Of::said, {"said", "The verdict that was said."}),
                 field(&Of::right, {"right", "The verdict that is right."}));
  }
};

struct ListedPredicate {
  Name id, asks, rule, touching;
  std::vector<ListedEntry> entries;
  std::vector<ListedComparison> comparisons;
  std::vector<ListedClause> clauses;
  std::vector<ListedMeasure> measures;
  std::vector<Name> kernels, families;
  std::vector<ListedWrongAnswer> wrong_answers;

  static constexpr std::string_view about = "One question and its answers.";
  static constexpr auto fields(auto&& visit) {
    using Of = ListedPredicate;
    return visit(field(&Of::id, {"id", "What --predicate takes."}), field(&Of::asks, {"asks", "The question."}),
                 field(&Of::rule, {"rule", "How the comparisons make the verdict."}),
                 field(&Of::touching, {"touching", "The verdict where the two touch without overlapping."}),
                 field(&Of::entries, {"entries", "The forms in which a query is given."}),
                 field(&Of::comparisons, {"comparisons", "The comparisons, in the order of their bits."}),
                 field(&Of::clauses, {"clauses", "The clauses; in a predicate by separating axes, the axes."}),
                 field(&Of::measures, {"measures", "What a kernel may give beside a verdict."}),
                 field(&Of::kernels, {"kernels", "The ids of its built-in kernels."}),
                 field(&Of::families, {"families", "The names of its families."}),
                 field(&Of::wrong_answers, {"wrong_answers", "The kinds of wrong verdict."}));
  }
};

struct PredicatesData : DataHead<PredicatesData> {
  std::vector<ListedPredicate> predicates;

  static constexpr std::string_view format = "axiscert-predicates/2", title = "The predicates",
                                    about = "`axiscert predicates --format json`. It depends on the version alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = PredicatesData;
    return visit(base<Of, DataHead<Of>>(), field(&Of::predicates, {"predicates", "Every predicate."}));
  }
};

struct ListedArithmetic {
  Name id, arithmetic;
  std::string summary;
  std::vector<Precision> precisions;

  static constexpr auto fields(auto&& visit) {
    using Of = ListedArithmetic;
    return visit(field(&Of::id, {"id", "What --kernel takes."}),
                 field(&Of::arithmetic, {"arithmetic", "The name after the +."}),
                 field(&Of::summary, {"summary", "What it does."}),
                 field(&Of::precisions, {"precisions", "The precisions in which it exists."}));
  }
};

struct ListedKernel {
  Name id;
  std::string summary;
  Name predicate, entry;
  std::string formulae;
  std::vector<Precision> precisions;
  std::vector<Name> targets;
  std::vector<Exposure> exposes;
  bool may_decline = false;
  std::optional<Name> source;
  std::vector<FindingRow> findings;
  std::vector<ListedArithmetic> arithmetics;
  std::optional<std::vector<Name>> measures;
  std::optional<PolicyRecord> motion;

  static constexpr std::string_view about = "One kernel.";
  static constexpr auto fields(auto&& visit) {
    using Of = ListedKernel;
    return visit(
        field(&Of::id, {"id", "What --kernel takes."}),
        field(&Of::summary, {"summary", "What it computes, in a line."}),
        field(&Of::predicate, {"predicate", "The predicate whose question it answers."}),
        field(&Of::entry, {"entry", "The form in which it takes the numbers."}),
        field(&Of::formulae, {"formulae", "The formulae that it claims; none where its verdict alone is judged."}),
        field(&Of::precisions, {"precisions", "The precisions in which it exists."}),
        field(&Of::targets, {"targets", "The instruction sets on which it runs here; none for a plug-in."}),
        field(&Of::exposes, {"exposes", "What it shows, and so what is judged."}),
        field(&Of::may_decline, {"may_decline", "Whether it declares that it may answer `undecided`."}),
        field(&Of::source, {"source", "FILE:LINE of a plug-in that says where it is written; null otherwise."}),
        field(&Of::findings, {"findings", "What was wrong with loading it."}),
        field(&Of::arithmetics, {"arithmetics", "The same kernel in other arithmetics."}),
        field(
            &Of::measures,
            {.name = "measures", .about = "Of a predicate with measures, those that it gives.", .may_be_absent = true}),
        field(&Of::motion, {.name = "motion",
                            .about = "Of a predicate of motions, what it does not promise.",
                            .may_be_absent = true}));
  }
};

struct KernelsData : DataHead<KernelsData> {
  std::vector<ListedKernel> kernels;

  static constexpr std::string_view format = "axiscert-kernels/2", title = "The kernels",
                                    about =
                                        "`axiscert kernels --format json`. It depends on the build, and on the "
                                        "instruction sets of the machine.";
  static constexpr auto fields(auto&& visit) {
    using Of = KernelsData;
    return visit(
        base<Of, DataHead<Of>>(),
        field(&Of::kernels, {"kernels",
                             "Every built-in kernel of the predicate, then the plug-ins that come along; or those "
                             "of --kernel."}));
  }
};

}  // namespace axiscert
