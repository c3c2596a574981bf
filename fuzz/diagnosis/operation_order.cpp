// The order in which a kernel sums three products, and whether it fuses them, whatever its formulae are.
//
// Vectors are multiplied by dot and cross products. Rounded to nearest, each operation once, x x' + y y' and
// x y' - y x' do not change where x and y are exchanged, but for a sign: where the first two terms of a dot product are
// x and y, no answer changes under (x, y, z) -> (y, x, -z). Where another pair is first, answers near touching do
// change. Where everything has z = 0 they do not, whatever the order: if they change there, one of the two products is
// not rounded. No answer of such a kernel changes where two coordinates change their sign.
#include <fmt/ranges.h>

#include <array>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/text/json.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t order_queries = 3000, flat_queries = 1500;
// Differences from which on an effect is taken to be there.
constexpr std::size_t least_differences = 8;

// Exchanges two axes, and turns the third round, so that it is a rotation.
struct Exchange {
  std::string_view name;
  std::array<std::uint8_t, 3> axes;
  std::size_t third;
};
constexpr std::array<Exchange, 3> exchanges = {{{"x+y", {1, 0, 2}, 2}, {"y+z", {0, 2, 1}, 0}, {"x+z", {2, 1, 0}, 1}}};

template <class Real>
Numbers<Real> exchanged(const Numbers<Real>& query, const PredicateEntry& entry, const Exchange& how) {
  Numbers<Real> turned = exact_images::with_axes(query, entry, how.axes, one_bit<std::uint8_t>(how.third));
  for (Real& x : turned) x = x + Real(0);  // not -0
  return turned;
}

template <class Real>
class OrderProbe {
 public:
  explicit OrderProbe(Subject<Real>& subject)
      : subject_(subject), near_tie_(scenes_of<Real>(subject.predicate()).near_tie) {}

