#include "fuzz/campaign/parts/tally_code.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "fuzz/text/whole_number.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

using Cbor = nlohmann::json;

// The code below lists every member once, for both directions: a structured binding does not compile after a member is
// added, and where a base class prevents one, the size assertions detect that.
static_assert(sizeof(AxisTally) == sizeof(SignTally) + sizeof(std::uint64_t));
static_assert(sizeof(ComparisonTally) ==
              sizeof(SignTally) + 3 * sizeof(std::uint64_t) + sizeof(Leaders<Decimal6>) + 2 * sizeof(Leaders<bool>));

template <class Archive, class Tally>
void visit_signs(Archive& archive, Tally& tally) {
  auto& [false_separation, missed_separation, masked, decisive, tolerance_failures, links] = tally;
  archive(false_separation, missed_separation, masked, decisive, tolerance_failures, links);
}

template <class Archive, class Tally>
void visit_depths(Archive& archive, Tally& tally) {
  auto& [false_separation, false_contact] = tally;
  archive(false_separation, false_contact);
}

template <class Archive, class Tally>
void visit_verdict(Archive& archive, Tally& tally) {
  auto& [false_separation, false_contact, undecided, invalid, unanswered, undecided_contact, undecided_touching,
         touching_flips, links, masked_links, touching_links, deepest_false_separation, deepest_false_contact,
         deepest_by_link, first_by_link, outside, depths, engine] = tally;
  archive(false_separation, false_contact, undecided, invalid, unanswered, undecided_contact, undecided_touching,
          touching_flips, links, masked_links, touching_links, deepest_false_separation, deepest_false_contact,
          deepest_by_link, first_by_link);
  auto& [trials, outside_separation, outside_false_contact, outside_unanswered, contact, touching, deepest] = outside;
  archive(trials, outside_separation, outside_false_contact, outside_unanswered, contact, touching, deepest);
  auto& [engine_queries, engine_wrong] = engine;
  archive(engine_queries);
  visit_depths(archive, depths);
  visit_depths(archive, engine_wrong);
}

template <class Archive, class Tally>
void visit_motion(Archive& archive, Tally& tally) {
  auto& [hits, times, no_time, late, early, late_tunnels, missed_tunnels, largest_gap, features, wrong_features,
         normals, points, wrong_feature, largest_angle, largest_point_error] = tally;
  archive(hits, times, no_time);
  for (auto* errors : {&late, &early}) {
    auto& [by_power, largest_ulps, largest_in_u] = *errors;
    archive(by_power, largest_ulps, largest_in_u);
  }
  for (auto* tunnels : {&late_tunnels, &missed_tunnels}) {
    auto& [through, deepest] = *tunnels;
    archive(through, deepest);
  }
  archive(largest_gap, features, wrong_features, normals, points, wrong_feature, largest_angle, largest_point_error);
}

template <class Archive, class Tally>
void visit_tally(Archive& archive, Tally& tally) {
  auto& [trials, separated, contact, touching, invalid, verdict, axes, comparisons, critical_radius, findings, margins,
         classes, motion] = tally;
  archive(trials, separated, contact, touching, invalid);
  visit_verdict(archive, verdict);
  using Signs = std::conditional_t<std::is_const_v<Tally>, const SignTally, SignTally>;
  for (auto& axis : axes) {
    visit_signs(archive, static_cast<Signs&>(axis));
    archive(axis.sole_separator);
  }
  for (auto& comparison : comparisons) {
    visit_signs(archive, static_cast<Signs&>(comparison));
    archive(comparison.ties, comparison.range_events, comparison.error_without_scale, comparison.largest_error,
            comparison.false_witness, comparison.missed_witness);
  }
  auto& [errors_ulps, unbounded, unanswered, undecided_radius, invalid_radius] = critical_radius;
  archive(errors_ulps, unbounded, unanswered, undecided_radius, invalid_radius);
  for (auto& finding : findings) {
    auto& [count, first, detail] = finding;
    archive(count, first, detail);
  }
  archive(margins);
  auto& [by_class, first_wrong] = classes;
  for (auto& of : by_class) {
    auto& [false_separation, false_contact, deepest] = of;
    archive(false_separation, false_contact, deepest);
  }
  archive(first_wrong);
  visit_motion(archive, motion);
}

template <class Archive, class Of>
void visit_costs(Archive& archive, Of& costs) {
  auto& [core_seconds, second_opinions, all] = costs;
  auto& [queries, signs, checked, by_cgal, generation, kernels, errors, judging, steps] = all;
  archive(core_seconds, second_opinions, queries, signs, checked, by_cgal, generation, kernels, errors, judging, steps);
}

class Encoder {
 public:
  template <class... Members>
  void operator()(const Members&... members) {
    (put(members), ...);
  }
  std::string bytes() const {
    std::string bytes;
    Cbor::to_cbor(all_, bytes);
    return bytes;
  }

