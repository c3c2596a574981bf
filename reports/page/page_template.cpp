#include "reports/page/page_template.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "fuzz/text/json.h"

namespace axiscert {

// The characters that are replaced occur only in strings.
std::string inert_json(const Json& data) {
  std::string text;
  const std::string json = data.dump();
  for (std::size_t i = 0; i < json.size(); ++i) {
    const bool is_separator =
        json.compare(i, 2, "\xE2\x80") == 0 && i + 2 < json.size() && (json[i + 2] == '\xA8' || json[i + 2] == '\xA9');
    if (json[i] == '<') text += "\\u003c";
    else if (json[i] == '>') text += "\\u003e";
    else if (json[i] == '&') text += "\\u0026";
    else if (is_separator) {
      text += json[i + 2] == '\xA8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else text += json[i];
  }
  return text;
}

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<') escaped += "&lt;";
    else if (c == '>') escaped += "&gt;";
    else if (c == '&') escaped += "&amp;";
    else if (c == '"') escaped += "&quot;";
    else escaped += c;
  }
  return escaped;
}

std::string filled(std::string_view page_template, std::span<const std::pair<std::string_view, std::string>> places) {
  std::string page;
  std::string_view rest = page_template;
  for (const auto& [place, text] : places) {
    const std::size_t at = rest.find(place);
    if (at == rest.npos) throw std::logic_error(fmt::format("a page's template has no place {}", place));
    page.append(rest.substr(0, at)).append(text);
    rest.remove_prefix(at + place.size());
  }
  return page.append(rest);
}

std::string scene_scripts() {
  using namespace embedded;
  const std::string_view all[] = {scene_view_js, sphere_triangle_scene_js, moving_sphere_scene_js, boxes_scene_js};
  return fmt::format("{}", fmt::join(all, "\n"));
}

}  // namespace axiscert
