#include "exact/sphere_triangle/degree.h"

#include "kernel/sphere_triangle/forms/formulae_types.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace axiscert {
namespace {

// The branches of an evaluation, each taken both ways in turn: the answers to comparisons of two Degrees.
class Branches {
 public:
  bool take() {
    if (next_ == taken_.size()) taken_.push_back(false);
    return taken_[next_++];
  }
  // Moves on to the next path through the branches; false after the last.
  bool advance() {
    next_ = 0;
    while (!taken_.empty() && taken_.back()) taken_.pop_back();
    if (taken_.empty()) return false;
    taken_.back() = true;
    return true;
  }

 private:
  std::vector<bool> taken_;
  std::size_t next_ = 0;
};
thread_local Branches branches;

// A value of the formulae, represented by its degree and by a bound on its bits.
//   sum       both operands of one degree; one bit more than the longer
//   product   degrees and bits add
//   quotient  degrees subtract, a root halves; neither is an integer any more
class Degree {
 public:
  static Degree input() { return Degree(2, BitLength{1, 0}); }
  static Degree zero() { return Degree(); }

  std::optional<double> degree() const { return zero_ ? std::nullopt : std::optional(halves_ / 2.0); }
  bool has_bits() const { return zero_ || bits_; }
  BitLength bits() const { return zero_ ? BitLength{0, 0} : *bits_; }

  friend Degree operator+(const Degree& a, const Degree& b) { return sum(a, b); }
  friend Degree operator-(const Degree& a, const Degree& b) { return sum(a, b); }
  friend Degree operator*(const Degree& a, const Degree& b) {
    if (a.zero_ || b.zero_) return zero();
    Degree result(a.halves_ + b.halves_, std::nullopt);
    if (a.bits_ && b.bits_) {
      result.bits_ = BitLength{a.bits_->per_bit + b.bits_->per_bit, a.bits_->constant + b.bits_->constant};
    }
    return result;
  }
  friend Degree operator/(const Degree& a, const Degree& b) {
    return a.zero_ ? zero() : Degree(a.halves_ - b.halves_, std::nullopt);
  }
  friend Degree square_root(const Degree& a) {
    if (a.halves_ % 2 != 0) throw std::logic_error("Degree: the root of an odd half-degree");
    return a.zero_ ? zero() : Degree(a.halves_ / 2, std::nullopt);
  }
  friend Degree magnitude(const Degree& a) { return a; }
  friend bool operator>(const Degree&, const Degree&) { return branches.take(); }

 private:
  Degree() = default;
  Degree(int halves, std::optional<BitLength> bits) : zero_(false), halves_(halves), bits_(bits) {}

  static Degree sum(const Degree& a, const Degree& b) {
    if (a.zero_ || b.zero_) return a.zero_ ? b : a;
    if (a.halves_ != b.halves_) throw std::logic_error("Degree: a sum of two different degrees");
    Degree result(a.halves_, std::nullopt);
    if (a.bits_ && b.bits_) {
      result.bits_ =
          BitLength{std::max(a.bits_->per_bit, b.bits_->per_bit), std::max(a.bits_->constant, b.bits_->constant) + 1};
    }
    return result;
  }

  bool zero_ = true;  // the constant 0, which has every degree
  int halves_ = 0;    // twice the degree
  std::optional<BitLength> bits_;
};

struct FoundDegree {
  ComparisonDegree degree{std::nullopt, std::nullopt, BitLength{0, 0}};

  void include(const Degree& lhs, const Degree& rhs) {
    degree.lhs = std::max(degree.lhs, lhs.degree());  // an empty optional is less than any other
    degree.rhs = std::max(degree.rhs, rhs.degree());
    for (const Degree& side : {lhs, rhs}) {
      if (!degree.bits || !side.has_bits()) degree.bits.reset();
      else
        degree.bits = BitLength{std::max(degree.bits->per_bit, side.bits().per_bit),
                                std::max(degree.bits->constant, side.bits().constant)};
    }
  }
};

template <class F>
std::optional<ComparisonDegrees> found_degrees() {
  const Degree x = Degree::input();
  const portable::Vec3<Degree> point{x, x, x};
  const portable::Problem<Degree> problem{point, point, point, point, x, Degree::zero()};
  if constexpr (requires { F::separated(problem); }) {
    return std::nullopt;
  } else {
    EnumArray<Comparison, FoundDegree> found;
    branches = Branches();
    do {
      F::comparisons(problem,
                     [&](Comparison which, const Degree& lhs, const Degree& rhs) { found[which].include(lhs, rhs); });
    } while (branches.advance());
    ComparisonDegrees degrees;
    std::transform(found.begin(), found.end(), degrees.begin(), [](const FoundDegree& f) { return f.degree; });
    return degrees;
  }
}

}  // namespace

std::optional<ComparisonDegrees> degrees_of(Formulae formulae) {
  switch (formulae) {
#define AXISCERT_CASE(name, type, kind) \
  case Formulae::name:                  \
    return found_degrees<type>();
    AXISCERT_FORMULAE(AXISCERT_CASE)
#undef AXISCERT_CASE
    case Formulae::none:
      break;
  }
  return std::nullopt;
}

}  // namespace axiscert
