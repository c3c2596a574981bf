#include "fuzz/queries/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "exact/numbers/rational.h"
#include "fuzz/queries/query_shape.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::string_view sweep_examples = "offset=2^0..2^20 or size=1,10,100";
constexpr int greatest_power = 1074, greatest_double_power = 1023;  // of two in binary64: 2^-1074 to 2^1023

std::optional<int> power_of_two(std::string_view text) {
  if (!text.starts_with("2^")) return std::nullopt;
  text.remove_prefix(2);
  int power = 0;
  const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), power);
  if (problem != std::errc() || stop != text.data() + text.size() || power < -greatest_power ||
      power > greatest_double_power)
    return std::nullopt;
  return power;
}

SweepPoint point_of(std::string_view given, SweepParameter parameter, std::string_view text) {
  double value = 0;
  const std::string_view digits = text.starts_with('-') ? text.substr(1) : text;
  if (const auto power = power_of_two(digits)) {
    value = std::ldexp(text.starts_with('-') ? -1.0 : 1.0, *power);
  } else {
    const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || problem != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) {
      throw Error(fmt::format("sweep '{}': '{}' is not a number; values are as 2^8 or 100, for instance {}", given,
                              text, sweep_examples));
    }
  }
  const bool is_right =
      parameter == SweepParameter::offset || (parameter == SweepParameter::size ? value > 0 : value >= 0);
  if (!is_right) {
    throw Error(fmt::format("sweep '{}': a {} is {}, not {}", given, name(parameter),
                            parameter == SweepParameter::size ? "above 0" : "not negative", text));
  }
  return {parameter, std::string(text), value};
}

class SweptSource final : public Source {
 public:
  SweptSource(SourcePtr of, SweepPoint point)
      : of_(std::move(of)), point_(std::move(point)), shape_(shape_of(of_->predicate().entries[of_->entry()])) {}
  std::string name() const override { return of_->name() + " " + point_.name(); }
  std::string address_name() const override { return of_->address_name() + "+" + point_.name(); }
  std::string purpose() const override { return fmt::format("{}; {}", of_->purpose(), point_.name()); }
  int version() const override { return of_->version(); }
  int trial_divisor() const override { return of_->trial_divisor(); }
  std::optional<std::uint64_t> fixed_size(Precision precision) const override { return of_->fixed_size(precision); }
  std::uint64_t base_triangles(Precision precision, std::uint64_t trials) const override {
    return of_->base_triangles(precision, trials);
  }
  std::uint64_t cluster(Precision precision, std::uint64_t position) const override {
    return of_->cluster(precision, position);
  }
  std::size_t cluster_run() const override { return of_->cluster_run(); }
  std::optional<FileInfo> file() const override { return of_->file(); }
  const Predicate& predicate() const override { return of_->predicate(); }
  std::size_t entry() const override { return of_->entry(); }
  const SweepPoint& point() const { return point_; }
  const Source& unswept() const { return *of_; }

  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<float>& out) const override {
    change(seed, first, out);
  }
  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<double>& out) const override {
    change(seed, first, out);
  }

 private:
  template <class Real>
  void change(std::uint64_t seed, std::uint64_t first, const MutableColumns<Real>& out) const {
    of_->fill_columns(seed, first, out);
    for (std::size_t i = 0; i < out.size; ++i) {
      Numbers<Real> q = out[i];
      change(q);
      out.set(i, q);
    }
  }
  // Each new number is exact and rounded once; a number that is not finite, or that nothing changes, stays.
  template <class Real>
  void change(Numbers<Real>& q) const {
    if (point_.value == (point_.parameter == SweepParameter::offset ? 0 : 1)) return;
    const Rational value = exact(point_.value);
    const auto multiply = [&](Real& x) {
      if (std::isfinite(x)) x = nearest<Real>(Rational(exact(x) * value));
    };
    if (point_.parameter == SweepParameter::offset) {
      for (const std::size_t point : shape_.points) {
        for (std::size_t k = 0; k < shape_.axes; ++k) {
          Real& x = q[point + k];
          if (std::isfinite(x)) x = nearest<Real>(Rational(exact(x) + value));
        }
      }
      return;
    }
    for (std::size_t k = 0; k < shape_.numbers; ++k) {
      if (shape_.is_length[k]) multiply(q[k]);
    }
    if (point_.parameter == SweepParameter::radius) return;
    for (std::size_t i = 0; i < shape_.vertices(); ++i) {
      for (std::size_t k = 0; k < shape_.axes; ++k) {
        const Real of_centre = q[shape_.points.back() + k];
        Real& x = q[shape_.points[i] + k];
        if (!std::isfinite(of_centre) || !std::isfinite(x)) continue;
        const Rational centre = exact(of_centre);
        x = nearest<Real>(Rational(centre + (exact(x) - centre) * value));
      }
    }
    for (const std::size_t direction : shape_.directions) {
      if (is_of_frame(direction)) continue;
      for (std::size_t k = 0; k < shape_.axes; ++k) multiply(q[direction + k]);
    }
  }
  bool is_of_frame(std::size_t column) const {
    for (const std::size_t frame : shape_.frames) {
      if (column >= frame && column < frame + 9) return true;
    }
    return false;
  }

  const SourcePtr of_;
  const SweepPoint point_;
  const QueryShape shape_;
};

}  // namespace

