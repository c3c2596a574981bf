// The formulae of a built-in kernel in any format, and the certified predicate: of spheres and triangles.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "exact/numbers/number_format.h"
#include "exact/sphere_triangle/unbounded.h"
#include "exact/judge/oracles.h"
#include "kernel/base/error.h"
#include "kernel/base/split_mix.h"
#include "kernel/formulae_list.h"
#include "kernel/ask.h"
#include "python/binding/common.h"
#include "python/binding/work.h"
#include "plans/formula_figures.h"
#include "plans/predicate_options.h"

namespace axiscert::python {
namespace {

template <class Value>
Value* data_of(py::array_t<Value>& array) {
  return array.mutable_data();
}

// What a built-in kernel computes in the precision of the queries: (verdict, bits, lhs, rhs); sides of shape
// (comparisons, n), and None where it does not show them.
py::tuple computed(const std::string& predicate, const std::string& entry, const py::array& numbers,
                   const std::string& kernel_id, const std::string& target, int threads) {
  const EntryOf of = entry_named(predicate, entry);
  const GivenColumns given(of, numbers);
  const Kernel& kernel = find_kernel(kernel_id);
  if (kernel.predicate != of.predicate || kernel.entry != of.entry) {
    throw Error(fmt::format("kernel {}: it is of {}, entry {}, and the queries are of {}, entry {}", kernel.id,
                            kernel.predicate->id, kernel.predicate->entries[kernel.entry].name, of.predicate->id,
                            of.columns().name));
  }
  if (!kernel.has(given.precision()))
    throw Error(fmt::format("kernel {}: it does not exist in {}", kernel.id, name(given.precision())));
  const std::string on = resolve_target(target);
  return given.visit([&]<class Real>(const QueryColumns<Real>& columns) -> py::tuple {
    const std::size_t comparisons = of.predicate->comparisons.size(), size = columns.size;
    py::array_t<std::uint8_t> verdict(static_cast<py::ssize_t>(size));
    py::array_t<std::uint64_t> bits(static_cast<py::ssize_t>(size));
    py::array_t<Real> lhs({comparisons, size}), rhs({comparisons, size});
    std::uint8_t* const v = data_of(verdict);
    std::uint64_t* const b = data_of(bits);
    Real *const l = data_of(lhs), *const r = data_of(rhs);
    for_each_block(size, threads, [&](std::size_t first, std::size_t count) {
      const Implementation<Real> asked = kernel.on<Real>(on);
      QueryColumns<Real> part = columns;
      part.size = count;
      for (std::size_t k = 0; k < columns.count; ++k) part.column[k] += first;
      Reply<Real> reply;
      ask(asked, part, reply);
      for (std::size_t i = 0; i < count; ++i) v[first + i] = static_cast<std::uint8_t>(reply.verdicts[i]);
      if (!reply.has_bits) return;
      std::copy_n(reply.answers.bits.begin(), count, b + first);
      for (std::size_t k = 0; k < comparisons; ++k) {
        std::copy_n(reply.answers.lhs[k].begin(), count, l + k * size + first);
        std::copy_n(reply.answers.rhs[k].begin(), count, r + k * size + first);
      }
    });
    const py::object none = py::none();
    const bool shows_bits = kernel.exposes != Exposure::verdict, shows_sides = kernel.exposes == Exposure::sides;
    return py::make_tuple(verdict, shows_bits ? py::object(bits) : none, shows_sides ? py::object(lhs) : none,
                          shows_sides ? py::object(rhs) : none);
  });
}

// The formulae of a kernel in a format: (verdict, bits), with the format's exponents and with unlimited ones; whether
// the numbers of the query are numbers of the format, where they are rounded to it first; and both sides with the
// format's exponents, shape (comparisons, n), float64, NaN of what is no valid query, or None of formulae without
// comparisons.
py::tuple in_format(const std::string& predicate, const std::string& entry, const py::array& numbers,
                    const std::string& kernel_id, const std::string& format_name, const std::string& rounding,
                    const std::string& contraction, std::uint64_t seed, bool rounds_inputs, int threads) {
  const EntryOf of = entry_named(predicate, entry);
  const GivenColumns given(of, numbers);
  const Kernel& kernel = find_kernel(kernel_id);
  require_capability(has_formulae, "formulae in a format", *of.predicate, of.entry);
  const Formulae formulae = formulae_of(kernel);
  if (kernel.predicate != of.predicate || formulae == Formulae::none)
    throw Error(fmt::format("kernel {}: it has no formulae of {}", kernel.id, of.predicate->id));
  const NumberFormat number = parse_number_format(format_name);
  const RoundingRule rule = enumerator_of<RoundingRule>("rounding=", rounding);
  const Contraction fused = enumerator_of<Contraction>("fused=", contraction);
  if (!has_contraction(formulae, fused))
    throw Error(fmt::format("kernel {}: its formulae have no form with fused {}", kernel.id, contraction));
  return given.visit([&]<class Real>(const QueryColumns<Real>& columns) -> py::tuple {
    const auto size = static_cast<py::ssize_t>(columns.size);
    py::array_t<std::uint8_t> verdict(size), unlimited_verdict(size);
    py::array_t<std::uint64_t> bits(size), unlimited_bits(size);
    py::array_t<bool> held(size);
    std::uint8_t *const v = data_of(verdict), *const uv = data_of(unlimited_verdict);
    std::uint64_t *const b = data_of(bits), *const ub = data_of(unlimited_bits);
    bool* const h = data_of(held);
    const std::size_t comparisons = has_comparisons(formulae) ? of.predicate->comparisons.size() : 0;
    py::array_t<double> lhs({comparisons, columns.size}), rhs({comparisons, columns.size});
    double *const l = data_of(lhs), *const r = data_of(rhs);
    for (double* const side : {l, r})
      std::fill_n(side, comparisons * columns.size, std::numeric_limits<double>::quiet_NaN());
    const ExponentLimits own = given.precision();
    const Oracles& oracles = oracles_of(kernel);
    for_each_block(columns.size, threads, [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) {
        b[i] = ub[i] = 0;
        v[i] = uv[i] = static_cast<std::uint8_t>(Verdict::invalid);
        h[i] = false;
        const Numbers<Real> q = query_at(columns, i);
        if (!oracles.is_valid(q)) continue;
        std::optional<Query<Real>> asked = static_cast<Query<Real>>(q);
        if (rounds_inputs) asked = rounded_to(*asked, floating(number, RoundingRule::nearest, own));
        if (!asked) continue;
        h[i] = true;
        const FloatingFormat format =
            floating(number, rule, own, is_by_chance(rule) ? mixed(seed + golden_gamma * (i + 1)) : 0);
        const BothRanges found = in_both_ranges(formulae, kernel.strictness, *asked, format, fused);
        v[i] = static_cast<std::uint8_t>(found.limited.verdict);
        uv[i] = static_cast<std::uint8_t>(found.unlimited.verdict);
        b[i] = found.limited.bits.value_or(0);
        ub[i] = found.unlimited.bits.value_or(0);
        const auto sides = sides_in_format(formulae, *asked, format, fused);
        for (std::size_t k = 0; sides && k < comparisons; ++k) {
          l[k * columns.size + i] = sides->lhs[k];
          r[k * columns.size + i] = sides->rhs[k];
        }
      }
    });
    const auto shown = [&](const py::array& sides) { return comparisons == 0 ? py::none() : py::object(sides); };
    return py::make_tuple(verdict, bits, unlimited_verdict, unlimited_bits, held, shown(lhs), shown(rhs));
  });
}

}  // namespace

void bind_formulae(py::module_& m) {
  m.def("computed", &computed);
  m.def("in_format", &in_format);
}

}  // namespace axiscert::python
