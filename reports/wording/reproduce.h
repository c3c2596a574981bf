// The commands that repeat a run, or one of its witnesses; and what the run did not check.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/run_folder/run_folder.h"

namespace axiscert {

// The text as a word of a shell's command: quoted where it needs to be.
std::string shell_word(const std::string& text);

// Shell commands. A name that a shell would interpret is quoted. Where replies were judged, PROGRAM stands for the
// program that gave them.
std::string replay_command(const WitnessRecord& witness, const PlanRecord& plan);
std::string replay_command(const FindingRecord& finding, const PlanRecord& plan);  // empty for one made in loading
std::string compare_command(const std::string& before, const std::string& after);  // of two folders' records
std::string run_command(const PlanRecord& plan);  // empty where the plan depended on the time available

// Labels and values: those of the plan, then those of run.json where there is one.
std::vector<std::pair<std::string, std::string>> plan_facts(const Run& run);

// Sentences, each about one thing that this run leaves open.
std::vector<std::string> not_checked(const Record& record);

}  // namespace axiscert
