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

  static constexpr std::string_view format = "axiscert-record/8", title = "The deterministic result of an axiscert run",
                                    about = "No clock, host, thread count, target or compiler: those are in run.json.";
  AXISCERT_FIELDS(
      Record, AXISCERT_FIELD(schema, "The format of this file. A reader refuses any other."),
      AXISCERT_FIELD(complete, "False where the run was interrupted before its plan was done."), AXISCERT_FIELD(plan),
      AXISCERT_FIELD(kernels,
                     "One entry for each kernel and precision. A kernel of the plan without an entry could not be "
                     "loaded: its findings give the reason."),
      AXISCERT_FIELD(
          findings,
          "Faults of plug-ins other than wrong answers: one entry for each kernel, precision, family and kind."),
      AXISCERT_FIELD(witnesses, "Queries kept because they show a wrong answer or an extreme."))
};

}  // namespace axiscert
