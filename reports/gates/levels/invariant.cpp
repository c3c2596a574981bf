// invariant=KIND: no verdict changes with an exact image of a query.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzz/queries/image_groups.h"
#include "kernel/base/error.h"
#include "reports/gates/levels/level.h"
#include "reports/wording/invariance.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

struct KindWords {
  std::string_view image;     // "the same query ..."
  std::string_view families;  // of those that make such images, for a run without one
};
constexpr EnumArray<ImageKind, KindWords> kind_words = {
    KindWords{"with its vertices in another order", "--family orders"},
    KindWords{"with its coordinate axes exchanged", "--family axes"},
    KindWords{"with coordinates of the other sign", "--family inverted --family axes"},
    KindWords{"times a power of two", "--family units --family spans"},
    KindWords{"moved", "--family translated --family spans"}};

ImageKind kind_of(const AskedLevel& asked) {
  for (const ImageKind kind : enumerators<ImageKind>) {
    if (asked.argument == image_kind_names[kind]) return kind;
  }
  throw Error(fmt::format("requirement '{}': KIND is one of {}, as in {}=scale", asked.text,
                          fmt::join(image_kind_names, ", "), asked.name));
}

std::string size_text(ImageKind kind, const Json& by_size) {
  if (kind == ImageKind::scale) return " " + powers_text(by_size);
  if (kind == ImageKind::translation) return fmt::format(" by 2^{} or more", least_size(by_size));
  return "";
}

LevelFindings judge_invariant(const AskedLevel& asked, const Subject& subject) {
  const ImageKind kind = kind_of(asked);
  const std::string name(image_kind_names[kind]);
  LevelFindings found;
  std::uint64_t images = 0;
  std::vector<std::string> families;
  for (const auto& [family, result] : subject.families().items()) {
    const Json* changes = changes_of(result, name);
    // Where the range is not known, a power of two may change what overflows.
    if (changes == nullptr || (kind == ImageKind::scale && (*changes)["range"].is_null())) {
      found.unseen.push_back(family);
      continue;
    }
    images += (*changes)["images"].get<std::uint64_t>();
    families.push_back(family);
    if (kind == ImageKind::scale) {
      const UnitChange change = unit_change(*changes);
      subject.add_pair(found.failures, family, change.count, change.what, change.first);
    } else {
      subject.add_pair(found.failures, family, (*changes)["changed"].get<std::uint64_t>(),
                       fmt::format("another verdict on the same query {}{}", kind_words[kind].image,
                                   size_text(kind, (*changes)["by_size"])),
                       (*changes)["first"]);
    }
  }
  if (images == 0) {
    found.not_checked =
        fmt::format("no answered query is another one {}; add {}", kind_words[kind].image, kind_words[kind].families);
    return found;
  }
  found.covers = fmt::format("{} queries of {}, each the same as another {}", thousands(images),
                             fmt::join(families, ", "), kind_words[kind].image);
  found.leaves_out = kind == ImageKind::scale ? "scales at which a form of degree 6 overflows or underflows"
                                              : "other queries than these families make";
  return found;
}

}  // namespace

extern const GateLevel invariant_level = {
    "invariant=KIND", "no verdict that changes with KIND: order, axes, mirror, scale or translation",
    [](const AskedLevel& asked) { kind_of(asked); },
    [](const AskedLevel& asked) {
      return fmt::format("the same verdict on the same query {}", kind_words[kind_of(asked)].image);
    },
    judge_invariant};

}  // namespace axiscert
