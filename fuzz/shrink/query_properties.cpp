#include "fuzz/shrink/query_properties.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "exact/judge/oracles.h"
#include "exact/numbers/input_scale.h"
#include "exact/numbers/rational.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert {
BinaryDigits binary_digits(double x) {
  int exponent = 0;
  const double fraction = std::frexp(std::fabs(x), &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(digits);
  return {digits >> zeros, exponent - 53 + zeros};
}

namespace {

template <class Real>
QuerySize size_in(const Numbers<Real>& v) {
  QuerySize size;
  Numbers<Real> seen(v.size());
  for (std::size_t k = 0; k < v.size(); ++k) {
    size.negatives += std::signbit(v[k]);
    if (v[k] == 0) continue;
    const auto width = static_cast<int>(std::bit_width(binary_digits(v[k]).digits));
    size.bits += width;
    size.exponents += std::abs(std::ilogb(v[k]));
    size.places += static_cast<int>(k);
    const auto known = seen.begin() + size.magnitudes;
    if (std::find(seen.begin(), known, std::fabs(v[k])) == known) {
      *known = std::fabs(v[k]);
      ++size.magnitudes;
    }
    ++size.nonzero;
  }
  return size;
}

}  // namespace

QuerySize size_of(const Numbers<float>& q) { return size_in(q); }
QuerySize size_of(const Numbers<double>& q) { return size_in(q); }

namespace {

using Rationals = std::vector<Rational>;

Rationals exact_difference(const Rationals& x, const Rationals& y) {
  Rationals out;
  for (std::size_t axis = 0; axis < x.size(); ++axis) out.push_back(Rational(x[axis] - y[axis]));
  return out;
}
bool is_zero_vector(const Rationals& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return sgn(x) == 0; });
}

// The dimension of what the vectors span.
std::size_t rank_of(std::vector<Rationals> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows.front().size() && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && sgn(rows[pivot][column]) == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t row = rank + 1; row < rows.size(); ++row) {
      const Rational factor = rows[row][column] / rows[rank][column];
      for (std::size_t k = column; k < rows[row].size(); ++k) rows[row][k] -= factor * rows[rank][k];
    }
    ++rank;
  }
  return rank;
}

// A query of any predicate as exact vectors.
class ExactParts {
 public:
  template <class Real>
  ExactParts(const QueryShape& shape, const Numbers<Real>& q) {
    const auto vector = [&](std::size_t first) {
      Rationals v;
      for (std::size_t axis = 0; axis < shape.axes; ++axis) v.push_back(exact(q[first + axis]));
      return v;
    };
    for (const std::size_t first : shape.points) points_.push_back(vector(first));
    for (const std::size_t first : shape.directions) directions_.push_back(vector(first));
    for (std::size_t k = 0; k < shape.numbers; ++k) {
      if (shape.is_length[k]) lengths_.push_back(exact(q[k]));
    }
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) spanned_.push_back(exact_difference(points_[i], points_[0]));
    for (const Rationals& v : points_) include(exact_difference(v, points_.back()));
    for (const Rationals& v : directions_) include(v);
    include(lengths_);
  }

  const Rational& extent() const { return extent_; }
  bool has_equal_points() const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (std::find(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(i), points_[i]) !=
          points_.begin() + static_cast<std::ptrdiff_t>(i))
        return true;
    }
    return false;
  }
  bool is_collinear() const { return spanned_.size() >= 2 && rank_of(spanned_) < 2; }
  bool is_still() const { return std::any_of(directions_.begin(), directions_.end(), is_zero_vector); }
  bool is_parallel() const {
    return !spanned_.empty() && std::any_of(directions_.begin(), directions_.end(), [&](const Rationals& v) {
      std::vector<Rationals> with = spanned_;
      with.push_back(v);
      return !is_zero_vector(v) && rank_of(with) == rank_of(spanned_);
    });
  }
  bool has_no_length() const {
    return std::any_of(lengths_.begin(), lengths_.end(), [](const Rational& x) { return sgn(x) == 0; });
  }
  bool is_far() const {
    return std::any_of(points_.begin(), points_.end(), [&](const Rationals& v) {
      return std::any_of(v.begin(), v.end(), [&](const Rational& x) {
        return sgn(x) != 0 && abs(x) >= Rational(far_from_origin) * extent_;
      });
    });
  }

 private:
  void include(const Rationals& v) {
    for (const Rational& x : v) extent_ = std::max(extent_, Rational(abs(x)));
  }

  std::vector<Rationals> points_, directions_, spanned_;
  Rationals lengths_;
  Rational extent_;
};

}  // namespace

template <class Real>
std::vector<std::string_view> classes_of(const Predicate& predicate, const Numbers<Real>& q, std::size_t entry) {
  if (const InputClasses* const own = capabilities_of(predicate).input_classes) return own->of(q);
  const QueryShape shape = shape_of(predicate.entries[entry]);
  const ExactParts parts(shape, q);
  std::vector<std::string_view> names;
  const auto add = [&](bool is_met, std::string_view name) {
    if (is_met) names.push_back(name);
  };
  if (const auto depth = oracles_of(predicate, entry).depth(q)) {
    add(*depth == 0, "tie");
    add(*depth <= near_tie_depth<Real>, "near_tie");
  }
  using Window = ScaleWindow<Real>;
  const Rational &extent = parts.extent(), least = exact(std::ldexp(1.0, Window::least_exponent)),
                 greatest = exact(std::ldexp(1.0, Window::greatest_exponent));
  add(sgn(extent) != 0 && (extent < least || extent > greatest), "scale");
  add(parts.has_equal_points(), "repeated");
  add(parts.is_collinear(), "collinear");
  add(parts.is_still(), "still");
  add(parts.is_parallel(), "parallel");
  add(parts.has_no_length(), "point");
  add(parts.is_far(), "far");
  add(std::any_of(shape.frames.begin(), shape.frames.end(),
                  [&](std::size_t first) { return !is_nearly_rotation(q, first); }),
      "sheared");
  add(names.empty(), "ordinary");
  return names;
}
template std::vector<std::string_view> classes_of(const Predicate&, const Numbers<float>&, std::size_t);
template std::vector<std::string_view> classes_of(const Predicate&, const Numbers<double>&, std::size_t);

}  // namespace axiscert
