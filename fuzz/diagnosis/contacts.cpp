// The numbers that a kernel gives beside the verdicts of clear queries: what they are like.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "fuzz/diagnosis/judged_contacts.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/text/json.h"

namespace axiscert::diagnosis {
namespace contacts {  // named: lambdas of templates that see its types are no warning in a unity build

constexpr std::size_t fewest_judged = 32;
constexpr std::size_t most_exchanged = 64;  // judged once more with exchanged points, at 4 ms each

// Empty where the kernel can be asked.
template <class Real>
std::optional<ProbeFinding> why_unasked(Subject<Real>& subject, MeasureKind kind) {
  if (!has_measure(subject.predicate(), kind))
    return unasked(fmt::format("This predicate has no {} beside its verdict.", name(kind)));
  if (!gives_measure(subject.predicate(), subject.kernel().measure_count, kind))
    return unasked(fmt::format("It gives no {} beside its verdict.", name(kind)));
  return std::nullopt;
}

ProbeFinding too_few(std::size_t count, MeasureKind kind) {
  const std::string what = kind == MeasureKind::point_b ? "both points" : fmt::format("a {}", name(kind));
  return undecided(fmt::format("It gives {} on {} clear queries: too few to say.", what, count));
}

template <class Real>
std::vector<DiagnosisWitness> witness_of(const Subject<Real>& subject, const JudgedContact<Real>& one,
                                         std::string shows) {
  return {subject.witness(one.query, one.said, std::move(shows))};
}

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// The measurements of a right kernel: on the queries by which rules are found, and on how many others nothing is wrong.
template <class Real>
Json with_families(Json measured, const OnFamilies<Real>& others) {
  measured["of_families"] = others.of;
  return measured;
}

// Whether an answer gives a number, and whether it lacks it though there is one.
struct Given {
  bool is_given, is_missing;
};
Given given_of(const ContactJudgement& found, MeasureKind kind) {
  switch (kind) {
    case MeasureKind::separation:
      return {found.separation.has_value(), found.lacks_separation};
    case MeasureKind::feature:
      return {found.feature_is_right.has_value(), found.lacks_feature};
    case MeasureKind::normal:
      return {found.normal_length_error.has_value(), found.lacks_normal};
    default:
      return {found.point_error || found.point_b_error, found.lacks_point};
  }
}

// The numbers that are given are right: whether some are missing, on any clear query that was judged.
template <Enumeration Value, class Real>
ProbeFinding right_or_missing(Subject<Real>& subject, MeasureKind kind, std::string sentence, Json measured) {
  std::size_t of = 0, missing = 0;
  const JudgedContact<Real>* shown = nullptr;
  for (const bool of_families : {false, true}) {
    for (const JudgedContact<Real>& one : subject.judged_contacts(of_families)) {
      if (one.query.size() == 0 || one.found.missed) continue;
      const Given given = given_of(one.found, kind);
      of += given.is_given || given.is_missing;
      missing += given.is_missing;
      if (given.is_missing && shown == nullptr) shown = &one;
    }
  }
  if (shown == nullptr) return decided(Value::right, std::move(sentence), {}, std::move(measured));
  const char* const what = kind == MeasureKind::point_b ? "point" : name(kind).data();
  measured["missing"] = missing;
  return decided(Value::missing, fmt::format("{} It gives none beside {} of {} that have one.", sentence, missing, of),
                 witness_of(subject, *shown, fmt::format("no {} is given", what)), std::move(measured));
}

}  // namespace contacts

template <class Real>
ProbeFinding separations(Subject<Real>& subject) {
  using namespace contacts;
  constexpr MeasureKind kind = MeasureKind::separation;
  if (auto why = why_unasked(subject, kind)) return *why;
  std::vector<JudgedContact<Real>> all = judged_queries(subject);
  subject.leave_out(std::erase_if(
      all, [](const JudgedContact<Real>& one) { return !one.found.separation || !one.exact.separation; }));
  if (all.size() < fewest_judged) return too_few(all.size(), kind);
  const std::size_t place = *first_measure(subject.predicate(), kind);
  const auto given = [&](const JudgedContact<Real>& one) { return one.measures[place]; };
  const auto is_wrong = [](const JudgedContact<Real>& one) {
    return one.found.separation->share > small<Real> * one.reach;
  };
  const auto count = [&](auto&& holds) { return static_cast<std::size_t>(std::ranges::count_if(all, holds)); };
  const auto shown =
      std::ranges::max_element(all, {}, [](const JudgedContact<Real>& one) { return one.found.separation->share; });
  const std::size_t wrong = count(is_wrong);
  const Json measured = {{"wrong", wrong}, {"of", all.size()}, {"largest_error", shown->found.separation->share}};
  const auto shows = [&](const JudgedContact<Real>& one) {
    return witness_of(subject, one, fmt::format("separation {}, exact {}", given(one), *one.exact.separation));
  };
  const auto found = [&](Separations value, std::string sentence, Json numbers) {
    return decided(value, std::move(sentence), shows(*shown), std::move(numbers));
  };
  if (wrong == 0) {
    const auto others = on_families(subject, [&](const JudgedContact<Real>& one) -> std::optional<double> {
      if (!one.found.separation || !one.exact.separation) return std::nullopt;
      return is_wrong(one) ? one.found.separation->share : 0;
    });
    if (others.shown)
      return decided(Separations::wrong, others.text("Its separations are"), shows(*others.shown), others.measured());
    return right_or_missing<Separations>(
        subject, kind,
        fmt::format("Its separations are right but for rounding on {} clear queries.", all.size() + others.of),
        with_families(measured, others));
  }
  const auto is_apart = [](const JudgedContact<Real>& one) { return *one.exact.separation > 0; };
  const std::size_t apart = count(is_apart),
                    above = count([&](const JudgedContact<Real>& one) { return given(one) > 0; });
  const std::size_t wrong_deep = count([&](const JudgedContact<Real>& one) { return is_wrong(one) && !is_apart(one); });
  if (above == 0 && apart >= fewest_judged && !holds_on_most(wrong_deep, all.size() - apart))
    return found(Separations::never_positive,
                 fmt::format("Its separations are never above 0, on {} clear queries that are apart neither.", apart),
                 measured);
  const auto is_off_by = [&](const JudgedContact<Real>& one, double by) {
    const SeparationError& error = *one.found.separation;
    const double scene = error.share > 0 ? error.length / error.share : 0;
    return std::fabs(given(one) - *one.exact.separation - by) <= 1e-3 * std::fabs(by) + small<Real> * scene;
  };
  if (holds_on_most(count([&](const JudgedContact<Real>& one) { return is_off_by(one, -2 * *one.exact.separation); }),
                    all.size()))
    return found(Separations::negated, "Its separations have the other sign: above 0 where the two overlap.", measured);
  if (const ContactLikeness* like = likeness_of(subject, all, kind, is_wrong)) {
    return found(enumerator_named<Separations>(like->value).value(),
                 fmt::format("{}: so on {} of {} clear queries, where that is another number.", like->sentence, wrong,
                             all.size()),
                 measured);
  }
  std::vector<double> off;
  for (const JudgedContact<Real>& one : all) off.push_back(given(one) - *one.exact.separation);
  // The median of a fault of few queries is a rounding: no margin, and no factor.
  const bool are_most_wrong = holds_on_most(wrong, all.size());
  const double margin = median(off);
  if (are_most_wrong &&
      holds_on_most(count([&](const JudgedContact<Real>& one) { return is_off_by(one, margin); }), all.size())) {
    Json numbers = measured;
    numbers["margin"] = margin;
    return found(Separations::margin,
                 fmt::format("Its separations are {} by {:.3g} everywhere, in the queries' unit: a margin, or a slop.",
                             margin < 0 ? "less" : "more", std::fabs(margin)),
                 std::move(numbers));
  }
  std::vector<double> factors;
  for (const JudgedContact<Real>& one : all) {
    if (*one.exact.separation != 0) factors.push_back(given(one) / *one.exact.separation);
  }
  const double factor = factors.empty() ? 1 : median(factors);
  const auto is_scaled = [&](const JudgedContact<Real>& one) {
    return is_off_by(one, (factor - 1) * *one.exact.separation);
  };
  if (are_most_wrong && holds_on_most(count(is_scaled), all.size())) {
    Json numbers = measured;
    numbers["factor"] = factor;
    return found(Separations::scaled,
                 fmt::format("Its separations are {:.3g} times what they are, everywhere.", factor),
                 std::move(numbers));
  }
  return found(Separations::wrong,
               fmt::format("{} of {} separations on clear queries are wrong, by up to {:.3g} of the scene: no rule.",
                           wrong, all.size(), shown->found.separation->share),
               measured);
}
template ProbeFinding separations(Subject<float>&);
template ProbeFinding separations(Subject<double>&);

template <class Real>
ProbeFinding normals(Subject<Real>& subject) {
  using namespace contacts;
  constexpr MeasureKind kind = MeasureKind::normal;
  if (auto why = why_unasked(subject, kind)) return *why;
  std::vector<JudgedContact<Real>> all = judged_queries(subject);
  subject.leave_out(std::erase_if(all, [](const JudgedContact<Real>& one) { return !one.found.normal_angle; }));
  if (all.size() < fewest_judged) return too_few(all.size(), kind);
  const auto angle = [](const JudgedContact<Real>& one) { return *one.found.normal_angle; };
  const auto length = [](const JudgedContact<Real>& one) { return one.found.normal_length_error.value_or(0); };
  const auto is_wrong = [&](const JudgedContact<Real>& one) { return angle(one) > small<Real>; };
  const auto count = [&](auto&& holds) { return static_cast<std::size_t>(std::ranges::count_if(all, holds)); };
  const auto shown = std::ranges::max_element(all, {}, angle);
  const std::size_t wrong = count(is_wrong);
  std::vector<double> angles, lengths;
  for (const JudgedContact<Real>& one : all) {
    angles.push_back(angle(one));
    lengths.push_back(length(one));
  }
  const double usual = median(angles), usual_length = median(lengths);
  const Json measured = {
      {"wrong", wrong}, {"of", all.size()}, {"largest_angle", angle(*shown)}, {"length_error", usual_length}};
  const auto found = [&](Normals value, std::string sentence) {
    return decided(value, std::move(sentence),
                   witness_of(subject, *shown, fmt::format("the normal is {:.3g} radians off", angle(*shown))),
                   measured);
  };
  const auto no_rule = [&](std::size_t count_wrong) {
    return found(Normals::wrong,
                 fmt::format("{} of {} normals on clear queries are wrong, by up to {:.3g} radians: no rule.",
                             count_wrong, all.size(), angle(*shown)));
  };
  // A normal of 0 has no direction, and its angle is pi.
  const std::size_t place = *first_measure(subject.predicate(), kind);
  const auto is_zero = [&](const JudgedContact<Real>& one) {
    return std::ranges::all_of(std::span(one.measures).subspan(place, 3), [](double x) { return x == 0; });
  };
  const std::size_t zeros = count(is_zero);
  if (zeros != 0 && holds_on_most(all.size() - (wrong - zeros), all.size()))
    return found(Normals::not_normalised,
                 fmt::format("{} of {} normals on clear queries are 0, which is no direction.", zeros, all.size()));
  if (!holds_on_most(all.size() - wrong, all.size())) {
    constexpr double nearly_opposite = std::numbers::pi - 1e-2;
    const std::size_t opposite = count([&](const JudgedContact<Real>& one) { return angle(one) > nearly_opposite; });
    if (holds_on_most(opposite, all.size()))
      return found(Normals::flipped,
                   fmt::format("Its normals go to the other side, on {} of {} clear queries.", opposite, all.size()));
    if (const ContactLikeness* like = likeness_of(subject, all, kind, is_wrong))
      return found(enumerator_named<Normals>(like->value).value(),
                   fmt::format("{}: so on {} of {} clear queries, where that is another direction.", like->sentence,
                               wrong, all.size()));
    const auto is_usual = [&](const JudgedContact<Real>& one) { return angle(one) <= 1.5 * usual; };
    if (usual > small<Real> && holds_on_most(count(is_usual), all.size()))
      return found(Normals::tilted,
                   fmt::format("Its normals are tilted, by {:.3g} radians and hardly ever more.", usual));
    return no_rule(wrong);
  }
  if (usual_length > small<Real>)
    return found(
        Normals::not_normalised,
        fmt::format("Its normals have the right direction, and lengths that are off by {:.3g} of 1.", usual_length));
  // Few directions may be far off for rounding, where the exact one is of a short vector; no length, and no side.
  const auto is_far = [&](const JudgedContact<Real>& one) { return !is_zero(one) && is_far_off(subject, one); };
  const auto is_flip = [&](const JudgedContact<Real>& one) {
    if (!has_clear_side(subject, one)) return false;
    if (one.found.pushed) return one.found.pushed->is_flip;
    return *one.exact.separation > 0 && one.found.normal_angle.value_or(0) > std::numbers::pi / 2 && !is_zero(one);
  };
  constexpr const char* other_side = "the normal goes to the other side";
  const auto shows_length = [&](const JudgedContact<Real>& one) {
    return witness_of(subject, one, fmt::format("the normal's length is {:.3g} off", length(one)));
  };
  if (const std::size_t flips = count(is_flip); flips != 0)
    return decided(Normals::wrong,
                   fmt::format("{} of {} normals on clear queries go to the other side.", flips, all.size()),
                   witness_of(subject, *std::ranges::find_if(all, is_flip), other_side), measured);
  if (const std::size_t far = count(is_far); far != 0) return no_rule(far);
  const auto is_uneven = [&](const JudgedContact<Real>& one) { return length(one) > small<Real>; };
  const auto longest = std::ranges::max_element(all, {}, length);
  if (is_uneven(*longest))
    return decided(Normals::not_normalised,
                   fmt::format("Its normals have the right direction; {} of {} have lengths that are off, by up to "
                               "{:.3g} of 1.",
                               count(is_uneven), all.size(), length(*longest)),
                   shows_length(*longest), measured);
  // Flips are shown before other directions, by their angle, and these before lengths.
  std::size_t turned = 0, far = 0, uneven = 0;
  double most_uneven = 0, farthest = 0;
  const auto others = on_families(subject, [&](const JudgedContact<Real>& one) -> std::optional<double> {
    if (!one.found.normal_length_error) return std::nullopt;
    const bool turns = is_flip(one);
    if (!turns && is_far(one)) {
      ++far;
      farthest = std::max(farthest, one.found.normal_angle.value_or(0));
      return 1 + one.found.normal_angle.value_or(0);
    }
    turned += turns;
    uneven += is_uneven(one);
    most_uneven = std::max(most_uneven, length(one));
    if (turns) return std::numeric_limits<double>::infinity();
    return is_uneven(one) ? length(one) / (1 + length(one)) : 0;
  });
  if (others.shown)
    return decided(turned + far != 0 ? Normals::wrong : Normals::not_normalised,
                   fmt::format("Its normals are right but for rounding on clear queries of one family. Of {} of all "
                               "families {} go to the other side, {} are off otherwise, and {} are longer or shorter "
                               "than 1.",
                               others.of, turned, far, uneven),
                   turned != 0 ? witness_of(subject, *others.shown, other_side)
                   : far != 0
                       ? witness_of(subject, *others.shown, fmt::format("the normal is {:.3g} radians off", farthest))
                       : shows_length(*others.shown),
                   {{"wrong", others.wrong},
                    {"of", others.of},
                    {"turned", turned},
                    {"off", far},
                    {"largest_length_error", most_uneven}});
  return right_or_missing<Normals>(
      subject, kind,
      fmt::format("Its normals are right but for rounding on {} of {} clear queries.", all.size() - wrong, all.size()),
      with_families(measured, others));
}
template ProbeFinding normals(Subject<float>&);
template ProbeFinding normals(Subject<double>&);

template <class Real>
ProbeFinding features(Subject<Real>& subject) {
  using namespace contacts;
  constexpr MeasureKind kind = MeasureKind::feature;
  if (auto why = why_unasked(subject, kind)) return *why;
  std::vector<JudgedContact<Real>> all = judged_queries(subject);
  subject.leave_out(std::erase_if(all, [](const JudgedContact<Real>& one) { return !one.found.feature_is_right; }));
  if (all.size() < fewest_judged) return too_few(all.size(), kind);
  const std::size_t place = *first_measure(subject.predicate(), kind);
  std::map<double, std::size_t> said;
  std::size_t wrong = 0;
  const JudgedContact<Real>* shown = nullptr;
  for (const JudgedContact<Real>& one : all) {
    ++said[one.measures[place]];
    const bool is_wrong = !*one.found.feature_is_right;
    wrong += is_wrong;
    if (is_wrong && (shown == nullptr || one.found.feature_error.value_or(0) > shown->found.feature_error.value_or(0)))
      shown = &one;
  }
  const Json measured = {{"wrong", wrong}, {"of", all.size()}};
  const auto shows = [&](const JudgedContact<Real>& one) {
    return witness_of(subject, one, fmt::format("the feature is {}", one.measures[place]));
  };
  if (shown == nullptr) {
    // Between two parts a rounding decides.
    const auto others = on_families(subject, [&](const JudgedContact<Real>& one) -> std::optional<double> {
      if (!one.found.feature_is_right) return std::nullopt;
      const double off = *one.found.feature_is_right ? 0 : one.found.feature_error.value_or(0);
      return off > coarse<Real> * one.reach ? off : 0;
    });
    if (others.shown)
      return decided(
          Features::wrong,
          fmt::format(
              "It names a part that is not nearest on {} of {} clear queries of all families, and on none of one.",
              others.wrong, others.of),
          shows(*others.shown), {{"wrong", others.wrong}, {"of", others.of}});
    return right_or_missing<Features>(
        subject, kind, fmt::format("It names a part that is nearest on {} clear queries.", all.size() + others.of),
        with_families(measured, others));
  }
  const auto witnesses = shows(*shown);
  if (said.size() == 1)
    return decided(Features::one_part,
                   fmt::format("It says {} whatever is nearest: wrong on {} of {} clear queries.", said.begin()->first,
                               wrong, all.size()),
                   witnesses, measured);
  return decided(Features::wrong,
                 fmt::format("It names a part that is not nearest on {} of {} clear queries.", wrong, all.size()),
                 witnesses, measured);
}
template ProbeFinding features(Subject<float>&);
template ProbeFinding features(Subject<double>&);

template <class Real>
ProbeFinding contact_points(Subject<Real>& subject) {
  using namespace contacts;
  const bool has_pair = has_measure(subject.predicate(), MeasureKind::point_b);
  const MeasureKind kind = has_pair ? MeasureKind::point_b : MeasureKind::point;
  if (auto why = why_unasked(subject, kind)) return *why;
  std::vector<JudgedContact<Real>> all = judged_queries(subject);
  const auto error = [&](const JudgedContact<Real>& one) {
    const ContactJudgement& found = one.found;
    const double off = found.point_error.value_or(0);
    if (!has_pair) return off;
    return std::max(
        {off, found.point_a_error.value_or(0), found.point_b_error.value_or(0), found.points_apart.value_or(0)});
  };
  const auto is_given = [&](const JudgedContact<Real>& one) {
    return has_pair ? one.found.point_b_error.has_value() : one.found.point_error.has_value();
  };
  subject.leave_out(std::erase_if(all, [&](const JudgedContact<Real>& one) { return !is_given(one); }));
  if (all.size() < fewest_judged) return too_few(all.size(), kind);
  const auto is_wrong = [&](const JudgedContact<Real>& one) { return error(one) > small<Real> * one.reach; };
  const auto wrong = static_cast<std::size_t>(std::ranges::count_if(all, is_wrong));
  const auto shown = std::ranges::max_element(all, {}, error);
  const Json measured = {{"wrong", wrong}, {"of", all.size()}, {"largest_error", error(*shown)}};
  const auto shows = [&](const JudgedContact<Real>& one) {
    return witness_of(subject, one, fmt::format("the point is {:.3g} of the scene off", error(one)));
  };
  if (wrong == 0) {
    const auto others = on_families(subject, [&](const JudgedContact<Real>& one) -> std::optional<double> {
      if (!is_given(one)) return std::nullopt;
      return error(one) > coarse<Real> * one.reach ? error(one) : 0;
    });
    if (others.shown)
      return decided(Points::wrong, others.text("Its points are"), shows(*others.shown), others.measured());
    return right_or_missing<Points>(
        subject, kind,
        fmt::format("Its points are right but for rounding on {} clear queries, on {} of all families to {:.2g} of the "
                    "scene.",
                    all.size() + others.of, others.of, coarse<Real>),
        with_families(measured, others));
  }
  const auto witnesses = shows(*shown);
  if (const ContactLikeness* like = likeness_of(subject, all, kind, is_wrong))
    return decided(enumerator_named<Points>(like->value).value(),
                   fmt::format("{}: so on {} of {} clear queries.", like->sentence, wrong, all.size()), witnesses,
                   measured);
  if (has_pair) {
    std::size_t met = 0, asked = 0, exchanged = 0;
    for (const JudgedContact<Real>& one : all) {
      if (!is_wrong(one) || met++ * most_exchanged / wrong < asked) continue;  // evenly among the wrong ones
      JudgedContact<Real> other = one;
      const auto at = [&](MeasureKind which) {
        return other.measures.begin() + static_cast<std::ptrdiff_t>(*first_measure(subject.predicate(), which));
      };
      std::swap_ranges(at(MeasureKind::point_a), at(MeasureKind::point_a) + 3, at(MeasureKind::point_b));
      other.found = oracles_of(subject.kernel()).contact_judge(one.query)->judge(one.said, other.measures);
      ++asked;
      exchanged += !is_wrong(other);
    }
    if (asked >= fewest_judged && holds_on_most(exchanged, asked))
      return decided(Points::exchanged,
                     fmt::format("It says of each body the point of the other: so on {} of {} that are wrong, of {} on "
                                 "{} clear queries.",
                                 exchanged, asked, wrong, all.size()),
                     witnesses, measured);
  }
  return decided(Points::wrong,
                 fmt::format("{} of {} points on clear queries are wrong, by up to {:.3g} of the scene: no rule.",
                             wrong, all.size(), error(*shown)),
                 witnesses, measured);
}
template ProbeFinding contact_points(Subject<float>&);
template ProbeFinding contact_points(Subject<double>&);

}  // namespace axiscert::diagnosis
