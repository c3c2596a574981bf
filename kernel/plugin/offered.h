// A kernel as a plug-in hands it out, by either version of the interface: read no further than it says that it goes,
// and called as it expects.
#pragma once

#include "kernel/include/axiscert/plugin.h"
#include "kernel/plugin/fault_handler.h"
#include "kernel/plugin/interface_1.h"

namespace axiscert::plugin {

struct Offered {
  // Of a version that is not known, or where the size is too small to be one, nothing else is read.
  std::uint32_t abi = 0;
  axiscert_kernel says = {};  // what the plug-in left out is zero; `limits` is not to be followed, see below
  axiscert_limits limits = {};
  void (*run_1)(const interface_1::Batch*,
                const interface_1::Answers*) = nullptr;  // of version 1, in place of says.run
};

// `kernel` points to whatever axiscert_plugin gave.
Offered offered(const void* kernel);

// Its words, copied to where they are shared.
void describe(const Offered& kernel, Description& out);

// One call, its arrays where `arrays` has placed them.
class Call {
 public:
  Call(const Offered& kernel, const Request& request, const Arrays& arrays);
  // It holds addresses of its own.
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  void run() const { kernel_.run_1 ? kernel_.run_1(&batch_1_, &answers_1_) : kernel_.says.run(&batch_, &answers_); }

 private:
  void prepare(const Request& request, const Arrays& arrays);
  void prepare_1(const Request& request, const Arrays& arrays);

  const Offered& kernel_;
  axiscert_batch batch_ = {};
  axiscert_answers answers_ = {};
  const void* column_[AXISCERT_MOST_COLUMNS] = {};
  void *lhs_[AXISCERT_MOST_COMPARISONS] = {}, *rhs_[AXISCERT_MOST_COMPARISONS] = {};
  void* measure_[AXISCERT_MOST_MEASURES] = {};
  interface_1::Batch batch_1_ = {};
  interface_1::Answers answers_1_ = {};
};

}  // namespace axiscert::plugin
