// The struct of run.json: what varies between runs of the same plan.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/trait/batch_oracle.h"
#include "fuzz/fields/json_form.h"
#include "kernel/names.h"

namespace axiscert {

struct MachineInfo {
  std::string cpu;
  static constexpr auto fields(auto&& visit) {
    return visit(field(&MachineInfo::cpu, {"cpu", "The processor's own name."}));
  }
};

struct TargetInfo {
  std::string asked, dispatched;
  static constexpr auto fields(auto&& visit) {
    return visit(field(&TargetInfo::asked, {"asked", "The target as given to --target."}),
                 field(&TargetInfo::dispatched, {"dispatched", "The one that ran."}));
  }
};

struct CellSpeed {
  Name family;
  Precision precision = Precision::binary32;
  std::uint64_t queries = 0;
  double core_seconds = 0;
  std::optional<double> rate;

  static constexpr auto fields(auto&& visit) {
    using Of = CellSpeed;
    return visit(field(&Of::family, {"family", "The family."}), field(&Of::precision, {"precision", "The precision."}),
                 field(&Of::queries, {"queries", "Number of queries."}),
                 field(&Of::core_seconds, {"seconds_of_core", "Time spent, summed over threads.", "s"}),
                 field(&Of::rate, {"queries_per_second_and_core",
                                   "The quotient of the two; null where no time was measured.", "1/s"}));
  }
};

// The time of a step, divided by all queries of the cell, including those that it never saw or passed on.
struct StepTimes {
  double generation = 0, kernels = 0, lanes = 0, grid = 0, wide = 0, integers = 0, sides = 0, judging = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = StepTimes;
    return visit(field(&Of::generation, {"generation", "Of the queries."}),
                 field(&Of::kernels, {"kernels", "Answers."}), field(&Of::lanes, {"lanes", "Signs."}),
                 field(&Of::grid, {"grid", "Signs."}), field(&Of::wide, {"wide", "Signs."}),
                 field(&Of::integers, {"integers", "Signs."}), field(&Of::sides, {"sides", "Errors of the signs."}),
                 field(&Of::judging, {"judging", "The rest, including exact arithmetic."}));
  }
};

using StepQueries = EnumArray<Step, std::uint64_t>;
struct CellSteps {
  Name family;
  Precision precision = Precision::binary32;
  StepQueries queries{};
  NamedValues<StepQueries> signs;
  std::uint64_t checked = 0, by_cgal = 0;
  StepTimes times;

  static constexpr auto fields(auto&& visit) {
    using Of = CellSteps;
    return visit(
        field(&Of::family, {"family", "The family."}), field(&Of::precision, {"precision", "The precision."}),
        field(
            &Of::queries,
            {"queries",
             "Queries decided by each step: lanes, the SIMD filter; grid, integers of a few words; wide, doubles with "
             "a bound and an exponent of their own; integers, of any size; exact, Mpzf and CGAL."}),
        field(&Of::signs, {"signs", "For each comparison, the signs decided by each step. Empty without filters."}),
        field(&Of::checked, {"checked", "Queries that a filter decided and exact arithmetic decided again."}),
        field(&Of::by_cgal, {"decided_by_cgal", "The same count for this cell."}),
        field(&Of::times, {"nanoseconds_per_query", "Wall time, over all queries of the cell.", "ns"}));
  }
};

// The work of one rank and the resources it used.
struct RankUse {
  int threads = 0;
  std::uint64_t tasks = 0, peak_memory = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = RankUse;
    return visit(field(&Of::threads, {"threads", "Worker threads."}),
                 field(&Of::tasks, {"stretches", "Number of stretches that it did in this run."}),
                 field(&Of::peak_memory, {"peak_memory_bytes", "The peak memory of the rank.", "bytes"}));
  }
};

struct RunScale {
  std::string plan_digest;
  std::uint64_t stretches = 0, units_per_stretch = 0, units_lost = 0, journal_bytes = 0;
  std::vector<RankUse> ranks;

  static constexpr auto fields(auto&& visit) {
    using Of = RunScale;
    return visit(
        field(&Of::plan_digest, {"plan_digest", "SHA-256 of the plan file."}),
        field(&Of::stretches, {"stretches", "Parts in which the units were handed out."}),
        field(&Of::units_per_stretch, {"units_per_stretch", "Number of units in each stretch."}),
        field(&Of::units_lost, {"units_lost", "Units that a lost process had begun and that were done again."}),
        field(&Of::journal_bytes, {"journal_bytes", "Length of the journal, or of all of them.", "bytes"}),
        field(&Of::ranks, {"ranks", "By rank, rank 0 first. Empty after a merge."}));
  }
};

struct SourcePlace {
  Name file;
  std::uint64_t line = 1;

  static constexpr auto fields(auto&& visit) {
    using Of = SourcePlace;
    return visit(field(&Of::file, {"file", "Path, relative to the folder in which axiscert ran where it is inside."}),
                 field(&Of::line, {"line", "The line, from 1 on."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = RunInfo;
    return visit(
        field(&Of::schema, {"schema", "The format of this file."}),
        field(&Of::started, {"started", "The start of the run, ISO 8601 with its zone."}),
        field(&Of::seconds, {"seconds", "Wall-clock length of the run.", "s"}),
        field(&Of::threads, {"threads", "Worker threads."}),
        field(&Of::machine, {"machine", "The machine that it ran on."}),
        field(&Of::compiler, {"compiler", "The compiler that built axiscert."}),
        field(&Of::flags, {"flags", "The options that all kernels were compiled with; others change no rounding."}),
        field(&Of::revision,
              {"revision", "The commit of axiscert, with -dirty where the tree differed; unknown without one."}),
        field(&Of::target, {"target", "The kernel's instruction set."}),
        field(&Of::versions, {"versions", "The versions of axiscert and of the libraries on which its truth depends."}),
        field(&Of::throughput, {"throughput", "Speed of the whole chain, judge included."}),
        field(&Of::second_opinions, {"second_opinions", "Queries that the second oracle decided again."}),
        field(&Of::exact_only,
              {"exact_only", "Whether everything was decided by CGAL, arbitrary precision and MPFR, without filters."}),
        field(&Of::steps, {"steps", "The steps that decided the signs of the queries, and their times."}),
        field(&Of::by_cgal,
              {"decided_by_cgal",
               "Valid queries whose verdict CGAL decided itself: those that the filters left open, a sample of the "
               "others, close calls."}),
        field(
            &Of::sources,
            {"sources",
             "Where each kernel is written, by its id: by --source, or as a plug-in says of itself. Kernels without a "
             "known place are left out."}),
        field(&Of::scale, {.name = "scale",
                           .about = "Of a plan that was carried out with a journal: by ranks, in shards, or after an "
                                    "interruption. The length of the run is then that of its last process.",
                           .may_be_absent = true}));
  }
};

}  // namespace axiscert
