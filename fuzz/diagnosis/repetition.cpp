// Whether a kernel gives the same answer to the same query: again, in another lane, in a batch of another length, among
// other queries.
#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"

namespace axiscert::diagnosis {
namespace {

constexpr int repetitions = 16;
// Up to two vectors of sixteen lanes and one more.
constexpr std::size_t longest = 33, placed_queries = 96;

// Three queries near touching and one that is not, in turn: the ones show the last bit, the other what is wrong
// everywhere. A radius that is one ulp off changes one near tie in five.
template <class Real>
Queries<Real> mixed_queries(Subject<Real>& subject, std::size_t count) {
  const Queries<Real> near = sharp_queries<Real>(subject.kernel(), subject.seed(), count - count / 4);
  const Queries<Real> general = queries_of_general<Real>(subject.kernel(), subject.seed(), count / 4);
  Queries<Real> mixed;
  for (std::size_t i = 0; i < near.size(); ++i) {
    mixed.push_back(near[i]);
    if (i % 3 == 2 && i / 3 < general.size()) mixed.push_back(general[i / 3]);
  }
  return mixed;
}

std::string both(Verdict one, Verdict other) { return fmt::format("{}, {}", name(one), name(other)); }

bool is_answer(Verdict v) { return v != Verdict::unanswered; }

// The answers to one query in batches of copies of it: [length - 1][position].
using Placings = std::vector<std::vector<Verdict>>;

template <class Real>
Placings placings(Subject<Real>& subject, const Numbers<Real>& query) {
  Placings said;
  for (std::size_t length = 1; length <= longest; ++length) {
    said.push_back(subject.ask_batch(Queries<Real>(length, query)));
  }
  return said;
}

// Whether the same batch asked four times is answered the same: else no other comparison says anything.
template <class Real>
bool is_repeatable(Subject<Real>& subject) {
  const Queries<Real> batch = mixed_queries(subject, 256);
  const auto first = subject.ask_batch(batch);
  for (int i = 1; i < repetitions; ++i) {
    if (subject.ask_batch(batch) != first) return false;
  }
  return true;
}

ProbeFinding not_repeatable() {
  return undecided("It gives other answers to the same batch, so nothing can be said of where they stand in it.");
}

// One difference decides; that there is none takes answers.
ProbeFinding too_few_answers(std::size_t answered, std::size_t compared) {
  return undecided(fmt::format(
      "It decided both queries in only {} of {} comparisons, too few to say that none differs.", answered, compared));
}

struct PlaceDifference {
  std::size_t query, length, position, other_length, other_position;
};

// Looks for two places with different answers; `compares` says with which of the earlier ones a place is compared.
template <class Real>
ProbeFinding placed_differently(Subject<Real>& subject, bool is_of_length) {
  if (!is_repeatable(subject)) return not_repeatable();
  const Queries<Real> queries = mixed_queries(subject, placed_queries);
  std::optional<PlaceDifference> first;
  std::size_t differing = 0, answered = 0, compared = 0;
  Verdict one = Verdict::unanswered, other = one;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Placings said = placings(subject, queries[i]);
    bool differs = false;
    for (std::size_t length = 1; length <= longest; ++length) {
      for (std::size_t position = 0; position < length; ++position) {
        const Verdict here = said[length - 1][position];
        // With the first of the batch, or with the shortest batch that has this position.
        const std::size_t base_length = is_of_length ? position + 1 : length, base = is_of_length ? position : 0;
        const Verdict there = said[base_length - 1][base];
        ++compared;
        if (!is_answer(here) || !is_answer(there)) continue;
        answered += is_decided(here) && is_decided(there);
        if (here == there) continue;
        differs = true;
        if (first) continue;
        first = PlaceDifference{i, length, position, base_length, base};
        one = there;
        other = here;
      }
    }
    differing += differs;
  }
  if (!first && 2 * answered <= compared) return too_few_answers(answered, compared);
  const std::string_view what = is_of_length ? "the length of the batch" : "the position in the batch";
  if (!first) {
    return decided(Place::independent,
                   fmt::format("Its answers do not depend on {}: {} queries in batches of 1 to {} copies.", what,
                               queries.size(), longest));
  }
  return decided(
      Place::depends,
      fmt::format("Its answers depend on {}: {} of {} queries are answered otherwise somewhere in "
                  "batches of 1 to {} copies.",
                  what, differing, queries.size(), longest),
      {subject.witness(queries[first->query], both(one, other),
                       fmt::format("as query {} of {} equal ones, and as query {} of {}", first->other_position + 1,
                                   first->other_length, first->position + 1, first->length))});
}

}  // namespace

