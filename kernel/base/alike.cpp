#include "kernel/base/alike.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace axiscert {
namespace {

// Edit distance: the number of letters that are inserted, removed or changed.
std::size_t letters_apart(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);  // distances from the part of `from` read so far to each prefix of `to`
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t k = 0; k < to.size(); ++k) {
      const std::size_t changed = diagonal + (from[i] == to[k] ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({changed, diagonal + 1, row[k] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<std::string_view> most_alike_first(std::string_view given, std::vector<std::string_view> names) {
  // A whole page of text resembles no name, and its distances would take long.
  const std::string_view word = given.substr(0, 64);
  std::stable_sort(names.begin(), names.end(), [&](std::string_view a, std::string_view b) {
    return letters_apart(word, a) < letters_apart(word, b);
  });
  return names;
}

}  // namespace axiscert
