#include "cli/glossary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace axiscert {
namespace {

// Lower case, and a space for each '-' and '_'.
std::string comparable_word(std::string_view word) {
  std::string out(word);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return c == '-' || c == '_' ? ' ' : static_cast<char>(std::tolower(c)); });
  return out;
}

std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.emplace_back(text.substr(at, end - at));
    at = end + separator.size();
  }
  return parts;
}

}  // namespace

std::vector<GlossaryEntry> glossary_entries(std::string_view text) {
  std::vector<GlossaryEntry> entries;
  std::vector<std::string> sections = split(text, "\n## ");
  sections.erase(sections.begin());  // what is said before the first heading
  for (const std::string& section : sections) {
    const std::size_t end = section.find('\n');
    std::string body = section.substr(std::min(end, section.size()));
    const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
    body.erase(body.begin(), std::find_if_not(body.begin(), body.end(), is_space));
    body.erase(std::find_if_not(body.rbegin(), body.rend(), is_space).base(), body.end());
    entries.push_back({split(std::string_view(section).substr(0, end), ", "), body});
  }
  return entries;
}

bool is_same_word(std::string_view known, std::string_view word) {
  const std::string given = comparable_word(word), name = comparable_word(known);
  return name == given || given == name + "s" || given == name + "es";
}

const GlossaryEntry* find_entry(const std::vector<GlossaryEntry>& entries, std::string_view word) {
  for (const GlossaryEntry& entry : entries) {
    for (const std::string& known : entry.words) {
      if (is_same_word(known, word)) return &entry;
    }
  }
  return nullptr;
}

}  // namespace axiscert
