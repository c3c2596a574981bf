#include "reports/gates/invariant_level.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/base/error.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/causes.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Empty where no answer is wrong in this direction.
std::string direction_text(const AbsoluteSizeRecord& sizes, std::string_view where) {
  if (sizes.bases == 0) return "";
  const std::string text = compared_text(sizes);
  return fmt::format("where numbers are {}, {}", where,
                     text.empty() ? "and no one number of its own explains it" : text);
}

std::string degree_text(const CountsBySize& by_size, const ImageChangesRecord& scale) {
  return are_outer(by_size, scale) ? ", or a form of a degree above 6 left its range" : "";
}

}  // namespace

const ImageChangesRecord* changes_of(const FamilyRecord& family, ImageKind kind) {
  if (!family.invariance) return nullptr;
  const auto found = family.invariance->find(kind);
  return found == family.invariance->end() ? nullptr : &found->second;
}

const ImageChangesRecord* units_of(const FamilyRecord& family) {
  const ImageChangesRecord* scale = changes_of(family, ImageKind::scale);
  return scale != nullptr && scale->range.value_or(std::nullopt) ? scale : nullptr;
}

std::string powers_text(const CountsBySize& by_size) {
  const auto [down, up] = nearest_powers(by_size);
  std::vector<std::string> parts;
  if (down) parts.push_back(fmt::format("from 2^{} down", *down));
  if (up) parts.push_back(fmt::format("from 2^{} up", *up));
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string absolute_number_text(const UnitFaultsRecord& wrong) {
  std::vector<std::string> texts = {direction_text(wrong.where_small, "small"),
                                    direction_text(wrong.where_large, "large")};
  std::erase(texts, "");
  return fmt::format("{}", fmt::join(texts, "; "));
}

UnitChange unit_change(const ImageChangesRecord& scale) {
  const UnitFaultsRecord wrong = scale.wrong.value_or(UnitFaultsRecord());
  UnitChange found;
  found.count = wrong.count;
  if (found.count != 0) {
    found.first = wrong.first;
    found.what = fmt::format(
        "wrong verdicts in another unit of length alone (times powers of two {}), on queries that are no close calls; "
        "{}{}",
        powers_text(wrong.by_size), absolute_number_text(wrong), degree_text(wrong.by_size, scale));
    return found;
  }
  found.count = scale.changed;
  found.first = scale.first;
  if (found.count == 0) return found;
  found.what =
      fmt::format("verdicts that change with the unit of length (times powers of two {})", powers_text(scale.by_size));
  const std::string number = absolute_number_text(wrong);
  if (!number.empty()) found.what += "; " + number;
  found.what += degree_text(scale.by_size, scale);
  return found;
}

// invariant=KIND: no verdict changes with an exact image of a query.

namespace {

constexpr EnumArray<ImageKind, std::string_view> kind_words = {  // "the same query ..."
    "with its vertices in another order",
    "with its coordinate axes exchanged",
    "with coordinates of the other sign",
    "times a power of two",
    "moved",
    "from its end to its start",
    "in two parts",
    "going on twice, four or eight times as far, after a contact",
    "with its bodies exchanged",
    "with a body turned so that it is the same"};

// The families of the run's predicate that make such images, for a run that has none: those to add, or that were asked
// too few queries.
std::string families_with(ImageKind kind, const Subject& subject) {
  std::vector<std::string> options, asked;
  for (const Family* family : families_of(predicate_of(subject.record().plan))) {
    const ImageGroup* group = image_group(family->name);
    if (group == nullptr || (kind == ImageKind::scale && group->range == nullptr)) continue;
    bool makes = false;
    for (std::size_t i = 1; i < group->size; ++i) makes |= group->kind(i) == kind;
    if (!makes) continue;
    if (subject.families().contains(family->name)) asked.emplace_back(family->name);
    else options.push_back(fmt::format("--family {}", family->name));
  }
  if (options.empty() && !asked.empty())
    return fmt::format("too few queries of {} were asked to have one", fmt::join(asked, ", "));
  return options.empty() ? "no family of this predicate makes one" : fmt::format("add {}", fmt::join(options, " "));
}

ImageKind kind_of(const AskedLevel& asked) {
  for (const ImageKind kind : enumerators<ImageKind>) {
    if (asked.argument == image_kind_names[kind]) return kind;
  }
  throw Error(fmt::format("requirement '{}': KIND is one of {}, as in {}=scale", asked.text,
                          fmt::join(image_kind_names, ", "), asked.name));
}

std::string size_text(ImageKind kind, const CountsBySize& by_size) {
  if (kind == ImageKind::scale) return " " + powers_text(by_size);
  if (kind == ImageKind::translation) return fmt::format(" by 2^{} or more", least_size(by_size));
  return "";
}

LevelFindings judge_invariant(const AskedLevel& asked, const Subject& subject) {
  const ImageKind kind = kind_of(asked);
  LevelFindings found;
  std::uint64_t images = 0;
  std::vector<std::string> families;
  for (const auto& [family, result] : subject.families()) {
    // Where the range is not known, a power of two may change what overflows.
    const ImageChangesRecord* changes = kind == ImageKind::scale ? units_of(result) : changes_of(result, kind);
    if (changes == nullptr) {
      found.unseen.push_back(family);
      continue;
    }
    images += changes->images;
    families.push_back(family);
    found.families[family] = subject.pairs_look(result, changes->images, changes->undecided);
    if (kind == ImageKind::scale) {
      const UnitChange change = unit_change(*changes);
      subject.add_pair(found.failures, family, change.count, change.what, change.first);
    } else {
      subject.add_pair(
          found.failures, family, changes->changed,
          fmt::format("another verdict on the same query {}{}", kind_words[kind], size_text(kind, changes->by_size)),
          changes->first);
    }
  }
  if (images == 0) {
    found.not_checked =
        fmt::format("no answered query is another one {}; {}", kind_words[kind], families_with(kind, subject));
    return found;
  }
  found.covers = fmt::format("{} queries of {}, each the same as another {}", thousands(images),
                             fmt::join(families, ", "), kind_words[kind]);
  found.leaves_out = kind == ImageKind::scale ? "scales at which a form of degree 6 overflows or underflows"
                                              : "other queries than these families make";
  return found;
}

}  // namespace

extern const GateLevel invariant_level = {
    .usage = "invariant=KIND",
    .meaning =
        "no verdict that changes with KIND: order, axes, mirror, scale, translation, reversal, split, halving, swap or "
        "turn",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format("the same verdict on the same query {}", kind_words[kind_of(asked)]);
        },
    .judge = judge_invariant,
    // It asks other queries in other units than the families of images do.
    .is_denied_by =
        [](const AskedLevel& asked, std::string_view property, std::string_view value) {
          return kind_of(asked) == ImageKind::scale && property == "absolute_threshold" && value == "present";
        },
    .in_certificates = image_kind_names.values};

}  // namespace axiscert
