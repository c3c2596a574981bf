// Compares what a certificate states of its kernels with what the kernels here declare.
#pragma once

#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "reports/certificate/statement/certificate_data.h"

namespace axiscert {

// How a kernel's entry in a certificate differs from what the kernel declares, given by these files or built in: a
// sentence for each part of it that does.
std::vector<std::string> declared_differences(const KernelMaterial& stated, const std::vector<FileInfo>& plugins,
                                              const Kernel& kernel, Precision precision);

// How the numbers of triangles of the kernels' entries differ from those of the families asked. A family that was not
// asked is left out.
std::vector<std::string> triangle_differences(const CertificatePredicate& predicate, const Questions& questions);

}  // namespace axiscert
