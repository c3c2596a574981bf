// A kernel as a plug-in offers it, in either version of the interface. It is read no further than its size goes, and
// called by its own version.
#pragma once

#include "kernel/include/axiscert/plugin.h"
#include "kernel/plugin/host/fault_handler.h"
#include "kernel/plugin/interface_1.h"

namespace axiscert::plugin {

struct OfferedKernel {
  // Nothing else is read of an unknown version, or where the size is too small.
  std::uint32_t abi = 0;
  axiscert_kernel says = {};  // members that the plug-in left out are zero; do not follow `limits`, use the copy below
  axiscert_limits limits = {};
  void (*run_1)(const interface_1::Batch*,
                const interface_1::Answers*) = nullptr;  // in version 1, in place of says.run
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

  void run() const { kernel_.run_1 ? kernel_.run_1(&batch_1_, &answers_1_) : kernel_.says.run(&batch_, &answers_); }

 private:
  void prepare(const Request& request, const Arrays& arrays);
  void prepare_1(const Request& request, const Arrays& arrays);

  const OfferedKernel& kernel_;
  axiscert_batch batch_ = {};
  axiscert_answers answers_ = {};
  const void* column_[AXISCERT_MOST_COLUMNS] = {};
  void *lhs_[AXISCERT_MOST_COMPARISONS] = {}, *rhs_[AXISCERT_MOST_COMPARISONS] = {};
  void* measure_[AXISCERT_MOST_MEASURES] = {};
  interface_1::Batch batch_1_ = {};
  interface_1::Answers answers_1_ = {};
};

}  // namespace axiscert::plugin
