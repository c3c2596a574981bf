// A kernel that is right, whose numbers beside its verdicts are changed after it gave them: a planted fault of
// contacts.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

using MeasureColumns = std::vector<std::vector<float>>;  // by measure, then by query of the batch
using MeasureEdit = std::function<void(MeasureColumns& measures, const QueryColumns<float>& batch, std::size_t i)>;

// `right` has to outlive the kernel, which claims nothing and exists in binary32 alone.
inline Kernel with_edit(const Kernel& right, const char* name, MeasureEdit change) {
  Kernel kernel = right;
  kernel.id = fmt::format("{}~{}", right.id, name);
  kernel.exposes = Exposure::verdict;
  kernel.formulae = "";
  kernel.is_reference = false;
  kernel.binary64 = nullptr;
  kernel.binary32 = [change, &right](std::string_view) {
    const Implementation<float> of_right = right.on<float>(scalar_target);
    Implementation<float> made;
    made.verdicts = of_right.verdicts;
    made.measure = [of_right, change](const QueryColumns<float>& batch, Answers<float>& out) {
      of_right.measure(batch, out);
      for (std::size_t i = 0; i < batch.size; ++i) change(out.measures, batch, i);
    };
    return made;
  };
  return kernel;
}

}  // namespace axiscert
