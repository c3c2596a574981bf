// Where kernels are written, for the reports that point at a line of somebody's repository.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/run_info.h"
#include "kernel/kernel.h"

namespace axiscert {

// run.json's "sources": by kernel id, the file and line that --source gives, or that a plug-in says of itself; a kernel
// of which neither is known is left out. `given`: the values of --source, [KERNEL=]FILE:LINE, the last one for a kernel
// counts. A path inside the present folder is made relative to it. Throws Error for a value that has no line, names a
// file that is not there, or has no kernel that it could be about.
SourcePlaces source_places(const std::vector<const Kernel*>& kernels, const std::vector<std::string>& given);

}  // namespace axiscert
