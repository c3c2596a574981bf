// record.json: the deterministic result of a run.
#pragma once

#include <string_view>
#include <vector>

#include "fuzz/record/kernel_record.h"
#include "fuzz/record/plan_record.h"
#include "fuzz/record/witness_record.h"

namespace axiscert {

struct Record {
  FormatName<Record> schema;
  bool complete = true;
  PlanRecord plan;
  std::vector<KernelRecord> kernels;
  std::vector<FindingRecord> findings;
  std::vector<WitnessRecord> witnesses;

  static constexpr std::string_view format = "axiscert-record/5", title = "The deterministic result of an axiscert run",
                                    about = "No clock, host, thread count, target or compiler: those are in run.json.";
  static constexpr auto fields(auto&& visit) {
    using Of = Record;
    return visit(
        field(&Of::schema, {"schema", "The format of this file. A reader refuses any other."}),
        field(&Of::complete, {"complete", "False where the run was interrupted before its plan was done."}),
        field(&Of::plan, {"plan", {}}),
        field(
            &Of::kernels,
            {"kernels",
             "One entry for each kernel and precision. A kernel of the plan without an entry could not be loaded: its "
             "findings give the reason."}),
        field(&Of::findings,
              {"findings",
               "Faults of plug-ins other than wrong answers: one entry for each kernel, precision, family and kind."}),
        field(&Of::witnesses, {"witnesses", "Queries kept because they show a wrong answer or an extreme."}));
  }
};

}  // namespace axiscert
