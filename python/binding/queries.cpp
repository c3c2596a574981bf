// Queries as arrays: of families, meshes, files and addresses.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "fuzz/files/corpus.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "plans/given_queries.h"
#include "python/binding/common.h"
#include "python/binding/work.h"

namespace axiscert::python {
namespace {

template <class Real>
py::array fill(const Source& source, std::uint64_t seed, std::uint64_t first, std::size_t count, int threads) {
  const std::size_t columns = source.columns().size();
  py::array_t<Real> numbers({columns, count});
  Real* const to = numbers.mutable_data();
  for_each_block(count, threads, [&](std::size_t begin, std::size_t size) {
    QueryBatch<Real> block(size, columns);
    source.fill(seed, first + begin, size, block);
    const QueryColumns<Real> made = block.columns();
    for (std::size_t k = 0; k < columns; ++k) std::copy_n(made.column[k], size, to + k * count + begin);
  });
  return numbers;
}

py::array queries_of(const Source& source, const std::string& precision, std::uint64_t seed, std::uint64_t first,
                     std::size_t count, int threads) {
  const Precision of = parse_precision(precision);
  if (const auto fixed = source.fixed_size(of); fixed && (first > *fixed || count > *fixed - first)) {
    throw Error(fmt::format("{}: it has {} queries in {}, and {} from number {} on are asked for", source.name(),
                            *fixed, precision, count, first));
  }
  if (of == Precision::binary32) return fill<float>(source, seed, first, count, threads);
  return fill<double>(source, seed, first, count, threads);
}

template <class Real>
py::array numbers_of(const std::vector<const StoredQuery*>& queries, std::size_t columns) {
  py::array_t<Real> numbers({columns, queries.size()});
  auto to = numbers.template mutable_unchecked<2>();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto& q = std::get<Numbers<Real>>(queries[i]->numbers);
    for (std::size_t k = 0; k < columns; ++k) to(static_cast<py::ssize_t>(k), static_cast<py::ssize_t>(i)) = q[k];
  }
  return numbers;
}

// Queries of a file that are of one predicate, entry and precision, as (predicate, entry, numbers, ids, addresses).
py::tuple part(const std::vector<const StoredQuery*>& queries) {
  const StoredQuery& first = *queries.front();
  const std::size_t columns = first.columns().columns.size();
  py::list ids, addresses;
  for (const StoredQuery* query : queries) {
    ids.append(py::str(query->id));
    addresses.append(py::str(query->address));
  }
  py::array numbers = first.precision == Precision::binary32 ? numbers_of<float>(queries, columns)
                                                             : numbers_of<double>(queries, columns);
  return py::make_tuple(std::string(first.predicate->id), std::string(first.columns().name), numbers, ids, addresses);
}

// In the order in which the parts first occur.
py::list parts_of(const std::vector<StoredQuery>& stored) {
  std::vector<std::vector<const StoredQuery*>> parts;
  for (const StoredQuery& query : stored) {
    const auto same = std::ranges::find_if(parts, [&](const auto& others) {
      const StoredQuery& other = *others.front();
      return std::tie(other.predicate, other.entry, other.precision) ==
             std::tie(query.predicate, query.entry, query.precision);
    });
    if (same == parts.end()) parts.push_back({&query});
    else same->push_back(&query);
  }
  py::list made;
  for (const auto& queries : parts) made.append(part(queries));
  return made;
}

template <class Work>
auto without_lock(Work&& work) {
  const Unlocked unlocked;
  return work();
}

std::string lines_of(const std::string& predicate, const std::string& entry, const py::array& numbers,
                     const std::vector<std::string>& ids) {
  const EntryOf of = entry_named(predicate, entry);
  const GivenColumns given(of, numbers);
  const Unlocked unlocked;
  return given.visit([&]<class Real>(const QueryColumns<Real>& columns) {
    std::string text;
    for (std::size_t i = 0; i < columns.size; ++i) {
      const std::string id = i < ids.size() ? ids[i] : fmt::format("{}", i);
      text += query_line({id, precision_of<Real>, query_at(columns, i), of.predicate, of.entry}) + "\n";
    }
    return text;
  });
}

}  // namespace

void bind_queries(py::module_& m) {
  py::class_<Source, std::shared_ptr<Source>>(m, "Source")
      .def_property_readonly("name", &Source::name)
      .def_property_readonly("purpose", &Source::purpose)
      .def_property_readonly("predicate", [](const Source& s) { return std::string(s.predicate().id); })
      .def_property_readonly("entry",
                             [](const Source& s) { return std::string(s.predicate().entries[s.entry()].name); })
      .def("fixed_size",
           [](const Source& s, const std::string& precision) { return s.fixed_size(parse_precision(precision)); })
      .def("queries", &queries_of)
      .def("addresses", [](const Source& s, const std::string& precision, std::uint64_t seed,
                           const std::vector<std::uint64_t>& positions) {
        const Unlocked unlocked;
        const SeededSource seeded{s, seed, parse_precision(precision)};
        std::vector<std::string> texts;
        for (const std::uint64_t position : positions) texts.push_back(seeded.address(position));
        return texts;
      });
  const auto shared = [](const SourcePtr& source) { return std::const_pointer_cast<Source>(source); };
  m.def("family_source", [=](const std::string& name) { return shared(family_source(find_family(name))); });
  m.def("mesh_source", [=](const std::string& path, const std::string& predicate) {
    const Unlocked unlocked;
    return shared(mesh_source(path, predicate_named(predicate)));
  });
  m.def("corpus_source", [=](const std::string& folder, const std::string& predicate, const std::string& entry) {
    const Unlocked unlocked;
    const EntryOf of = entry_named(predicate, entry);
    return shared(corpus_source(folder.empty() ? default_corpus_folder() : folder, *of.predicate, of.entry));
  });
  m.def("read_queries", [](const std::string& path, const std::string& csv_precision) {
    return parts_of(without_lock([&] { return read_query_file(path, parse_precision(csv_precision)); }));
  });
  m.def("queries_at", [](const std::vector<std::string>& addresses, const std::string& mesh, const std::string& queries,
                         const std::string& corpus) {
    return parts_of(without_lock([&] {
      std::vector<StoredQuery> stored;
      for (const std::string& address : addresses)
        stored.push_back(axiscert::query_at(parse_address(address), {mesh, queries, corpus}));
      return stored;
    }));
  });
  m.def("query_lines", &lines_of);
}

}  // namespace axiscert::python
