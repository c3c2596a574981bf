// Every process that this one has started, and those that they started, as far as they have not ended: whatever group
// or session they are in. This process has to be their subreaper, so that those whose parent has ended are its
// children.
#pragma once

#include <sys/types.h>

#include <optional>

namespace axiscert::plugin {

// Processor time in seconds that all of them have used, those that have ended included.
double tree_seconds();

// Kills all of them, and returns when none is left. The status of `first` as waitpid has it; nothing where it had none
// any more.
std::optional<int> kill_tree(pid_t first);

}  // namespace axiscert::plugin
