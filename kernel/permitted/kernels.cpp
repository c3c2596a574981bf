#include "kernel/permitted/kernels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "kernel/base/error.h"
#include "kernel/permitted/permissions.h"
#include "kernel/permitted/reach.h"
#include "kernel/permitted/recording.h"

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

// The bits nearest to the wish: of separated all that can hold, of contact all that cannot but hold. Each comparison is
// computed anew, so they are reached together.
ComparisonBits wished_bits(const Recording& recording, const Evaluation& evaluation, Wish wish) {
  ComparisonBits bits = 0;
  for (std::size_t i = 0; i < recording.sides.size(); ++i) {
    const Reach lhs = evaluation.of(recording.sides[i].first), rhs = evaluation.of(recording.sides[i].second);
    const float left = wish == Wish::separated ? lhs.greatest : lhs.least;
    const float right = wish == Wish::separated ? rhs.least : rhs.greatest;
    bits |= bit_if<ComparisonBits>(has_bit(recording.nonstrict, i) ? left >= right : left > right, i);
  }
  return bits;
}

// Answers of one kernel; each thread has its own evaluation.
class Adversary {
 public:
  Adversary(const Predicate& predicate, Recording recording, Wish wish)
      : predicate_(predicate), recording_(std::move(recording)), wish_(wish) {}

  const Recording& recording() const { return recording_; }
  Wish wish() const { return wish_; }

  // `evaluation` has the values by which it answers.
  Verdict answer(std::span<const float> query, Evaluation& evaluation) const {
    const Verdict wished = wish_ == Wish::separated ? Verdict::separated : Verdict::contact;
    evaluation.evaluate(query);
    Verdict found = verdict_of(predicate_, wished_bits(recording_, evaluation, wish_));
    const std::vector<std::uint32_t> kept = evaluation.kept_nodes();
    if (kept.empty() || found != wished) return found;
    // With a value for each barrier the reach is at most that: every choice of them is tried.
    std::vector<float> values(kept.size());
    std::vector<std::pair<std::size_t, Reach>> open;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const Reach reach = evaluation.of({kept[i]});
      values[i] = reach.least;
      if (reach.least != reach.greatest) open.emplace_back(i, reach);
    }
    for (std::size_t choice = 0; choice < std::size_t{1} << open.size(); ++choice) {
      for (std::size_t k = 0; k < open.size(); ++k) {
        values[open[k].first] = ((choice >> k) & 1) != 0 ? open[k].second.greatest : open[k].second.least;
      }
      evaluation.evaluate(query, values);
      found = verdict_of(predicate_, wished_bits(recording_, evaluation, wish_));
      if (found == wished) break;
    }
    return found;
  }

 private:
  const Predicate& predicate_;
  Recording recording_;
  Wish wish_;
};

std::shared_ptr<const Adversary> adversary_of(const Kernel& rung, const Name& name) {
  const auto record = recorder_of(rung);
  if (!record) return nullptr;
  return std::make_shared<const Adversary>(*rung.predicate, record(name.part->permissions), name.wish);
}

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
  const auto adversary = adversary_of(rung, *parsed_name);
  if (!adversary) {
    throw Error(fmt::format(
        "kernel '{}': permissions are applied to sums and products alone, and '{}' divides, takes roots or branches",
        id, rung.id));
  }
  Kernel made;
  made.id = id;
  made.summary =
      fmt::format("{}; {} where {} permits it", rung.summary,
                  parsed_name->wish == Wish::separated ? "separated" : "contact", parsed_name->part->summary);
  made.predicate = rung.predicate;
  made.entry = rung.entry;
  made.exposes = Exposure::verdict;
  made.is_reference = false;
  made.binary32 = [=](std::string_view) {
    Implementation<float> implementation;
    implementation.verdicts = [=](const QueryColumns<float>& batch, Verdict* out) {
      Evaluation evaluation(adversary->recording().graph);
      std::array<float, most_columns> query;
      for (std::size_t i = 0; i < batch.size; ++i) {
        for (std::size_t k = 0; k < batch.count; ++k) query[k] = batch.column[k][i];
        out[i] = adversary->answer({query.data(), batch.count}, evaluation);
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
  const auto adversary = adversary_of(find_kernel(kernel.id.substr(0, plus)), *name);
  Evaluation found(adversary->recording().graph);
  const Verdict verdict = adversary->answer({query.begin(), query.end()}, found);
  const bool is_separated = verdict == Verdict::separated;
  const ComparisonBits bits = wished_bits(adversary->recording(), found, adversary->wish());
  std::vector<std::string> columns, lines;
  for (const PredicateColumn& column : kernel.predicate->entries[kernel.entry].columns)
    columns.emplace_back(column.name);
  for (const PredicateClause& clause : kernel.predicate->clauses) {
    // A clause that separates, by all of its comparisons; of contact, in each clause one that does not hold.
    const bool holds = (bits & clause.comparisons) == clause.comparisons;
    if (holds != is_separated) continue;
    for (std::size_t i = 0; i < kernel.predicate->comparisons.size(); ++i) {
      if (!has_bit(clause.comparisons, i) || has_bit(bits, i) != is_separated) continue;
      const auto [lhs, rhs] = adversary->recording().sides[i];
      const bool greatest = adversary->wish() == Wish::separated;
      const auto side = [&](Value v, bool end) {
        const Reach reach = found.of(v);
        return fmt::format("{} = {:.9g}", found.text(v, end, columns), end ? reach.greatest : reach.least);
      };
      lines.push_back(fmt::format("{} {}: {} {} {}", kernel.predicate->comparisons[i].name,
                                  is_separated ? "holds" : "does not hold", side(lhs, greatest),
                                  has_bit(adversary->recording().nonstrict, i) ? ">=" : ">", side(rhs, !greatest)));
      if (!is_separated) break;
    }
    if (is_separated) break;
  }
  return lines;
}

}  // namespace axiscert::permitted
