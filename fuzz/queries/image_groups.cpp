#include "fuzz/queries/image_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "fuzz/queries/capabilities.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::string_view vertex_letters = "abc";

// The part of a name after the last underscore is made of vertices: "vertex_a", "side_c", "edge_ca".
bool names_vertices(std::string_view part) {
  const std::size_t underscore = part.find('_');
  return underscore != part.npos && part.find_first_not_of(vertex_letters, underscore + 1) == part.npos;
}

std::string part_in_base(std::string_view part, const std::array<std::uint8_t, 3>& order) {
  std::string renamed(part);
  if (!names_vertices(part)) return renamed;
  const std::size_t first = part.find('_') + 1;
  for (std::size_t i = first; i < part.size(); ++i) renamed[i] = vertex_letters[order[vertex_letters.find(part[i])]];
  // An edge runs from a vertex to the next: ab, bc, ca.
  if (part.size() == first + 2) {
    const std::size_t from = vertex_letters.find(renamed[first]), to = vertex_letters.find(renamed[first + 1]);
    if ((from + 1) % 3 != to) std::swap(renamed[first], renamed[first + 1]);
  }
  return renamed;
}

std::string name_in_base(std::string_view name, const std::array<std::uint8_t, 3>& order) {
  std::string renamed;
  for (;;) {
    const std::size_t dot = name.find('.');
    renamed += part_in_base(name.substr(0, dot), order);
    if (dot == name.npos) return renamed;
    renamed += '.';
    name.remove_prefix(dot + 1);
  }
}

}  // namespace

std::vector<const ImageGroup*> image_groups() {
  std::vector<const ImageGroup*> all;
  for (const Predicate* predicate : predicates()) {
    const auto groups = capabilities_of(*predicate).image_groups;
    all.insert(all.end(), groups.begin(), groups.end());
  }
  return all;
}

const ImageGroup* image_group(std::string_view family) {
  const std::vector<const ImageGroup*> all = image_groups();
  const auto found = std::ranges::find(all, family, &ImageGroup::family);
  return found == all.end() ? nullptr : *found;
}

ComparisonsOfBase::ComparisonsOfBase(const Predicate& predicate, const std::array<std::uint8_t, 3>& order) {
  for (const PredicateComparison& comparison : predicate.comparisons) {
    const std::string wanted = name_in_base(comparison.name, order);
    const auto base = std::find_if(predicate.comparisons.begin(), predicate.comparisons.end(),
                                   [&](const PredicateComparison& other) { return other.name == wanted; });
    if (base == predicate.comparisons.end()) {
      throw HarnessFault(fmt::format("{}: comparison {} would be {} with the vertices in another order, which is none",
                                     predicate.id, comparison.name, wanted));
    }
    base_.push_back(static_cast<std::uint8_t>(base - predicate.comparisons.begin()));
  }
}

ComparisonBits ComparisonsOfBase::operator()(ComparisonBits image) const {
  ComparisonBits bits = 0;
  for_each_bit(image, [&](std::size_t k) { bits |= one_bit<ComparisonBits>(base_[k]); });
  return bits;
}

}  // namespace axiscert
