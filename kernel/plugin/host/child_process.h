// The process of a program: the end of its standard error, and the processes that it started.
#pragma once

#include <sys/types.h>

#include <optional>
#include <span>
#include <string>

namespace axiscert::plugin {
// The end of what a program says on standard error: its last few thousand bytes, however many there are.
class ErrorOutput {
 public:
  void add(std::span<const char> bytes);
  void clear() { kept_.clear(); }
  // The last line that says something: not a place in a stack, nor the interpreter's version. Empty where there is
  // none.
  std::string last_line() const;

 private:
  std::string kept_;
};

// Every process that this one has started, and those that they started, as far as they have not ended: whatever group
// or session they are in. This process has to be their subreaper, so that those whose parent has ended are its
// children.

// Processor time in seconds that all of them have used, those that have ended included.
double tree_seconds();

// Kills all of them, and returns when none is left. The status of `first` as waitpid has it; nothing where it had none
// any more.
std::optional<int> kill_tree(pid_t first);

}  // namespace axiscert::plugin
