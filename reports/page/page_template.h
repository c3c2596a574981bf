// Fills a page's template from built-in files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/text/json.h"

namespace axiscert {

// JSON that remains JSON inside a script element, whatever its strings contain.
std::string inert_json(const Json& data);
// Text as the content of an HTML element.
std::string html_text(std::string_view text);
// The template with each place replaced by its text. Places are looked for only in the template, in its order, so that
// nothing in the data is taken for one. Throws std::logic_error for a place that the template does not have.
std::string filled(std::string_view page_template, std::span<const std::pair<std::string_view, std::string>> places);

// The scripts of the pictures of witnesses, each after those that it uses; they use table.js.
std::string scene_scripts();

}  // namespace axiscert
