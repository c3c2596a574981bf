// The text files built into the library, named by file; embed.cmake writes their definitions.
#pragma once

#include <string_view>

namespace axiscert::embedded {

extern const std::string_view report_html, report_css;
extern const std::string_view chart_min_js;  // Chart.js itself, MIT licence
extern const std::string_view instrument_html, instrument_js, chart_js;
extern const std::string_view table_js, answer_js, next_js, classes_js, heat_js, bounds_js, origins_js, maps_js,
    margins_js, snippets_js, contacts_js, witnesses_js, results_js, appendix_js, report_js;
// The pictures of witnesses: what they share, the list of them, and one for each predicate.
extern const std::string_view scene_view_js, pictures_js, sphere_triangle_scene_js, moving_sphere_scene_js,
    boxes_scene_js;

}  // namespace axiscert::embedded
