// A kernel as a plug-in offers it. It is read no further than its size goes.
#pragma once

#include "kernel/include/axiscert/plugin.h"
#include "kernel/plugin/host/fault_handler.h"

namespace axiscert::plugin {

struct OfferedKernel {
  // Nothing else is read of another version, or where the size is too small.
  std::uint32_t abi = 0;
  axiscert_kernel says = {};  // members that the plug-in left out are zero; do not follow `limits`, use the copy below
  axiscert_limits limits = {};
};

// `kernel` is what axiscert_plugin returned, of any version.
OfferedKernel offered(const void* kernel);

// Copies the description to shared memory.
void describe(const OfferedKernel& kernel, Description& out);

// One call with the arrays where `arrays` has placed them.
class Call {
 public:
  Call(const OfferedKernel& kernel, const Request& request, const Arrays& arrays);
  // Not copied: it holds pointers to its own members.
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  void run() const { kernel_.says.run(&batch_, &answers_); }

 private:
  const OfferedKernel& kernel_;
  axiscert_batch batch_ = {};
  axiscert_answers answers_ = {};
  const void* column_[AXISCERT_MOST_COLUMNS] = {};
  void *lhs_[AXISCERT_MOST_COMPARISONS] = {}, *rhs_[AXISCERT_MOST_COMPARISONS] = {};
  void* measure_[AXISCERT_MOST_MEASURES] = {};
};

}  // namespace axiscert::plugin
