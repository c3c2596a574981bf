#include "fuzz/record/cause_record.h"

#include <fmt/format.h>

namespace axiscert {
namespace {

std::string count_text(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3)
    text.insert(static_cast<std::size_t>(i), 1, ',');
  return text;
}

}  // namespace

std::string CauseRecord::sentence() const {
  if (!is_known) {
    constexpr EnumArray<CauseBasis, std::string_view> asked = {"clear queries", "queries whose arithmetic is exact",
                                                               "queries"};
    return fmt::format("no class explains its {} wrong verdicts on {}; the best, {}, has {} of them",
                       count_text(looked_at), asked[basis], phrase, count_text(explained));
  }
  const std::string elsewhere =
      elsewhere_wrong == 0
          ? fmt::format("right elsewhere (0 of {})", count_text(elsewhere_of))
          : fmt::format("elsewhere on {} of {}", count_text(elsewhere_wrong), count_text(elsewhere_of));
  constexpr EnumArray<CauseBasis, std::string_view> before = {
      "", "right on the clear queries that were asked; where arithmetic is exact, ",
      "right on the clear queries that were asked; otherwise "};
  return fmt::format("{}wrong on {} of {} {}; {}", before[basis], count_text(wrong), count_text(of), phrase, elsewhere);
}

}  // namespace axiscert
