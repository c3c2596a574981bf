// Evaluation of a mutant: the formulae over numbers of which one is computed wrongly, the comparisons, and the faults
// that concern whole batches.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "kernel/base/environment.h"
#include "kernel/mutants/forms.h"
#include "kernel/mutants/mutant.h"
#include "kernel/mutants/planted_value.h"

namespace axiscert::mutants {
namespace {

constexpr double epsilon = 1e-6, small_area = 1e-10;  // values found in kernels in use
constexpr std::size_t vector_width = 8;               // vectors of the lane faults

template <class Real>
using Number = MutatedNumber<Lanes<Real>>;

template <class Real>
struct Evaluation {
  std::array<ComparisonBits, Lanes<Real>::width> bits{};
  Lanes<Real> kept{};
  std::array<bool, Lanes<Real>::width> is_early{};  // answered before a comparison is made
};

template <class Real>
bool holds_wrongly(ComparisonFault fault, bool is_strict, Real lhs, Real rhs) {
  switch (fault) {
    case ComparisonFault::strictness:
      return is_strict ? lhs >= rhs : lhs > rhs;
    case ComparisonFault::reverse:
      std::swap(lhs, rhs);
      break;
    case ComparisonFault::always:
      return true;
    case ComparisonFault::epsilon:
      rhs += static_cast<Real>(epsilon);
      break;
    case ComparisonFault::slack:
      lhs += static_cast<Real>(epsilon);
      break;
    case ComparisonFault::flush:
      if (std::fabs(lhs) < std::numeric_limits<Real>::min()) lhs = 0;
      if (std::fabs(rhs) < std::numeric_limits<Real>::min()) rhs = 0;
      break;
    case ComparisonFault::none:
      break;
  }
  return is_strict ? lhs > rhs : lhs >= rhs;
}

// Evaluates Lanes::width queries from `first` on; beyond the end of the batch the last query is repeated.
template <class Form, class Real>
[[gnu::noinline]] Evaluation<Real> evaluate(const Mutant& mutant, const QueryColumns<Real>& batch, std::size_t first) {
  using N = Number<Real>;
  constexpr std::size_t radius = Form::columns - 1;
  std::array<N, Form::columns> in;
  const auto number = [&](std::size_t i, std::size_t k) {
    return batch.column[k][std::min(first + i, batch.size - 1)];
  };
  for (std::size_t k = 0; k < in.size(); ++k) {
    in[k] = {Lanes<Real>::of([&](std::size_t i) { return number(i, k); }), input_key(k)};
  }
  std::optional<PlantedValue<Real>> value;
  if (mutant.value != ValueFault::none) value.emplace(mutant, number);
  if (value && mutant.quantity == Quantity::radius) in[radius].value = value->replaced(in[radius].value);
  auto& site = N::plant(mutant.operation, in);
  if (value) site.replaced = [&](const Lanes<Real>& x) { return value->replaced(x); };
  Evaluation<Real> result;
  Form::comparisons(in, N(0.0), [&](std::size_t place, const N& lhs, const N& rhs) {
    const bool is_strict = !has_bit(Form::nonstrict, place);
    const ComparisonFault fault = place == mutant.place ? mutant.comparison : ComparisonFault::none;
    for (std::size_t i = 0; i < Lanes<Real>::width; ++i) {
      Real l = lhs.value.at[i];
      const Real r = rhs.value.at[i];
      if (value) [[unlikely]]
        l = value->left(place, i, l, r);
      bool holds = is_strict ? l > r : l >= r;
      if (fault != ComparisonFault::none) [[unlikely]]
        holds = holds_wrongly(fault, is_strict, l, r);
      result.bits[i] |= static_cast<ComparisonBits>(holds) << place;
    }
  });
  result.kept = site.kept_value;
  site.replaced = nullptr;  // it refers to this call
  if (value) result.is_early = value->is_early;
  return result;
}

template <class Real>
void answer_early(const Predicate& predicate, const Mutant& mutant, Evaluation<Real>& found) {
  const bool separated = mutant.value != ValueFault::none ? mutant.value == ValueFault::early_separated
                                                          : static_cast<Verdict>(mutant.place) == Verdict::separated;
  const ComparisonBits all = separated ? predicate.clauses.front().comparisons : ComparisonBits{0};
  for (std::size_t i = 0; i < found.bits.size(); ++i) {
    const bool is_small = mutant.kernel == KernelFault::small_area && found.kept.at[i] < static_cast<Real>(small_area);
    if (is_small || found.is_early[i]) found.bits[i] = all;
  }
}

void mix_up_lanes(const Mutant& mutant, std::size_t size, ComparisonBits* out) {
  if (mutant.kernel == KernelFault::lane) {
    for (std::size_t first = 0; first + vector_width <= size; first += vector_width) {
      out[first + mutant.place] = out[first + (mutant.place + vector_width - 1) % vector_width];
    }
  } else {
    const std::size_t width = mutant.place, whole = size - size % width;
    for (std::size_t i = whole; i < size; ++i) out[i] = whole == 0 ? ComparisonBits{0} : out[i - width];
  }
}

template <class Form, class Real>
void bits(const Mutant& mutant, const QueryColumns<Real>& batch, ComparisonBits* out) {
  for (std::size_t first = 0; first < batch.size; first += Lanes<Real>::width) {
    std::optional<FloatingEnvironment> environment;
    if (mutant.kernel == KernelFault::ftz) environment.emplace(Rounding::nearest, true);
    Evaluation<Real> found = evaluate<Form>(mutant, batch, first);
    if (mutant.kernel == KernelFault::small_area || answers_early(mutant.value))
      answer_early(Form::predicate(), mutant, found);
    for (std::size_t i = 0; i < Lanes<Real>::width && first + i < batch.size; ++i) {
      ComparisonBits here = found.bits[i];
      if (mutant.kernel == KernelFault::drop) {
        here &= ~Form::predicate().clauses[mutant.place].comparisons;
      }
      out[first + i] = here;
    }
  }
  if (mutant.kernel == KernelFault::lane || mutant.kernel == KernelFault::tail) mix_up_lanes(mutant, batch.size, out);
}

template <class Real>
Implementation<Real> implementation_of(const Mutant& mutant) {
  return {
      [&mutant](const QueryColumns<Real>& batch, Verdict* out) {
        std::vector<ComparisonBits> bits(batch.size);
        mutant_bits(mutant, batch, bits.data());
        const Predicate& predicate = predicate_of(base_of(mutant));
        for (std::size_t i = 0; i < batch.size; ++i) out[i] = verdict_of(predicate, bits[i]);
      },
      [&mutant](const QueryColumns<Real>& batch, Answers<Real>& out) { mutant_bits(mutant, batch, out.bits.data()); }};
}

}  // namespace

template <class Real>
void mutant_bits(const Mutant& mutant, const QueryColumns<Real>& batch, ComparisonBits* out) {
  with_form(base_of(mutant), [&](auto form) { bits<decltype(form)>(mutant, batch, out); });
}
template void mutant_bits<float>(const Mutant&, const QueryColumns<float>&, ComparisonBits*);
template void mutant_bits<double>(const Mutant&, const QueryColumns<double>&, ComparisonBits*);

Kernel kernel_of(const Mutant& mutant) {
  Kernel kernel;
  kernel.id = mutant.id;
  kernel.summary = fmt::format("one fault: {}, at {}", mutant.what, mutant.where);
  with_form(base_of(mutant), [&]<class Form>(Form) {
    kernel.predicate = &Form::predicate();
    kernel.formulae = Form::formulae();
  });
  kernel.strictness = Strictness::nonstrict;
  kernel.exposes = Exposure::comparisons;
  if (mutant.in_binary32) kernel.binary32 = [&mutant](std::string_view) { return implementation_of<float>(mutant); };
  kernel.binary64 = [&mutant](std::string_view) { return implementation_of<double>(mutant); };
  return kernel;
}

Kernel black_box_of(const Mutant& mutant) {
  Kernel kernel = kernel_of(mutant);
  kernel.formulae.clear();
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  return kernel;
}

}  // namespace axiscert::mutants