  // The pairs of a query and its image with different verdicts; both have to be decided.
  template <class Image>
  std::size_t differences(const Queries<Real>& queries, const Image& image_of, std::optional<DiagnosisWitness>* shows,
                          std::string_view how) {
    Queries<Real> images;
    for (const Numbers<Real>& q : queries) images.push_back(image_of(q));
    const auto said = subject_.ask(queries), of_images = subject_.ask(images);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < said.size(); ++i) {
      ++asked_;
      if (!is_decided(said[i]) || !is_decided(of_images[i])) continue;
      ++answered_;
      says_contact_ |= said[i] == Verdict::contact;
      says_separated_ |= said[i] == Verdict::separated;
      if (said[i] == of_images[i]) continue;
      ++differing;
      if (shows && !*shows) {
        *shows = subject_.witness(queries[i], fmt::format("{}, {}", name(said[i]), name(of_images[i])),
                                  fmt::format("as it stands, and {}", how));
      }
    }
    return differing;
  }

  ProbeFinding found() {
    Queries<Real> general;
    for (std::uint64_t i = 0; i < order_queries; ++i)
      general.push_back(near_tie_(subject_.seed(), "order", i, no_axis));
    std::size_t by_signs = 0;
    for (const std::uint8_t signs : {std::uint8_t{3}, std::uint8_t{5}, std::uint8_t{6}}) {
      by_signs += differences(
          general,
          [&](const Numbers<Real>& q) {
            return exact_images::with_axes(q, subject_.entry(), {0, 1, 2}, signs);
          },
          nullptr, "");
    }
    std::array<std::size_t, 3> by_pair{}, in_plane{};
    std::optional<DiagnosisWitness> general_witness, flat_witness;
    Json pairs = Json::object(), planes = Json::object();
    for (std::size_t k = 0; k < exchanges.size(); ++k) {
      const Exchange& how = exchanges[k];
      const auto turn = [&](const Numbers<Real>& q) { return exchanged(q, subject_.entry(), how); };
      by_pair[k] = differences(general, turn, &general_witness, fmt::format("with {} exchanged", how.name));
      Queries<Real> flat;
      for (std::uint64_t i = 0; i < flat_queries; ++i) {
        flat.push_back(near_tie_(subject_.seed(), "flat order", i, how.third));
      }
      in_plane[k] = differences(flat, turn, &flat_witness, fmt::format("with {} exchanged; the third is 0", how.name));
      pairs[std::string(how.name)] = by_pair[k];
      planes[std::string(how.name)] = in_plane[k];
    }
    return concluded(
        {by_signs, by_pair, in_plane}, general_witness, flat_witness,
        {{"answered", answered_}, {"asked", asked_}, {"by_signs", by_signs}, {"by_pair", pairs}, {"in_plane", planes}});
  }

 private:
  struct Counts {
    std::size_t by_signs;
    std::array<std::size_t, 3> by_pair, in_plane;
  };

  ProbeFinding concluded(const Counts& counts, const std::optional<DiagnosisWitness>& general_witness,
                         const std::optional<DiagnosisWitness>& flat_witness, const Json& measured) const {
    const auto is_none = [](std::size_t n) { return n == 0; };
    if (answered_ == 0) return undecided("It decides nothing near touching.", measured);
    if (10 * answered_ < 9 * asked_) {
      return undecided(
          fmt::format("It decides {} of {} pairs near touching: those that it declines may change.", answered_, asked_),
          measured);
    }
    if (!says_contact_ || !says_separated_) {
      return undecided(fmt::format("Near touching it says nothing but {}: no answer could change.",
                                   name(says_contact_ ? Verdict::contact : Verdict::separated)),
                       measured);
    }
    if (counts.by_signs != 0) {
      return undecided(fmt::format("{} answers near touching change with the signs of two coordinates: it does not "
                                   "round to nearest, or does other things than multiply and add.",
                                   counts.by_signs),
                       measured);
    }
    if (std::ranges::all_of(counts.in_plane, [](std::size_t n) { return n >= least_differences; })) {
      return decided(Order::contracted,
                     "It fuses multiplications and additions: where one coordinate is 0, exchanging the other two "
                     "changes answers near touching, which no operation that is rounded once can do.",
                     {*flat_witness}, measured);
    }
    if (!std::ranges::all_of(counts.in_plane, is_none)) {
      return undecided("Exchanging two coordinates changes answers in some planes and not in others.", measured);
    }
    const auto unchanged = std::ranges::count_if(counts.by_pair, is_none);
    const auto changed = std::ranges::count_if(counts.by_pair, [](std::size_t n) { return n >= least_differences; });
    if (unchanged != 1 || changed != 2) {
      return undecided(unchanged == 3 ? "No answer near touching changes where coordinates are exchanged: it computes "
                                        "with more digits than show."
                                      : "The answers near touching that change do not name one pair of coordinates.",
                       measured);
    }
    const std::size_t pair =
        static_cast<std::size_t>(std::ranges::find(counts.by_pair, std::size_t{0}) - counts.by_pair.begin());
    Json with_pair = measured;
    with_pair["first_pair"] = exchanges[pair].name;
    return decided(pair == 0 ? Order::left_to_right : Order::other_order,
                   fmt::format("It rounds every operation, and adds {} of a dot product first: exchanging these two "
                               "changes no answer near touching, and exchanging others does.",
                               exchanges[pair].name),
                   {*general_witness}, with_pair);
  }

  Subject<Real>& subject_;
  const decltype(Scenes<Real>::near_tie) near_tie_;
  std::size_t asked_ = 0, answered_ = 0;  // pairs, and those of which both are decided
  bool says_contact_ = false, says_separated_ = false;
};

}  // namespace

template <class Real>
ProbeFinding operation_order(Subject<Real>& subject) {
  if (!scenes_of<Real>(subject.predicate()).near_tie) {
    std::vector<std::string_view> with_near_ties;
    for (const Predicate* predicate : predicates()) {
      if (scenes_of<Real>(*predicate).near_tie) with_near_ties.push_back(predicate->id);
    }
    return unasked(fmt::format("Near ties in a plane, by which the order shows, are made of {} alone.",
                               fmt::join(with_near_ties, " and ")));
  }
  return OrderProbe<Real>(subject).found();
}
template ProbeFinding operation_order(Subject<float>&);
template ProbeFinding operation_order(Subject<double>&);

}  // namespace axiscert::diagnosis
