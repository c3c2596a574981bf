// What `axiscert check` says of one query.
#pragma once

#include <string>

#include "exact/examine.h"
#include "reports/record.h"

namespace axiscert {

// One line, without its end.
std::string check_text(const std::string& id, const Kernel& kernel, const Examination& found);
// "id", "kernel", "exact", "computed", "within_limits", "findings", "flips".
Json check_json(const std::string& id, const Kernel& kernel, const Examination& found);

}  // namespace axiscert
