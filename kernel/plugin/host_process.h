// A process that hosts a plug-in or a program, from axiscert's side: started when it is first asked, and again after it
// has died.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/outcome.h"
#include "kernel/plugin/shared_memory.h"
#include "kernel/predicate.h"

namespace axiscert::plugin {

// A call that got no answer, and why.
struct Stop {
  FindingKind kind;  // crash, hang or out_of_bounds; of a program also load, inconsistent
  std::string detail;
  std::optional<std::size_t> query;  // of the call, where the fault says which; of a program, the first without a reply
};

// The plug-in or program that a process hosts.
struct HostedPlugin {
  std::string path;                  // of a shared object; of a program, the folder in which it runs
  std::vector<std::string> command;  // of a program, its words; empty: a shared object
  bool is_program() const { return !command.empty(); }
};

// The predicate that a process is asked for, and one of its entries. Without a predicate the plug-in is only loaded.
struct Subject {
  const Predicate* predicate = nullptr;
  std::size_t entry = 0;
  std::size_t measures = 0;  // of a program: those that each of its replies gives

  Shape shape() const;
  // The name that plugin.h or the predicate gives an array: "ax", "verdict", "lhs[3]".
  std::string array_name(std::size_t array) const;
};

class HostProcess {
 public:
  // Throws Error where no process can be made. Nothing of the plug-in runs yet.
  explicit HostProcess(HostedPlugin hosted, const Subject& subject = {});
  ~HostProcess();
  HostProcess(const HostProcess&) = delete;
  HostProcess& operator=(const HostProcess&) = delete;

  // Loads the plug-in, unless it runs already. What it says of itself is in control() then.
  std::optional<Stop> start(double seconds);
  bool is_running() const { return child_ >= 0; }
  const Control& control() const { return *control_; }
  // A call; its inputs and outputs are at array(). After a stop the process is dead, and the next call starts another.
  // `seconds`: of the process's own time; clock_to_processor times that by the clock, for one that sleeps. Of a program
  // the host looks at the time (Request), and the process stays.
  std::optional<Stop> call(const Request& request, double seconds, Reply& reply);
  // The area of an array, area_bytes() long; array_offset() says where in it a call's array lies.
  std::byte* area(std::size_t array) const;
  const Shape& shape() const { return shape_; }
  std::size_t area_bytes() const { return area_size(page_); }

 private:
  void spawn();
  void end();
  std::optional<Stop> receive(double seconds, Reply& reply);
  std::optional<Stop> call_program(const Request& request, Reply& reply);
  void write_headers();
  Stop how_it_died();

  HostedPlugin hosted_;
  Subject subject_;
  Shape shape_;
  std::size_t page_;
  int memory_ = -1, socket_ = -1;
  pid_t child_ = -1;
  std::byte* mapped_ = nullptr;
  Control* control_ = nullptr;
};

// Bits of Reply::changed in words: "the rounding mode, flushing of subnormal numbers to zero".
std::string changed_modes_text(std::uint32_t changed);

// The program that hosts plug-ins: beside this executable, or where it is installed. Throws Error where there is none.
std::string host_program();
// A folder of plug-ins that come with axiscert, found in the same way; none where it was not built.
std::optional<std::string> shipped_folder(std::string_view name);

}  // namespace axiscert::plugin
