// Compares what a certificate states of its kernels with what the kernels here declare.
#pragma once

#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/text/json.h"

namespace axiscert {

// How a kernel's entry in a certificate differs from what the kernel declares: a sentence for each part of it that
// does.
std::vector<std::string> declared_differences(const Json& stated, const Plan& plan, const Kernel& kernel,
                                              Precision precision);

// How the numbers of triangles of the kernels' entries differ from those of the plan's families. A family that the plan
// does not have is left out.
std::vector<std::string> triangle_differences(const Json& predicate, const Plan& plan);

}  // namespace axiscert
