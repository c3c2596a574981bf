// The symbolic recorder: kernel/sphere_triangle/formulae.h over a number type that records its operations.
#include <stdexcept>

#include "proofs/program.h"
#include "kernel/base/number.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/reduced.h"

namespace axiscert::proofs {
namespace {

// The program being recorded on this thread; a number type has no other place to keep it.
thread_local Program* recorder = nullptr;

struct RecordedNumber {
  std::size_t step = 0;
  friend RecordedNumber operator-(const RecordedNumber& a) { return {recorder->step(Operation::negate, {a.step})}; }
  friend RecordedNumber operator+(const RecordedNumber& a, const RecordedNumber& b) { return of(Operation::add, a, b); }
  friend RecordedNumber operator-(const RecordedNumber& a, const RecordedNumber& b) {
    return of(Operation::subtract, a, b);
  }
  friend RecordedNumber operator*(const RecordedNumber& a, const RecordedNumber& b) {
    return of(Operation::multiply, a, b);
  }
  friend RecordedNumber fused(const RecordedNumber& a, const RecordedNumber& b, const RecordedNumber& c) {
    return {recorder->step(Operation::fused, {a.step, b.step, c.step})};
  }

 private:
  static RecordedNumber of(Operation operation, const RecordedNumber& a, const RecordedNumber& b) {
    return {recorder->step(operation, {a.step, b.step})};
  }
};
using FusedRecordedNumber = arithmetic::FusedNumber<RecordedNumber>;

std::size_t step_of(const RecordedNumber& x) { return x.step; }
std::size_t step_of(const FusedRecordedNumber& x) { return x.value.step; }

template <class T>
void name_vector(const std::string& name, const portable::Vec3<T>& v) {
  recorder->name(step_of(v.x), name + "_x");
  recorder->name(step_of(v.y), name + "_y");
  recorder->name(step_of(v.z), name + "_z");
}
template <class T>
void name_scalar(const std::string& name, const T& x) {
  recorder->name(step_of(x), name);
}

// Gives the article's names to the steps that compute its quantities. A quantity that a program does not compute
// becomes a step that no result needs.
template <class T>
void name_quantities(const portable::Problem<T>& query) {
  using portable::dot, portable::cross;
  const auto [A, B, C, rr] = portable::centred(query);
  name_vector("a", A);
  name_vector("b", B);
  name_vector("c", C);
  name_scalar("rr", rr);
  const auto AB = B - A, BC = C - B, CA = A - C, AC = C - A;
  name_vector("AB", AB);
  name_vector("BC", BC);
  name_vector("CA", CA);
  name_vector("AC", AC);
  const auto V = cross(AB, AC);
  name_vector("V", V);
  name_scalar("d", dot(A, V));
  name_scalar("e", dot(V, V));
  const auto [aa, ab, ac, bb, bc, cc] = portable::dot_products(portable::CentredProblem<T>{A, B, C, rr});
  name_scalar("aa", aa);
  name_scalar("ab", ab);
  name_scalar("ac", ac);
  name_scalar("bb", bb);
  name_scalar("bc", bc);
  name_scalar("cc", cc);
  const auto edge = [&](const std::string& number, const std::string& third, const auto& from, const auto& to,
                        const auto& opposite, const auto& along, const T& across, const T& square) {
    const T d = across - square, e = dot(along, along);
    name_scalar("d" + number, d);
    name_scalar("e" + number, e);
    const auto Q = from * e - along * d;
    name_vector("Q" + number, Q);
    name_vector("Q" + third, opposite * e - Q);
    name_vector("N" + number, cross(from, to));
  };
  edge("1", "C", A, B, C, AB, ab, aa);
  edge("2", "A", B, C, A, BC, bc, bb);
  edge("3", "B", C, A, B, CA, ac, cc);
}

template <class F, class T>
Recording recording(Form form, Contraction contraction) {
  Recording result{form, contraction, {}, {}, {}};
  recorder = &result.program;
  std::array<T, input_names.size()> in;
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = T(RecordedNumber{recorder->input(std::string(input_names[i]))});
  const T zero(RecordedNumber{recorder->step(Operation::zero)});
  const portable::Problem<T> problem{
      {in[0], in[1], in[2]}, {in[3], in[4], in[5]}, {in[6], in[7], in[8]}, {in[9], in[10], in[11]}, in[12], zero};
  const Sides<T> sides = sides_of<F>(problem);
  name_quantities(problem);
  for (std::size_t k = 0; k < comparison_count; ++k) {
    result.lhs[k] = step_of(sides.lhs[k]);
    result.rhs[k] = step_of(sides.rhs[k]);
  }
  recorder = nullptr;
  return result;
}

template <class F>
Recording recording_of(Form form, Contraction contraction) {
  switch (contraction) {
    case Contraction::plain:
      return recording<F, RecordedNumber>(form, contraction);
    case Contraction::fma:
      return recording<F, FusedRecordedNumber>(form, contraction);
  }
  throw std::logic_error("record: no such contraction");
}

}  // namespace

Recording record(Form form, Contraction contraction) {
  switch (form) {
    case Form::published:
      return recording_of<portable::PublishedFormulae>(form, contraction);
    case Form::reduced:
      return recording_of<portable::ReducedFormulae>(form, contraction);
  }
  throw std::logic_error("record: no such form");
}

}  // namespace axiscert::proofs