 private:
  template <class Number>
    requires std::is_arithmetic_v<Number>
  void put(Number value) {
    all_.push_back(value);
  }
  void put(const std::string& text) { all_.push_back(text); }
  void put(const Decimal6& rank) {
    all_.push_back(rank.exponent);
    all_.push_back(rank.mantissa);
  }
  void put(const std::vector<std::uint64_t>& positions) { all_.push_back(positions); }
  void put(const std::optional<std::uint64_t>& value) { all_.push_back(value ? Cbor(*value) : Cbor(nullptr)); }
  template <class Enum, class Value>
  void put(const EnumArray<Enum, Value>& values) {
    for (const Value& value : values) put(value);
  }
  template <class Value, std::size_t n>
  void put(const std::array<Value, n>& values) {
    for (const Value& value : values) put(value);
  }
  template <class Enum, class Value>
  void put(const std::vector<EnumArray<Enum, Value>>& by_comparison) {
    put(by_comparison.size());
    for (const auto& values : by_comparison) put(values);
  }
  void put(const MarginTally& margins) {
    put(margins.counts().size());
    for (const auto& [key, count] : margins.counts()) (*this)(key.first, key.second, count.right, count.wrong);
  }
  template <class Rank>
  void put(const Leaders<Rank>& leaders) {
    put(leaders.candidates().size());
    for (const auto& [rank, position] : leaders.candidates()) (*this)(rank, position);
  }
  // Numbers whose order has no meaning: each value once, with its count. Many are equal.
  void put(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    Cbor runs = Cbor::array();
    for (auto begin = values.begin(); begin != values.end();) {
      const auto end = std::upper_bound(begin, values.end(), *begin);
      runs.push_back(*begin);
      runs.push_back(end - begin);
      begin = end;
    }
    all_.push_back(std::move(runs));
  }

  Cbor all_ = Cbor::array();
};

class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : all_(Cbor::from_cbor(bytes)) {}
  template <class... Members>
  void operator()(Members&... members) {
    (get(members), ...);
  }
  void finish() const {
    if (!all_.is_array() || next_ != all_.size()) throw Error("the bytes are not a tally");
  }

 private:
  const Cbor& next() { return all_.at(next_++); }
  template <class Number>
    requires std::is_arithmetic_v<Number>
  void get(Number& value) {
    const Cbor& json = next();
    if constexpr (std::is_integral_v<Number> && !std::is_same_v<Number, bool>) value = whole_number<Number>(json);
    else json.get_to(value);
  }
  void get(std::string& text) { next().get_to(text); }
  void get(Decimal6& rank) { (*this)(rank.exponent, rank.mantissa); }
  void get(std::optional<std::uint64_t>& value) {
    const Cbor& json = next();
    value = json.is_null() ? std::nullopt : std::optional(whole_number<std::uint64_t>(json));
  }
  template <class Enum, class Value>
  void get(EnumArray<Enum, Value>& values) {
    for (Value& value : values) get(value);
  }
  template <class Value, std::size_t n>
  void get(std::array<Value, n>& values) {
    for (Value& value : values) get(value);
  }
  template <class Enum, class Value>
  void get(std::vector<EnumArray<Enum, Value>>& by_comparison) {
    std::size_t count = 0;
    get(count);
    if (count > most_comparisons) throw Error(fmt::format("the bytes are not a tally: {} comparisons", count));
    by_comparison.resize(count);
    for (auto& values : by_comparison) get(values);
  }
  void get(MarginTally& margins) {
    std::size_t size = 0;
    get(size);
    for (std::size_t i = 0; i < size; ++i) {
      std::uint8_t comparison = 0;
      std::int8_t exponent = 0;
      MarginCount count;
      (*this)(comparison, exponent, count.right, count.wrong);
      margins.add(comparison, exponent, count);
    }
  }
  template <class Rank>
  void get(Leaders<Rank>& leaders) {
    std::size_t count = 0;
    get(count);
    for (std::size_t i = 0; i < count; ++i) {
      Candidate<Rank> candidate{};
      (*this)(candidate.rank, candidate.position);
      leaders.offer(candidate);
    }
  }
  void get(std::vector<std::uint64_t>& positions) {
    const Cbor& all = next();
    if (!all.is_array() || all.size() > nearest_queries) throw Error("the bytes are not a tally: too many positions");
    for (const Cbor& position : all) positions.push_back(whole_number<std::uint64_t>(position));
  }
  void get(std::vector<double>& values) {
    const Cbor& runs = next();
    for (std::size_t i = 0; i + 1 < runs.size(); i += 2) {
      const auto count = whole_number<std::size_t>(runs[i + 1]);
      constexpr std::size_t most = std::size_t{1} << 16;  // per source (has_critical_radius)
      if (count > most) throw Error(fmt::format("the bytes are not a tally: a critical radius {} times", count));
      values.insert(values.end(), count, runs[i].get<double>());
    }
  }

  Cbor all_;
  std::size_t next_ = 0;
};

// Calls read(decoder), and reports bytes that do not fit as an Error.
template <class Read>
void decode(std::string_view bytes, Read&& read) {
  try {
    Decoder decoder(bytes);
    read(decoder);
    decoder.finish();
  } catch (const Cbor::exception& wrong) {
    throw Error(std::string("the bytes are not a tally: ") + wrong.what());
  }
}

}  // namespace

std::string encode(const Tally& tally) {
  Encoder encoder;
  visit_tally(encoder, tally);
  return encoder.bytes();
}

std::string encode(const Costs& costs) {
  Encoder encoder;
  visit_costs(encoder, costs);
  return encoder.bytes();
}

Tally decode_tally(std::string_view bytes, const TestDescription& test) {
  Tally tally(test);
  decode(bytes, [&](Decoder& decoder) { visit_tally(decoder, tally); });
  return tally;
}

Costs decode_costs(std::string_view bytes) {
  Costs costs;
  decode(bytes, [&](Decoder& decoder) { visit_costs(decoder, costs); });
  return costs;
}

}  // namespace axiscert
