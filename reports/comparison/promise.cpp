#include "reports/comparison/promise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fuzz/text/json.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// One bound of the limits. 0 is none.
struct Bound {
  std::string_view quantity, sign;
  double Limits::*value;
  std::optional<double> LimitsRecord::*stated;

  bool is_least() const { return sign != "<="; }  // so is a margin, of which more leaves more out
  // "from 1e+30", "to 1e+06", "none"; of a margin "0.001".
  std::string text(double bound) const {
    if (bound == 0) return "none";
    return sign == "=" ? fmt::format("{}", bound) : fmt::format("{} {}", is_least() ? "from" : "to", bound);
  }
  bool is_narrower(double now, double before) const {
    if (now == 0 || before == 0) return now != 0 && before == 0;
    return is_least() ? now > before : now < before;
  }
};
constexpr Bound bounds[] = {{"coordinate", ">=", &Limits::least_coordinate, &LimitsRecord::least_coordinate},
                            {"coordinate", "<=", &Limits::greatest_coordinate, &LimitsRecord::greatest_coordinate},
                            {"area", ">=", &Limits::least_area, &LimitsRecord::least_area},
                            {"radius", ">=", &Limits::least_radius, &LimitsRecord::least_radius},
                            {"radius", "<=", &Limits::greatest_radius, &LimitsRecord::greatest_radius},
                            {"margin", "=", &Limits::margin, &LimitsRecord::margin}};
constexpr std::string_view may_decline_word = "may_decline";
constexpr std::string_view front_word = "front_only";  // of a triangle, in a predicate without motions

template <Enumeration Enum>
std::optional<Enum> named(std::string_view text, const auto& names) {
  for (const Enum one : enumerators<Enum>) {
    if (names[one] == text) return one;
  }
  return std::nullopt;
}

// The policies leave out the more, the later they stand in their enum.
template <Enumeration Enum>
void compare_policy(std::string_view what, Enum before, Enum now, const auto& names, PromiseChange& change) {
  if (before == now) return;
  (index_of(now) > index_of(before) ? change.less : change.other)
      .push_back(fmt::format("{} {}, was {}", what, names[now], names[before]));
}

// A word of a file, read into a promise.
class Reader {
 public:
  void add(const std::string& word) {
    const std::size_t at = word.find_first_of("<>=");
    const std::string name = word.substr(0, at);
    const std::string sign = at == word.npos ? "" : word.substr(at, word[at] == '=' ? 1 : 2);
    const std::string value = at == word.npos ? "" : word.substr(at + sign.size());
    if (!seen_.insert(name + sign).second) fail(word, "a second word for the same part");
    if (word == may_decline_word) promise_.may_decline = true;
    else if (word == front_word) promise_.limits.sides = SidesPolicy::front;
    else if (sign == "=" && bound_of(name, sign) == std::end(bounds)) add_name(word, name, value);
    else add_bound(word, name, sign, value);
  }

  Promise take() {
    if (!seen_.contains("touching=")) throw Error("a promise without touching=");
    const auto policies = {"start=", "still=", "sides="};
    const auto count = std::ranges::count_if(policies, [&](const char* policy) { return seen_.contains(policy); });
    if (count != 0 && count != static_cast<std::ptrdiff_t>(policies.size()))
      throw Error("a promise about motions has start=, still= and sides=");
    return promise_;
  }

 private:
  [[noreturn]] static void fail(const std::string& word, const std::string& what) {
    throw Error(
        fmt::format("'{}' is {}; a promise is touching=contact, separated or either, and as needed "
                    "coordinate>=X, coordinate<=X, area>=X, radius>=X, radius<=X, margin=X, front_only, may_decline, "
                    "and of motions start=, still=, sides=",
                    word, what));
  }

  static const Bound* bound_of(const std::string& name, const std::string& sign) {
    return std::ranges::find_if(bounds, [&](const Bound& b) { return b.quantity == name && b.sign == sign; });
  }

  void add_name(const std::string& word, const std::string& name, const std::string& value) {
    const auto put = [&]<Enumeration Enum>(Enum& into, const auto& names) {
      const auto found = named<Enum>(value, names);
      if (!found) fail(word, fmt::format("none of: {}", fmt::join(names, ", ")));
      into = *found;
    };
    if (name == "touching") return put(promise_.touching, touching_names);
    if (name != "start" && name != "still" && name != "sides") fail(word, "no part of a promise");
    if (!promise_.motion) promise_.motion.emplace();
    if (name == "start") put(promise_.motion->start, start_policy_names);
    else if (name == "still") put(promise_.motion->still, still_policy_names);
    else put(promise_.motion->sides, sides_policy_names);
  }

