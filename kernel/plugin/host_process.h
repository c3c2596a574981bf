// A process that hosts a plug-in, from axiscert's side: started when it is first asked, and again after it has died.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>

#include "kernel/finding.h"
#include "kernel/plugin/shared_memory.h"
#include "kernel/test.h"

namespace axiscert::plugin {

// A call that got no answer, and why.
struct Stop {
  FindingKind kind;  // crash, hang or out_of_bounds
  std::string detail;
  std::optional<std::size_t> query;  // of the call, where the fault says which
};

// The test that a process is asked for, and one of its entries. Without a test the plug-in is only loaded.
struct Subject {
  const TestDescription* test = nullptr;
  std::size_t entry = 0;

  Shape shape() const;
  // The name that plugin.h or the test gives an array: "ax", "verdict", "lhs[3]".
  std::string array_name(std::size_t array) const;
};

class HostProcess {
 public:
  // Throws Error where no process can be made. Nothing of the plug-in runs yet.
  explicit HostProcess(std::string path, const Subject& subject = {});
  ~HostProcess();
  HostProcess(const HostProcess&) = delete;
  HostProcess& operator=(const HostProcess&) = delete;

  // Loads the plug-in, unless it runs already. What it says of itself is in control() then.
  std::optional<Stop> start(double seconds);
  bool is_running() const { return child_ >= 0; }
  const Control& control() const { return *control_; }
  // A call; its inputs and outputs are at array(). After a stop the process is dead, and the next call starts another.
  // `seconds`: of the process's own time; twenty times that by the clock, for one that sleeps.
  std::optional<Stop> call(const Request& request, double seconds, Reply& reply);
  // The area of an array, area_bytes() long; array_offset() says where in it a call's array lies.
  std::byte* area(std::size_t array) const;
  const Shape& shape() const { return shape_; }
  std::size_t area_bytes() const { return area_size(page_); }

 private:
  void spawn();
  void end();
  std::optional<Stop> receive(double seconds, Reply& reply);
  Stop how_it_died();

  std::string path_;
  Subject subject_;
  Shape shape_;
  std::size_t page_;
  int memory_ = -1, socket_ = -1;
  pid_t child_ = -1;
  std::byte* mapped_ = nullptr;
  Control* control_ = nullptr;
};

// The program that hosts plug-ins: beside this executable, or where it is installed. Throws Error where there is none.
std::string host_program();
// A folder of plug-ins that come with axiscert, found in the same way; none where it was not built.
std::optional<std::string> shipped_folder(std::string_view name);

}  // namespace axiscert::plugin
