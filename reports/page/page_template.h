// Filling a page's template from built-in files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/text/json.h"

namespace axiscert {

// JSON that stays JSON inside a script element, whatever its strings hold.
std::string inert_json(const Json& data);
// Text as the content of an HTML element.
std::string html_text(std::string_view text);
// The template with each place replaced by its text. Places are found in the template only, in its order, so that
// nothing in the data is taken for one. Throws std::logic_error for a place that it does not have.
std::string filled(std::string_view page_template, std::span<const std::pair<std::string_view, std::string>> places);

}  // namespace axiscert
