// One query and what one kernel says of it: a row of `axiscert check` for a range of queries.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/record/witness_record.h"
#include "kernel/finding.h"
#include "kernel/names.h"
#include "reports/instrument/data.h"

namespace axiscert {

struct ExactRow {
  Verdict verdict = Verdict::contact;
  bool touching = false;
  std::optional<double> depth;
  std::optional<Name> input_class;
  std::optional<BitText> comparisons;
  NamedValues<Json> details;  // of the predicate, by name

  static constexpr std::string_view about =
      "The exact answer, with what the predicate's oracles know of a valid query besides, as `axiscert check` has it.";
  static constexpr auto fields(auto&& visit) {
    using Of = ExactRow;
    return visit(
        field(&Of::verdict, {"verdict", "The geometric truth; invalid: the numbers are no query."}),
        field(&Of::touching, {"touching", "Whether the two touch, exactly; then the verdict is contact."}),
        field(&Of::depth, {"depth",
                           "How far the query is from touching, whatever the kernel says; null where it is invalid, "
                           "and in a predicate "
                           "without a depth.",
                           "of the scene"}),
        field(&Of::input_class,
              {.name = "class",
               .about = "The class of the input, the first whose definition it meets. Absent where it is invalid, and "
                        "in a predicate without classes.",
               .may_be_absent = true}),
        field(&Of::comparisons,
              {"comparisons",
               "The comparisons in exact arithmetic, one 0 or 1 each; null where it is invalid, and where there are "
               "none."}),
        rest(&Of::details));
  }
};

struct ComputedRow {
  Verdict verdict = Verdict::contact;
  std::optional<BitText> comparisons;

  static constexpr std::string_view about = "The kernel's answer.";
  static constexpr auto fields(auto&& visit) {
    using Of = ComputedRow;
    return visit(field(&Of::verdict, {"verdict", "Its verdict; unanswered: it crashed or hung."}),
                 field(&Of::comparisons,
                       {"comparisons", "Its comparisons, one 0 or 1 each; null where it does not show them."}));
  }
};

struct QueryRow : DataHead<QueryRow> {
  Name address;
  NamedValues<GroupNumbers> numbers;  // of the query, by group of columns
  Name kernel, standing;
  bool wrong = false;
  std::vector<Link> links;
  ExactRow exact;
  ComputedRow computed;
  std::vector<FindingKind> findings;
  std::optional<std::optional<MeasuresRecord>> measures;

  static constexpr std::string_view format = "axiscert-row/1", title = "A query and one kernel's answer to it",
                                    about =
                                        "The numbers of the query have the names of the groups of columns of its "
                                        "predicate.";
  static constexpr auto fields(auto&& visit) {
    using Of = QueryRow;
    return visit(
        base<Of, DataHead<Of>>(),
        field(&Of::address, {"address", "The address from which `axiscert query` makes it again."}), rest(&Of::numbers),
        field(&Of::kernel, {"kernel", "The kernel that was asked."}),
        field(&Of::standing,
              {"standing",
               "decided; declined; undeclared_decline, called_invalid, unanswered: faults; outside_limits: it promises "
               "nothing there; no_query: invalid. Only decided shows whether the kernel is right."}),
        field(&Of::wrong,
              {"wrong",
               "Whether its verdict is wrong, by its own convention where the two touch. With the standing decided it "
               "is a missed contact of a run where it says separated, a phantom contact where it says contact."}),
        field(&Of::links, {"links", "The broken links of a wrong verdict."}), field(&Of::exact, {"exact", {}}),
        field(&Of::computed, {"computed", {}}),
        field(&Of::findings, {"findings", "Its faults other than a wrong answer, by kind."}),
        field(&Of::measures, {.name = "measures", .about = MeasuresRecord::about, .may_be_absent = true}));
  }
};

}  // namespace axiscert