  void add_bound(const std::string& word, const std::string& name, const std::string& sign, const std::string& value) {
    const Bound* const bound = bound_of(name, sign);
    if (bound == std::end(bounds)) fail(word, "no part of a promise");
    const Json number = Json::parse(value, nullptr, false);
    if (!number.is_number() || !std::isfinite(number.get<double>()) || number <= 0) fail(word, "without a number > 0");
    promise_.limits.*(bound->value) = number.get<double>();
  }

  Promise promise_;
  std::set<std::string> seen_;
};

}  // namespace

Promise promise_in(const KernelRecord& entry) {
  Promise promise;
  promise.touching = entry.touching;
  promise.may_decline = entry.may_decline;
  if (entry.limits) {
    for (const Bound& bound : bounds) promise.limits.*(bound.value) = ((*entry.limits).*(bound.stated)).value_or(0);
    promise.limits.sides = entry.limits->sides.value_or(SidesPolicy::both);
  }
  if (entry.motion) promise.motion = MotionPolicy{entry.motion->start, entry.motion->still, entry.motion->sides};
  return promise;
}

Promise promise_of_kernel(const Kernel& kernel) {
  Promise promise{kernel.touching, kernel.limits, std::nullopt, kernel.may_decline};
  if (is_of_motions(*kernel.predicate)) promise.motion = kernel.motion;
  return promise;
}

std::string PromiseChange::text() const {
  std::vector<std::string> all = less;
  all.insert(all.end(), other.begin(), other.end());
  return fmt::format("{}", fmt::join(all, ", "));
}

PromiseChange change_of(const Promise& before, const Promise& now) {
  PromiseChange change;
  if (before.touching != now.touching) {
    (now.touching == TouchingPolicy::either ? change.less : change.other)
        .push_back(fmt::format("touching {}, was {}", name(now.touching), name(before.touching)));
  }
  for (const Bound& bound : bounds) {
    const double then = before.limits.*(bound.value), here = now.limits.*(bound.value);
    if (then == here) continue;
    (bound.is_narrower(here, then) ? change.less : change.other)
        .push_back(fmt::format("{} {}, was {}", bound.quantity, bound.text(here), bound.text(then)));
  }
  compare_policy("sides", before.limits.sides, now.limits.sides, sides_policy_names, change);
  const MotionPolicy then = before.motion.value_or(MotionPolicy{}), here = now.motion.value_or(MotionPolicy{});
  compare_policy("start", then.start, here.start, start_policy_names, change);
  compare_policy("still", then.still, here.still, still_policy_names, change);
  compare_policy("sides", then.sides, here.sides, sides_policy_names, change);
  if (before.may_decline != now.may_decline) {
    (now.may_decline ? change.less : change.other)
        .push_back(now.may_decline ? "it may decline, and might not before" : "it may not decline, and might before");
  }
  return change;
}

std::string ComparedPromise::text() const {
  return fmt::format("{} {} promises {}: {}", kernel, precision, is_alarm() ? "less" : "other things", change.text());
}

std::vector<std::string> words_of_promise(const Promise& promise) {
  std::vector<std::string> words = {fmt::format("touching={}", name(promise.touching))};
  for (const Bound& bound : bounds) {
    if (const double value = promise.limits.*(bound.value); value != 0)
      words.push_back(fmt::format("{}{}{}", bound.quantity, bound.sign, value));
  }
  if (promise.motion) {
    words.push_back(fmt::format("start={}", start_policy_names[promise.motion->start]));
    words.push_back(fmt::format("still={}", still_policy_names[promise.motion->still]));
    words.push_back(fmt::format("sides={}", sides_policy_names[promise.motion->sides]));
  }
  if (promise.limits.sides == SidesPolicy::front) words.emplace_back(front_word);
  if (promise.may_decline) words.emplace_back(may_decline_word);
  return words;
}

Promise promise_of_words(std::span<const std::string> words) {
  Reader reader;
  for (const std::string& word : words) reader.add(word);
  return reader.take();
}

}  // namespace axiscert
