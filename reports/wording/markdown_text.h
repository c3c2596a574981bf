// Text that is safe in Markdown, and sections that stay short.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "reports/wording/summary.h"

namespace axiscert {

inline constexpr std::size_t section_limit = 56 * 1024;  // bytes; at most eighteen sections: 1 MiB

// A text that is safe at any place of a document: one line, cut short, with nothing that Markdown or HTML would
// interpret, or that a forge would take for a mention, an issue or an address.
inline std::string markdown_text(const std::string& given, std::size_t limit = 120) {
  // Mentions and links are found in the rendered text, where no backslash is left, so a comment separates the text
  // there.
  constexpr std::string_view apart = "<!-- -->";
  std::size_t end = std::min(limit, given.size());
  while (end < given.size() && end > 0 && (static_cast<unsigned char>(given[end]) & 0xc0) == 0x80) --end;
  const auto is_word = [&](std::size_t i) {
    return i < end && std::isalnum(static_cast<unsigned char>(given[i])) != 0;
  };
  std::string text;
  for (std::size_t i = 0; i < end; ++i) {
    const char c = given[i];
    const bool opens_address = given.compare(i, 3, "://") == 0, opens_host = given.compare(i, 4, "www.") == 0;
    // Between letters an underscore does not emphasise.
    const bool emphasises = c == '_' && !(i > 0 && is_word(i - 1) && is_word(i + 1));
    if (c == '<') text += "&lt;";
    else if (c == '&') text += "&amp;";
    else if (static_cast<unsigned char>(c) < 0x20) text += ' ';
    else if (emphasises || std::string_view("\\`*[]|~$").find(c) != std::string_view::npos) text += {'\\', c};
    else text += c;
    if (c == '@' || c == '#' || opens_address || opens_host) text += apart;
  }
  return end < given.size() ? text + " ..." : text;
}

inline std::string code_block(const std::string& text) {
  std::string fence = "```";
  while (text.find(fence) != text.npos) fence += "`";
  return fmt::format("{}\n{}\n{}\n", fence, text, fence);
}

// A count; empty where nothing was counted.
inline std::string count_text(std::optional<std::uint64_t> count) { return count ? thousands(*count) : "not checked"; }

// A section that takes the lines that fit, in the order given, and says how many did not.
class Section {
 public:
  explicit Section(const std::string& title) : text_(fmt::format("\n## {}\n\n", title)) {}

  void add(const std::string& piece) {
    if (left_out_ > 0 || text_.size() + piece.size() > section_limit) ++left_out_;
    else text_ += piece;
  }
  void add_line(const std::string& piece) { add(piece + "\n"); }
  // `columns`: the names; the first `texts` of them are left-aligned.
  void add_head(const std::vector<std::string>& columns, std::size_t texts) {
    text_ += fmt::format("| {} |\n|", fmt::join(columns, " | "));
    for (std::size_t i = 0; i < columns.size(); ++i) text_ += i < texts ? " --- |" : " ---: |";
    text_ += "\n";
  }
  void add_row(const std::vector<std::string>& cells) { add_line(fmt::format("| {} |", fmt::join(cells, " | "))); }
  std::string text() const {
    if (left_out_ == 0) return text_;
    return text_ +
           fmt::format("\n{} more left out here to keep this file short; report.html and record.json have them.\n",
                       thousands(left_out_));
  }

 private:
  std::string text_;
  std::uint64_t left_out_ = 0;
};

}  // namespace axiscert