Sweep parse_sweep(std::string_view given) {
  const std::size_t equals = given.find('=');
  const std::string_view parameter_text = given.substr(0, equals);
  const std::optional<SweepParameter> parameter = enumerator_named<SweepParameter>(parameter_text);
  if (!parameter) {
    throw Error(fmt::format("sweep '{}': {}", given,
                            unknown_name("parameter", "parameters", parameter_text,
                                         {sweep_parameter_names.begin(), sweep_parameter_names.end()})));
  }
  if (equals == given.npos) {
    throw Error(fmt::format("sweep '{}': without values; the form is PARAMETER=VALUES, for instance {}", given,
                            sweep_examples));
  }
  const std::string_view values = given.substr(equals + 1);
  Sweep sweep{*parameter, {}};
  if (const std::size_t dots = values.find(".."); dots != values.npos) {
    const auto first = power_of_two(values.substr(0, dots)), last = power_of_two(values.substr(dots + 2));
    if (!first || !last) {
      throw Error(fmt::format(
          "sweep '{}': a range is of powers of two from 2^-{} to 2^{}, 2^A..2^B, not '{}'; other values are "
          "listed: {}",
          given, greatest_power, greatest_double_power, values, sweep_examples));
    }
    if (*first > *last) {
      throw Error(fmt::format("sweep '{}': the range is empty, for 2^{} is greater than 2^{}; give 2^{}..2^{}", given,
                              *first, *last, *last, *first));
    }
    for (int power = *first; power <= *last; ++power)
      sweep.points.push_back(point_of(given, *parameter, fmt::format("2^{}", power)));
    return sweep;
  }
  for (std::size_t begin = 0; begin <= values.size();) {
    const std::size_t comma = std::min(values.find(',', begin), values.size());
    const SweepPoint point = point_of(given, *parameter, values.substr(begin, comma - begin));
    for (const SweepPoint& other : sweep.points) {
      if (other.value == point.value)
        throw Error(fmt::format("sweep '{}': {} and {} are the same value", given, other.text, point.text));
    }
    sweep.points.push_back(point);
    begin = comma + 1;
  }
  return sweep;
}

void require_within(const Sweep& sweep, Precision precision) {
  const double greatest = precision == Precision::binary32 ? static_cast<double>(std::numeric_limits<float>::max())
                                                           : std::numeric_limits<double>::max();
  for (const SweepPoint& point : sweep.points) {
    if (std::abs(point.value) <= greatest) continue;
    throw Error(fmt::format("sweep {}: {} reaches no further than 2^{}; give a smaller value{}", point.name(),
                            name(precision), precision == Precision::binary32 ? 127 : 1023,
                            precision == Precision::binary32 ? ", or --precision binary64" : ""));
  }
}

namespace {

template <class Real>
double scene_size_in(const Source& source, std::uint64_t seed) {
  const QueryShape shape = shape_of(source.predicate().entries[source.entry()]);
  const std::uint64_t most = source.fixed_size(precision_of<Real>).value_or(1000);
  std::vector<double> sizes;
  for (std::uint64_t position = 0; position < std::min<std::uint64_t>(most, 1000); ++position) {
    const Numbers<Real> q = source.make<Real>(seed, position);
    double size = 0;
    for (std::size_t k = 0; k < shape.numbers; ++k) {
      if (shape.is_length[k]) size = std::max(size, static_cast<double>(q[k]));
    }
    for (std::size_t i = 0; i < shape.vertices(); ++i) {
      for (std::size_t k = 0; k < shape.axes; ++k) {
        const double centre = q[shape.points.back() + k];
        size = std::max(size, std::abs(static_cast<double>(q[shape.points[i] + k]) - centre));
      }
    }
    if (std::isfinite(size)) sizes.push_back(size);
  }
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

}  // namespace

double median_scene_size(const Source& source, std::uint64_t seed, Precision precision) {
  return precision == Precision::binary32 ? scene_size_in<float>(source, seed) : scene_size_in<double>(source, seed);
}

SourcePtr swept_source(SourcePtr source, const SweepPoint& point) {
  const QueryShape shape = shape_of(source->predicate().entries[source->entry()]);
  if (point.parameter == SweepParameter::radius && std::ranges::count(shape.is_length, true) == 0) {
    throw Error(fmt::format("sweep {}: the queries of {} have no radius or other length; offset and size change them",
                            point.name(), source->name()));
  }
  return std::make_shared<SweptSource>(std::move(source), point);
}

const SweepPoint* swept_point(const Source& source) {
  const auto* swept = dynamic_cast<const SweptSource*>(&source);
  return swept != nullptr ? &swept->point() : nullptr;
}
const Source& unswept(const Source& source) {
  const auto* swept = dynamic_cast<const SweptSource*>(&source);
  return swept != nullptr ? swept->unswept() : source;
}

std::pair<std::string_view, std::optional<SweepPoint>> split_swept(std::string_view address_name) {
  const std::size_t plus = address_name.find('+');
  if (plus == address_name.npos) return {address_name, std::nullopt};
  const Sweep sweep = parse_sweep(address_name.substr(plus + 1));
  if (sweep.points.size() != 1) throw Error(fmt::format("'{}': an address names one value of a sweep", address_name));
  return {address_name.substr(0, plus), sweep.points.front()};
}

}  // namespace axiscert
