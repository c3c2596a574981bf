// The struct of run.json: what varies between runs of the same plan.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/batch_oracle.h"
#include "fuzz/text/values.h"
#include "kernel/names.h"

namespace axiscert {

struct MachineInfo {
  std::string cpu;
  AXISCERT_FIELDS(MachineInfo, AXISCERT_FIELD(cpu, "The processor's own name."))
};

struct TargetInfo {
  std::string asked, dispatched;
  AXISCERT_FIELDS(TargetInfo, AXISCERT_FIELD(asked, "The target as given to --target."),
                  AXISCERT_FIELD(dispatched, "The one that ran."))
};

struct CellSpeed {
  Name family;
  Precision precision = Precision::binary32;
  std::uint64_t queries = 0;
  double core_seconds = 0;
  std::optional<double> rate;

  AXISCERT_FIELDS(CellSpeed, AXISCERT_FIELD(family, "The family."), AXISCERT_FIELD(precision, "The precision."),
                  AXISCERT_FIELD(queries, "Number of queries."),
                  field(&Of::core_seconds, {"seconds_of_core", "Time spent, summed over threads.", "s"}),
                  field(&Of::rate, {"queries_per_second_and_core",
                                    "The quotient of the two; null where no time was measured.", "1/s"}))
};

// The time of a step, divided by all queries of the cell, including those that it never saw or passed on.
struct StepTimes {
  double generation = 0, kernels = 0, lanes = 0, grid = 0, wide = 0, integers = 0, sides = 0, judging = 0;

  AXISCERT_FIELDS(StepTimes, AXISCERT_FIELD(generation, "Of the queries."), AXISCERT_FIELD(kernels, "Answers."),
                  AXISCERT_FIELD(lanes, "Signs."), AXISCERT_FIELD(grid, "Signs."), AXISCERT_FIELD(wide, "Signs."),
                  AXISCERT_FIELD(integers, "Signs."), AXISCERT_FIELD(sides, "Errors of the signs."),
                  AXISCERT_FIELD(judging, "The rest, including exact arithmetic."))
};

using StepQueries = EnumArray<Step, std::uint64_t>;
struct CellSteps {
  Name family;
  Precision precision = Precision::binary32;
  StepQueries queries{};
  NamedValues<StepQueries> signs;
  std::uint64_t checked = 0, by_cgal = 0;
  StepTimes times;

  AXISCERT_FIELDS(
      CellSteps, AXISCERT_FIELD(family, "The family."), AXISCERT_FIELD(precision, "The precision."),
      AXISCERT_FIELD(queries,
                     "Queries decided by each step: lanes, the SIMD filter; grid, integers of a few words; wide, "
                     "doubles with a bound and an exponent of their own; integers, of any size; exact, Mpzf and CGAL."),
      AXISCERT_FIELD(signs, "For each comparison, the signs decided by each step. Empty without filters."),
      AXISCERT_FIELD(checked, "Queries that a filter decided and exact arithmetic decided again."),
      field(&Of::by_cgal, {"decided_by_cgal", "The same count for this cell."}),
      field(&Of::times, {"nanoseconds_per_query", "Wall time, over all queries of the cell.", "ns"}))
};

// The work of one rank and the resources it used.
struct RankUse {
  int threads = 0;
  std::uint64_t tasks = 0, peak_memory = 0;

  AXISCERT_FIELDS(RankUse, AXISCERT_FIELD(threads, "Worker threads."),
                  field(&Of::tasks, {"stretches", "Number of stretches that it did in this run."}),
                  field(&Of::peak_memory, {"peak_memory_bytes", "The peak memory of the rank.", "bytes"}))
};

struct RunScale {
  std::string plan_digest;
  std::uint64_t stretches = 0, units_per_stretch = 0, units_lost = 0, journal_bytes = 0;
  std::vector<RankUse> ranks;

  AXISCERT_FIELDS(RunScale, AXISCERT_FIELD(plan_digest, "SHA-256 of the plan file."),
                  AXISCERT_FIELD(stretches, "Parts in which the units were handed out."),
                  AXISCERT_FIELD(units_per_stretch, "Number of units in each stretch."),
                  AXISCERT_FIELD(units_lost, "Units that a lost process had begun and that were done again."),
                  AXISCERT_FIELD(journal_bytes, "Length of the journal, or of all of them.", "bytes"),
                  AXISCERT_FIELD(ranks, "By rank, rank 0 first. Empty after a merge."))
};

struct SourcePlace {
  Name file;
  std::uint64_t line = 1;

  AXISCERT_FIELDS(SourcePlace,
                  AXISCERT_FIELD(file, "Path, relative to the folder in which axiscert ran where it is inside."),
                  AXISCERT_FIELD(line, "The line, from 1 on."))
};
using SourcePlaces = NamedValues<SourcePlace>;

struct RunInfo {
  FormatName<RunInfo> schema;
  std::string started;
  double seconds = 0;
  std::uint64_t threads = 0;
  MachineInfo machine;
  std::string compiler, flags, revision;
  TargetInfo target;
  NamedValues<std::string> versions;
  std::vector<CellSpeed> throughput;
  std::uint64_t second_opinions = 0;
  bool exact_only = false;
  std::vector<CellSteps> steps;
  std::uint64_t by_cgal = 0;
  SourcePlaces sources;
  std::optional<RunScale> scale;

  static constexpr std::string_view format = "axiscert-run/2", title = "What varies between runs of the same plan";
  static constexpr std::string_view about =
      "Times, machine, targets and versions. Readers ignore members that they do not know.";
  static constexpr bool is_open = true;
  AXISCERT_FIELDS(
      RunInfo, AXISCERT_FIELD(schema, "The format of this file."),
      AXISCERT_FIELD(started, "The start of the run, ISO 8601 with its zone."),
      AXISCERT_FIELD(seconds, "Wall-clock length of the run.", "s"), AXISCERT_FIELD(threads, "Worker threads."),
      AXISCERT_FIELD(machine, "The machine that it ran on."),
      AXISCERT_FIELD(compiler, "The compiler that built axiscert."),
      AXISCERT_FIELD(flags, "The options that all kernels were compiled with; others change no rounding."),
      AXISCERT_FIELD(revision, "The commit of axiscert, with -dirty where the tree differed; unknown without one."),
      AXISCERT_FIELD(target, "The kernel's instruction set."),
      AXISCERT_FIELD(versions, "The versions of axiscert and of the libraries on which its truth depends."),
      AXISCERT_FIELD(throughput, "Speed of the whole chain, judge included."),
      AXISCERT_FIELD(second_opinions, "Queries that the second oracle decided again."),
      AXISCERT_FIELD(exact_only,
                     "Whether everything was decided by CGAL, arbitrary precision and MPFR, without filters."),
      AXISCERT_FIELD(steps, "The steps that decided the signs of the queries, and their times."),
      field(&Of::by_cgal,
            {"decided_by_cgal",
             "Valid queries whose verdict CGAL decided itself: those that the filters left open, a sample of the "
             "others, close calls."}),
      AXISCERT_FIELD(sources,
                     "Where each kernel is written, by its id: by --source, or as a plug-in says of itself. Kernels "
                     "without a known place are left out."),
      AXISCERT_OPTIONAL_FIELD(scale,
                              "Of a plan that was carried out with a journal: by ranks, in shards, or after an "
                              "interruption. The length of the run is then that of its last process."))
};

}  // namespace axiscert