template <class Real>
ProbeFinding repeated(Subject<Real>& subject) {
  const Queries<Real> batch = mixed_queries(subject, 1024);
  const auto first = subject.ask_batch(batch);
  if (std::ranges::none_of(first, is_decided)) return undecided("It decided none of these queries.");
  for (int i = 1; i < repetitions; ++i) {
    const auto again = subject.ask_batch(batch);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      if (again[k] == first[k] || !is_answer(again[k]) || !is_answer(first[k])) continue;
      return decided(
          RepeatedBatch::differs,
          fmt::format("It is not deterministic: the same batch of {}, asked {} times, is "
                      "answered in two ways.",
                      batch.size(), i + 1),
          {subject.witness(batch[k], both(first[k], again[k]),
                           fmt::format("as query {} of the same batch, the first time and the {}th", k + 1, i + 1))});
    }
  }
  return decided(
      RepeatedBatch::same,
      fmt::format("The same {} queries, asked {} times, are answered the same each time.", batch.size(), repetitions));
}

template <class Real>
ProbeFinding position_in_batch(Subject<Real>& subject) {
  return placed_differently(subject, false);
}

template <class Real>
ProbeFinding batch_length(Subject<Real>& subject) {
  return placed_differently(subject, true);
}

template <class Real>
ProbeFinding neighbours(Subject<Real>& subject) {
  if (!is_repeatable(subject)) return not_repeatable();
  const Queries<Real> queries = mixed_queries(subject, 4 * longest);
  std::size_t differing = 0, answered = 0, compared = 0;
  std::optional<DiagnosisWitness> witness;
  for (std::size_t from = 0; from + longest <= queries.size(); from += longest) {
    const std::span<const Numbers<Real>> batch(queries.data() + from, longest);
    const auto among_others = subject.ask_batch(batch);
    for (std::size_t k = 0; k < longest; ++k) {
      const auto among_itself = subject.ask_batch(Queries<Real>(longest, batch[k]));
      ++compared;
      if (!is_answer(among_others[k]) || !is_answer(among_itself[k])) continue;
      answered += is_decided(among_others[k]) && is_decided(among_itself[k]);
      if (among_others[k] == among_itself[k]) continue;
      ++differing;
      if (!witness) {
        witness =
            subject.witness(batch[k], both(among_itself[k], among_others[k]),
                            fmt::format("as query {} of {}, among copies of itself and among others", k + 1, longest));
      }
    }
  }
  if (differing == 0 && 2 * answered <= compared) return too_few_answers(answered, compared);
  if (differing == 0) {
    return decided(Place::independent, fmt::format("Its answers do not depend on the other queries of the batch: {} "
                                                   "among others and among copies of themselves.",
                                                   answered));
  }
  return decided(Place::depends,
                 fmt::format("Its answers depend on the other queries of the batch: {} of {} are other "
                             "ones among copies of themselves.",
                             differing, answered),
                 {*witness});
}

#define AXISCERT_INSTANCES(Real)                           \
  template ProbeFinding repeated(Subject<Real>&);          \
  template ProbeFinding position_in_batch(Subject<Real>&); \
  template ProbeFinding batch_length(Subject<Real>&);      \
  template ProbeFinding neighbours(Subject<Real>&);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis
