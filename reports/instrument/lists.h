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
  AXISCERT_FIELDS(ListedFamily, AXISCERT_FIELD(name, "What --family takes."),
                  AXISCERT_FIELD(predicate, "The predicate of its queries."),
                  AXISCERT_FIELD(purpose, "What kind of queries it makes, and why."),
                  AXISCERT_FIELD(version, "Raised when its queries change; part of their addresses."),
                  AXISCERT_FIELD(exact_arithmetic, "Whether formulae of degree 6 round nothing on its queries."),
                  AXISCERT_FIELD(cost, "How many times as long as a query of `general` one of its queries takes."))
};

struct FamiliesData : DataHead<FamiliesData> {
  std::vector<ListedFamily> families;

  static constexpr std::string_view format = "axiscert-families/2", title = "The families",
                                    about = "`axiscert families --format json`. It depends on the version alone.";
  AXISCERT_FIELDS(FamiliesData, base<Of, DataHead<Of>>(), AXISCERT_FIELD(families, "Every family of the predicate."))
};

struct ListedColumn {
  Name name;
  Role role = Role::coordinate;
  std::string group;

  AXISCERT_FIELDS(ListedColumn, AXISCERT_FIELD(name, "Its name."), AXISCERT_FIELD(role, "What kind of number it is."),
                  AXISCERT_FIELD(group, "Its place in a line of JSON."))
};
struct ListedEntry {
  Name name, validity;
  std::vector<ListedColumn> columns;

  AXISCERT_FIELDS(ListedEntry, AXISCERT_FIELD(name, "Its name."), AXISCERT_FIELD(validity, "What makes a query valid."),
                  AXISCERT_FIELD(columns, "Its numbers, in order."))
};
struct ListedComparison {
  Name name, clause;

  AXISCERT_FIELDS(ListedComparison, AXISCERT_FIELD(name, "Its name."),
                  AXISCERT_FIELD(clause, "The clause that it belongs to."))
};
struct ListedClause {
  Name name;
  std::vector<Name> comparisons;

  AXISCERT_FIELDS(ListedClause, AXISCERT_FIELD(name, "Its name."),
                  AXISCERT_FIELD(comparisons, "It holds where all of these do."))
};
struct ListedMeasure {
  Name name, unit, error;

  AXISCERT_FIELDS(ListedMeasure, AXISCERT_FIELD(name, "Its name."), AXISCERT_FIELD(unit, "Its unit."),
                  AXISCERT_FIELD(error, "How its error is stated."))
};
struct ListedWrongAnswer {
  Name name;
  Verdict said = Verdict::contact, right = Verdict::contact;

  AXISCERT_FIELDS(ListedWrongAnswer, AXISCERT_FIELD(name, "Its name."),
                  AXISCERT_FIELD(said, "The verdict that was said."),
                  AXISCERT_FIELD(right, "The verdict that is right."))
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
  AXISCERT_FIELDS(ListedPredicate, AXISCERT_FIELD(id, "What --predicate takes."), AXISCERT_FIELD(asks, "The question."),
                  AXISCERT_FIELD(rule, "How the comparisons make the verdict."),
                  AXISCERT_FIELD(touching, "The verdict where the two touch without overlapping."),
                  AXISCERT_FIELD(entries, "The forms in which a query is given."),
                  AXISCERT_FIELD(comparisons, "The comparisons, in the order of their bits."),
                  AXISCERT_FIELD(clauses, "The clauses; in a predicate by separating axes, the axes."),
                  AXISCERT_FIELD(measures, "What a kernel may give beside a verdict."),
                  AXISCERT_FIELD(kernels, "The ids of its built-in kernels."),
                  AXISCERT_FIELD(families, "The names of its families."),
                  AXISCERT_FIELD(wrong_answers, "The kinds of wrong verdict."))
};

struct PredicatesData : DataHead<PredicatesData> {
  std::vector<ListedPredicate> predicates;

  static constexpr std::string_view format = "axiscert-predicates/2", title = "The predicates",
                                    about = "`axiscert predicates --format json`. It depends on the version alone.";
  AXISCERT_FIELDS(PredicatesData, base<Of, DataHead<Of>>(), AXISCERT_FIELD(predicates, "Every predicate."))
};

struct ListedArithmetic {
  Name id, arithmetic;
  std::string summary;
  std::vector<Precision> precisions;

  AXISCERT_FIELDS(ListedArithmetic, AXISCERT_FIELD(id, "What --kernel takes."),
                  AXISCERT_FIELD(arithmetic, "The name after the +."), AXISCERT_FIELD(summary, "What it does."),
                  AXISCERT_FIELD(precisions, "The precisions in which it exists."))
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
  AXISCERT_FIELDS(ListedKernel, AXISCERT_FIELD(id, "What --kernel takes."),
                  AXISCERT_FIELD(summary, "What it computes, in a line."),
                  AXISCERT_FIELD(predicate, "The predicate whose question it answers."),
                  AXISCERT_FIELD(entry, "The form in which it takes the numbers."),
                  AXISCERT_FIELD(formulae, "The formulae that it claims; none where its verdict alone is judged."),
                  AXISCERT_FIELD(precisions, "The precisions in which it exists."),
                  AXISCERT_FIELD(targets, "The instruction sets on which it runs here; none for a plug-in."),
                  AXISCERT_FIELD(exposes, "What it shows, and so what is judged."),
                  AXISCERT_FIELD(may_decline, "Whether it declares that it may answer `undecided`."),
                  AXISCERT_FIELD(source, "FILE:LINE of a plug-in that says where it is written; null otherwise."),
                  AXISCERT_FIELD(findings, "What was wrong with loading it."),
                  AXISCERT_FIELD(arithmetics, "The same kernel in other arithmetics."),
                  AXISCERT_OPTIONAL_FIELD(measures, "Of a predicate with measures, those that it gives."),
                  AXISCERT_OPTIONAL_FIELD(motion, "Of a predicate of motions, what it does not promise."))
};

struct KernelsData : DataHead<KernelsData> {
  std::vector<ListedKernel> kernels;

  static constexpr std::string_view format = "axiscert-kernels/2", title = "The kernels",
                                    about =
                                        "`axiscert kernels --format json`. It depends on the build, and on the "
                                        "instruction sets of the machine.";
  AXISCERT_FIELDS(
      KernelsData, base<Of, DataHead<Of>>(),
      AXISCERT_FIELD(
          kernels, "Every built-in kernel of the predicate, then the plug-ins that come along; or those of --kernel."))
};

}  // namespace axiscert
