// How a run, and each of its witnesses, is made again; and what it did not check.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/run_folder/run_folder.h"

namespace axiscert {

// As a word of a shell's command: in quotes where it is not plain.
std::string shell_word(const std::string& text);

// Shell commands. A name that a shell would read otherwise is quoted. Where replies were judged, PROGRAM stands for
// what gave them.
std::string replay_command(const Json& witness, const Json& plan);
std::string compare_command(const std::string& before, const std::string& after);  // of two folders
std::string run_command(const Json& plan);  // empty where the plan depended on the time it had

// Label and value: the plan's, then those of run.json where there is one.
std::vector<std::pair<std::string, std::string>> plan_facts(const Run& run);

// Sentences, each on one thing that this run leaves open.
std::vector<std::string> not_checked(const Json& record);

}  // namespace axiscert
