// Fills a page's template from built-in files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/text/json_fwd.h"

namespace axiscert::embedded {
// The text files built into the library, named by file; embed.cmake writes their definitions.

extern const std::string_view report_html, report_css;
extern const std::string_view chart_min_js;  // Chart.js itself, MIT licence
extern const std::string_view instrument_html, instrument_js, chart_js;
extern const std::string_view table_js, first_js, answer_js, next_js, classes_js, heat_js, bounds_js, origins_js,
    maps_js, margins_js, snippets_js, contacts_js, witnesses_js, results_js, appendix_js, report_js;
// The pictures of witnesses: what they share, the list of them, and one for each predicate.
extern const std::string_view scene_view_js, sphere_triangle_scene_js, moving_sphere_scene_js, boxes_scene_js;

}  // namespace axiscert::embedded

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
