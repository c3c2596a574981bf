// Output of `axiscert check` for one query.
#pragma once

#include <string>

#include "exact/sphere_triangle/claims/examine.h"
#include "fuzz/search/confirm.h"
#include "fuzz/confirm/record.h"

namespace axiscert {

// One line, without its line end.
std::string check_text(const std::string& id, const Kernel& kernel, const Examination& found);
// An object with "id", "kernel", "exact", "computed", "within_limits", "findings" and "flips".
Json check_json(const std::string& id, const Kernel& kernel, const Examination& found);

// The errors of the computed sides: as text, one line for each comparison, to follow check_text's; as JSON, for
// check_json, an object of "absolute_u" and "relative_u" by comparison, null where there is none.
std::string errors_text(const std::optional<SideErrors>& errors);
Json errors_json(const std::optional<SideErrors>& errors);

}  // namespace axiscert
