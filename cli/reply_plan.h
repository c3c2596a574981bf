// A program's replies in place of a kernel: the options that say what they are, and the plan that judges them.
#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "plans/claimed_kernel.h"

namespace axiscert {

struct ReplyOptions : KernelClaims {
  std::vector<std::string> replies = {"-"};  // files, one for each precision; "-": standard input
  std::vector<std::string> meshes, queries;  // present paths of the files that the queries are of
};

// Adds all but the replies themselves: what the program claims, and where the files of its queries are.
void add_reply_options(CLI::App& command, ReplyOptions& options);
// Adds the present paths of those files alone.
void add_reply_files(CLI::App& command, ReplyOptions& options);

// The program, represented by a kernel that is never run, and the plan of which it is the one kernel.
struct ReplyPlan {
  std::shared_ptr<const Kernel> kernel;
  Plan plan;
};
// Reads all replies. Throws Error.
ReplyPlan reply_plan(const ReplyOptions& options);

}  // namespace axiscert
