#include "kernel/permitted/kernels.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <memory>

#include "kernel/base/error.h"
#include "kernel/permitted/adversary.h"
#include "kernel/permitted/graph.h"
#include "kernel/permitted/lanes.h"
#include "kernel/permitted/permissions.h"

namespace axiscert::permitted {
namespace {

// Which verdict is looked for: that of `misses`, or that of `invents`.
enum class Wish { separated, contact };
constexpr std::string_view suffix_of(Wish wish) { return wish == Wish::separated ? "-misses" : "-invents"; }

struct Name {
  const Part* part;
  Wish wish;
};
std::optional<Name> parsed(std::string_view name) {
  for (const Part& part : parts) {
    for (const Wish wish : {Wish::separated, Wish::contact}) {
      if (name == std::string(part.name) + std::string(suffix_of(wish))) return Name{&part, wish};
    }
  }
  return std::nullopt;
}

Verdict verdict_of(Wish wish) { return wish == Wish::separated ? Verdict::separated : Verdict::contact; }

}  // namespace

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Part& part : parts) {
    for (const Wish wish : {Wish::separated, Wish::contact})
      all.push_back(std::string(part.name) + std::string(suffix_of(wish)));
  }
  return all;
}

std::optional<Kernel> kernel(std::string_view id, const Kernel& rung, std::string_view name) {
  const std::optional<Name> parsed_name = parsed(name);
  if (!parsed_name) return std::nullopt;
  const auto record = recorder_of(rung);
  if (!record) {
    throw Error(
        fmt::format("kernel '{}': '{}' takes roots, or has formulae that permissions are not applied to (docs/gpu.md)",
                    id, rung.id));
  }
  const Permissions& permissions = parsed_name->part->permissions;
  const auto recording = std::make_shared<const Recording>(record(permissions));
  const Verdict wished = verdict_of(parsed_name->wish);
  Kernel made;
  made.id = id;
  made.summary =
      fmt::format("{}; {} where {} permits it", rung.summary,
                  parsed_name->wish == Wish::separated ? "separated" : "contact", parsed_name->part->summary);
  made.predicate = rung.predicate;
  made.entry = rung.entry;
  made.exposes = Exposure::verdict;
  made.is_reference = false;
  const auto lanes = AdversaryInLanes::covers(permissions)
                         ? std::make_shared<const AdversaryInLanes>(*rung.predicate, rung.entry, *recording, wished)
                         : nullptr;
  made.binary32 = [=, predicate = rung.predicate](std::string_view) {
    Implementation<float> implementation;
    implementation.verdicts = [=](const QueryColumns<float>& batch, Verdict* out) {
      const Verdict other = wished == Verdict::separated ? Verdict::contact : Verdict::separated;
      std::vector<std::uint8_t> can_be(batch.size, 1);
      if (lanes) lanes->ask(batch, can_be.data());
      // One value each behind barriers is tried for what can be with more.
      std::optional<Adversary> adversary;
      if (!lanes || permissions.kept) adversary.emplace(*predicate, *recording, wished);
      std::array<float, most_columns> query;
      for (std::size_t i = 0; i < batch.size; ++i) {
        out[i] = can_be[i] != 0 ? wished : other;
        if (can_be[i] == 0 || !adversary) continue;
        for (std::size_t k = 0; k < batch.count; ++k) query[k] = batch.column[k][i];
        out[i] = adversary->answer({query.data(), batch.count});
      }
    };
    return implementation;
  };
  return made;
}

std::vector<std::string> evaluation(const Kernel& kernel, const Numbers<float>& query) {
  const std::size_t plus = kernel.id.find('+');
  const auto name = plus == kernel.id.npos ? std::nullopt : parsed(std::string_view(kernel.id).substr(plus + 1));
  if (!name) return {};
  const Recording recording = recorder_of(find_kernel(kernel.id.substr(0, plus)))(name->part->permissions);
  const Predicate& predicate = *kernel.predicate;
  Adversary adversary(predicate, recording, verdict_of(name->wish));
  const Verdict verdict = adversary.answer({query.begin(), query.end()});
  std::vector<std::string> columns, lines;
  for (const PredicateColumn& column : predicate.entries[kernel.entry].columns) columns.emplace_back(column.name);
  const auto put = [&](std::string_view label, std::size_t i, bool holds) {
    const auto side = [&](Value v, bool greatest) {
      const Reach reach = adversary.evaluation().of(v);
      return fmt::format("{} = {:.9g}", adversary.evaluation().text(v, greatest, columns),
                         greatest ? reach.greatest : reach.least);
    };
    const auto& [lhs, rhs] = recording.sides[i];
    lines.push_back(fmt::format("{} {}: {} {} {}", label, holds ? "holds" : "does not hold", side(lhs, holds),
                                has_bit(recording.nonstrict, i) ? ">=" : ">", side(rhs, !holds)));
  };
  if (verdict != verdict_of(name->wish)) return lines;
  if (!recording.paths.empty()) {
    for (std::size_t step = 0; const auto& [i, holds] : recording.paths[adversary.path()].decisions)
      put(fmt::format("branch.{}", ++step), i, holds);
    return lines;
  }
  // The clause that separates, by all of its comparisons; of contact, in each clause one that does not hold.
  const bool separated = verdict == Verdict::separated;
  for (const PredicateClause& clause : predicate.clauses) {
    std::vector<std::size_t> deciding;
    for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
      if (has_bit(clause.comparisons, i) && adversary.can_be(i, separated)) deciding.push_back(i);
    }
    if (separated && deciding.size() != static_cast<std::size_t>(std::popcount(clause.comparisons))) continue;
    if (!separated) deciding.resize(1);
    for (const std::size_t i : deciding) put(predicate.comparisons[i].name, i, separated);
    if (separated) break;
  }
  return lines;
}

}  // namespace axiscert::permitted
