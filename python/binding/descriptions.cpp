// Predicates, families, kernels, formats and levels, as their own descriptions have them.
#include <map>

#include "exact/numbers/number_format.h"
#include "exact/sphere_triangle/unbounded.h"
#include "exact/judge/oracles.h"
#include "fuzz/queries/family.h"
#include "kernel/base/version.h"
#include "kernel/kernel.h"
#include "python/binding/common.h"
#include "plans/predicate_options.h"

namespace axiscert::python {
namespace {

py::dict described(const PredicateEntry& entry) {
  py::list columns;
  for (const PredicateColumn& column : entry.columns) columns.append(py::str(std::string(column.name)));
  py::list groups;  // (name, first column, columns)
  for (const ColumnGroup& group : groups_of(entry))
    groups.append(py::make_tuple(std::string(group.name), group.first, group.size));
  py::dict made;
  made["name"] = std::string(entry.name);
  made["validity"] = std::string(entry.validity);
  made["columns"] = columns;
  made["groups"] = groups;
  return made;
}

py::dict described(const Predicate& predicate) {
  py::dict made;
  made["id"] = std::string(predicate.id);
  made["asks"] = std::string(predicate.asks);
  made["touching"] = std::string(predicate.touching);
  py::list entries, comparisons, measures;
  for (std::size_t entry = 0; entry < predicate.entries.size(); ++entry) {
    py::dict one = described(predicate.entries[entry]);
    const Oracles& oracles = oracles_of(predicate, entry);
    one["default_kernel"] = default_kernel(predicate, entry).id;
    const auto critical = oracles.critical_length();
    one["critical_column"] =
        critical ? py::object(py::str(std::string(predicate.entries[entry].columns[critical->column].name)))
                 : py::none();
    entries.append(one);
  }
  for (const PredicateComparison& comparison : predicate.comparisons)
    comparisons.append(py::str(std::string(comparison.name)));
  for (const PredicateMeasure& measure : predicate.measures) {
    py::dict one;
    one["name"] = std::string(measure.name);
    one["unit"] = std::string(measure.unit);
    one["kind"] = std::string(name(measure.kind));
    measures.append(one);
  }
  made["entries"] = entries;
  made["comparisons"] = comparisons;
  made["measures"] = measures;
  made["certified"] = std::string(predicate.certified);
  made["usual_formulae"] = std::string(predicate.usual_formulae);
  made["is_of_motions"] = is_of_motions(predicate);
  made["has_squared_distance"] = oracles_of(predicate).has_squared_distance();
  return made;
}

py::list described_families(const std::string& predicate) {
  py::list all;
  for (const Family* family : families()) {
    if (!predicate.empty() && family->predicate().id != predicate) continue;
    py::dict one;
    one["name"] = std::string(family->name);
    one["purpose"] = std::string(family->purpose);
    one["predicate"] = std::string(family->predicate().id);
    one["entry"] = std::string(family->predicate().entries[family->entry].name);
    one["version"] = family->version;
    one["exact_arithmetic"] = family->exact_arithmetic;
    one["is_scene"] = family->trust_group == TrustGroup::scene;
    all.append(one);
  }
  return all;
}

py::list described_kernels(const std::string& predicate) {
  py::list all;
  for (const Kernel& kernel : kernels()) {
    if (!predicate.empty() && kernel.predicate->id != predicate) continue;
    py::dict one;
    one["id"] = kernel.id;
    one["summary"] = kernel.summary;
    one["predicate"] = std::string(kernel.predicate->id);
    one["entry"] = std::string(kernel.predicate->entries[kernel.entry].name);
    one["formulae"] = kernel.formulae;
    one["exposes"] = std::string(name(kernel.exposes));
    all.append(one);
  }
  return all;
}

template <class Enum>
py::list all_names() {
  py::list names;
  for (const Enum each : enumerators<Enum>) names.append(py::str(std::string(name(each))));
  return names;
}

}  // namespace

void bind_descriptions(py::module_& m) {
  m.def("version", [] { return std::string(axiscert_version); });
  m.def("predicates", [] {
    py::list ids;
    for (const Predicate* predicate : predicates()) ids.append(py::str(std::string(predicate->id)));
    return ids;
  });
  m.def("predicate", [](const std::string& id) { return described(predicate_named(id)); });
  m.def("entry_of", [](const std::string& predicate, const std::string& entry) {
    const EntryOf of = entry_named(predicate, entry);
    return py::make_tuple(std::string(of.predicate->id), std::string(of.columns().name));
  });
  m.def("families", [](const std::string& predicate) {
    if (!predicate.empty()) find_predicate(predicate);
    return described_families(predicate);
  });
  m.def("kernels", [](const std::string& predicate) {
    if (!predicate.empty()) find_predicate(predicate);
    return described_kernels(predicate);
  });
  m.def("verdicts_of_bits", [](const std::string& predicate, const py::array_t<std::uint64_t>& bits) {
    py::array_t<std::uint8_t> verdicts(bits.size());
    const auto from = bits.unchecked<1>();
    auto to = verdicts.mutable_unchecked<1>();
    for (py::ssize_t i = 0; i < bits.size(); ++i)
      to(i) = static_cast<std::uint8_t>(verdict_of(predicate_named(predicate), from(i)));
    return verdicts;
  });
  m.def("number_formats", [] {
    py::dict formats;
    for (const NamedFormat& named : named_formats()) formats[py::str(named.format.name)] = std::string(named.about);
    return formats;
  });
  m.def("roundings", &all_names<RoundingRule>);
  m.def("contractions", &all_names<Contraction>);
}

}  // namespace axiscert::python
