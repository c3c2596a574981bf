// The exact answers, by the oracles: of arrays where filters decide most, and one by one where exact numbers are told.
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/judge/exact_facts.h"
#include "exact/judge/oracles.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "python/binding/common.h"
#include "python/binding/work.h"

namespace axiscert::python {
namespace {

struct Asked {
  EntryOf of;
  GivenColumns given;
  const Oracles& oracles;
  int threads;

  Asked(const std::string& predicate, const std::string& entry, const py::array& numbers, int threads_given)
      : of(entry_named(predicate, entry)),
        given(of, numbers),
        oracles(oracles_of(*of.predicate, of.entry)),
        threads(threads_given) {}
  // Calls each(i, numbers) for each query.
  template <class Each>
  void for_each(Each&& each) const {
    given.visit([&]<class Real>(const QueryColumns<Real>& columns) {
      for_each_block(columns.size, threads, [&](std::size_t first, std::size_t size) {
        for (std::size_t i = first; i < first + size; ++i) each(i, query_at(columns, i));
      });
    });
  }
  // The same, of valid queries.
  template <class Each>
  void for_each_valid(Each&& each) const {
    for_each([&](std::size_t i, const auto& numbers) {
      if (oracles.is_valid(numbers)) each(i, numbers);
    });
  }
};

// Calls each(i, truth, batch, place in it) for each query, by filters where the predicate has them.
template <class Each>
void for_each_truth(const Asked& asked, Each&& each) {
  const std::string target = resolve_target("auto");
  asked.given.visit([&]<class Real>(const QueryColumns<Real>& columns) {
    for_each_block(columns.size, asked.threads, [&](std::size_t first, std::size_t size) {
      const auto batches = batches_of<Real>(asked.oracles, target);
      QueryBatch<Real> block(size, columns.count);
      for (std::size_t i = 0; i < size; ++i) block.push_back(query_at(columns, first + i));
      batches->decide(block);
      for (std::size_t i = 0; i < size; ++i) {
        const std::optional<Truth> known = batches->known(i);
        each(first + i, known ? *known : asked.oracles.truth(block[i]), block[i], *batches, i);
      }
    });
  });
}

py::tuple verdicts(const std::string& predicate, const std::string& entry, const py::array& numbers, int threads) {
  const Asked asked(predicate, entry, numbers, threads);
  py::array_t<std::uint8_t> verdict(static_cast<py::ssize_t>(asked.given.size()));
  py::array_t<bool> touching(static_cast<py::ssize_t>(asked.given.size()));
  std::uint8_t* const v = verdict.mutable_data();
  bool* const t = touching.mutable_data();
  for_each_truth(asked, [=](std::size_t i, const Truth& truth, const auto&, const auto&, std::size_t) {
    v[i] = static_cast<std::uint8_t>(truth.verdict);
    t[i] = truth.touching;
  });
  return py::make_tuple(verdict, touching);
}

// The comparisons that hold by the formulae that a kernel claims, and those with equal sides, in exact arithmetic; 0 of
// what is no valid query.
py::tuple signs(const std::string& predicate, const std::string& entry, const py::array& numbers,
                const std::string& kernel_id, int threads) {
  const Asked asked(predicate, entry, numbers, threads);
  const Kernel& kernel = find_kernel(kernel_id);
  if (kernel.predicate != asked.of.predicate || kernel.entry != asked.of.entry || !has_comparisons(kernel)) {
    throw Error(fmt::format("kernel {}: it claims no formulae with comparisons of {}, entry {}", kernel.id,
                            asked.of.predicate->id, asked.of.columns().name));
  }
  py::array_t<std::uint64_t> holds(static_cast<py::ssize_t>(asked.given.size())),
      ties(static_cast<py::ssize_t>(asked.given.size()));
  std::uint64_t *const h = holds.mutable_data(), *const t = ties.mutable_data();
  for_each_truth(asked, [&](std::size_t i, const Truth& truth, const auto& q, const auto& batches, std::size_t place) {
    h[i] = t[i] = 0;
    if (truth.verdict == Verdict::invalid) return;
    const auto known = batches.known(place) ? batches.claimed(place, kernel) : std::nullopt;
    if (known) {
      h[i] = known->holds;
      t[i] = known->ties;
      return;
    }
    const std::unique_ptr<AskedQuery> about = asked.oracles.about(q);
    about->expect(kernel);
    if (const auto chain = about->chain(kernel)) {
      h[i] = chain->exact.bits.value_or(0);
      t[i] = chain->ties;
    }
  });
  return py::make_tuple(holds, ties);
}

py::array depths(const std::string& predicate, const std::string& entry, const py::array& numbers, int threads) {
  const Asked asked(predicate, entry, numbers, threads);
  if (!asked.oracles.has_depth()) throw Error(fmt::format("the predicate {} has no depth", asked.of.predicate->id));
  py::array_t<double> depth(static_cast<py::ssize_t>(asked.given.size()));
  double* const d = depth.mutable_data();
  std::fill_n(d, asked.given.size(), std::numeric_limits<double>::quiet_NaN());
  asked.for_each_valid([&](std::size_t i, const auto& q) {
    if (const auto found = asked.oracles.depth(q)) d[i] = *found;
  });
  return depth;
}

// One rational a query, or None.
py::list in_python(const std::vector<std::optional<Rational>>& values) {
  py::list made;
  for (const auto& value : values) made.append(value ? py::object(fraction(*value)) : py::none());
  return made;
}

py::list squared_distances(const std::string& predicate, const std::string& entry, const py::array& numbers,
                           int threads) {
  const Asked asked(predicate, entry, numbers, threads);
  std::vector<std::optional<Rational>> found(asked.given.size());
  asked.for_each_valid(
      [&](std::size_t i, const auto& q) { found[i] = asked.oracles.about(q, Opinion::first)->squared_distance(); });
  return in_python(found);
}

py::list squared_critical_values(const std::string& predicate, const std::string& entry, const py::array& numbers,
                                 int threads) {
  const Asked asked(predicate, entry, numbers, threads);
  const auto critical = asked.oracles.critical_length();
  if (!critical) {
    throw Error(fmt::format("the answer of {}, entry {}, depends on no length that has a critical value",
                            asked.of.predicate->id, asked.of.columns().name));
  }
  std::vector<std::optional<Rational>> found(asked.given.size());
  asked.for_each([&](std::size_t i, const auto& q) {
    for (const auto x : q) {
      if (!std::isfinite(x)) return;
    }
    Numbers<double> wide(q.size());
    std::copy(q.begin(), q.end(), wide.begin());
    found[i] = critical->squared(wide);
  });
  return in_python(found);
}

// As (kind, the rationals of which it is made, the nearest decimal of 17 digits, the text).
py::tuple exact_number(const ExactValue& value) {
  const py::tuple parts = std::visit(
      []<class Value>(const Value& x) -> py::tuple {
        if constexpr (std::is_same_v<Value, RootNumber>)
          return py::make_tuple("root", fraction(x.rest), fraction(x.square), x.sign);
        else return py::make_tuple("depth", fraction(x.dd), fraction(x.r), fraction(x.ss));
      },
      value);
  return py::make_tuple(parts, decimal_text(value, std::numeric_limits<double>::max_digits10), exact_text(value));
}

py::object in_python(const Detail& detail) {
  return std::visit(
      []<class Value>(const Value& value) -> py::object {
        if constexpr (std::is_same_v<Value, std::monostate>) return py::none();
        else if constexpr (std::is_same_v<Value, double>) return py::float_(value);
        else if constexpr (std::is_same_v<Value, std::string_view>) return py::str(std::string(value));
        else {
          py::list names;
          for (const std::string_view name : value) names.append(py::str(std::string(name)));
          return names;
        }
      },
      detail.value);
}

// A dictionary for each query, or None where it is not valid: what there is to tell, by its name.
py::list facts(const std::string& predicate, const std::string& entry, const py::array& numbers, int threads) {
  const Asked asked(predicate, entry, numbers, threads);
  const Capabilities& capabilities = capabilities_of(*asked.of.predicate);
  struct Told {
    bool is_valid = false;
    std::vector<Detail> details;
    std::vector<ExactFact> facts;
    std::vector<std::string_view> features;
  };
  std::vector<Told> told(asked.given.size());
  asked.for_each_valid([&](std::size_t i, const auto& q) {
    Told& here = told[i];
    here.is_valid = true;
    here.details = asked.oracles.details(q);
    if (capabilities.nearest_features != nullptr) here.features = capabilities.nearest_features->of(q);
    if (capabilities.exact_facts == nullptr) return;
    Numbers<double> wide(q.size());
    std::copy(q.begin(), q.end(), wide.begin());
    here.facts = capabilities.exact_facts(wide, asked.of.entry);
  });
  py::list made;
  for (const Told& here : told) {
    if (!here.is_valid) {
      made.append(py::none());
      continue;
    }
    py::dict one;
    for (const Detail& detail : here.details) one[py::str(std::string(detail.name))] = in_python(detail);
    if (capabilities.nearest_features != nullptr)
      one["features"] = std::vector<std::string>(here.features.begin(), here.features.end());
    for (const ExactFact& fact : here.facts) {
      py::list exact, names;
      for (const ExactValue& value : fact.numbers) exact.append(exact_number(value));
      for (const std::string_view name : fact.names) names.append(py::str(std::string(name)));
      one[py::str(std::string(fact.name))] =
          py::make_tuple(exact, names, std::string(fact.unit), std::string(fact.note));
    }
    made.append(one);
  }
  return made;
}

}  // namespace

void bind_truth(py::module_& m) {
  m.def("verdicts", &verdicts);
  m.def("signs", &signs);
  m.def("depths", &depths);
  m.def("squared_distances", &squared_distances);
  m.def("squared_critical_values", &squared_critical_values);
  m.def("facts", &facts);
}

}  // namespace axiscert::python
