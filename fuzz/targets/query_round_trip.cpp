#include "fuzz/targets/query_round_trip.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "fuzz/files/query_file.h"

namespace axiscert::fuzzing {
namespace {

template <class Real>
bool is_same_number(Real x, Real y) {
  return (std::isnan(x) && std::isnan(y)) || std::memcmp(&x, &y, sizeof x) == 0;
}

bool is_same_query(const StoredQuery& x, const StoredQuery& y) {
  if (x.precision != y.precision || x.numbers.index() != y.numbers.index()) return false;
  if (x.predicate != y.predicate || x.entry != y.entry) return false;
  return std::visit(
      [&](const auto& numbers) {
        const auto& other = std::get<std::remove_cvref_t<decltype(numbers)>>(y.numbers);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
          if (!is_same_number(numbers[k], other[k])) return false;
        }
        return true;
      },
      x.numbers);
}

// Checks the bytes with either precision, which only a CSV file takes from here.
void check(std::string_view bytes, Precision csv_precision) {
  std::vector<StoredQuery> queries;
  if (!accepts([&] { queries = parse_queries(bytes, "fuzzed", csv_precision); })) return;
  std::string lines;
  for (const StoredQuery& stored : queries) {
    if (stored.numbers.index() != index_of(stored.precision)) {
      report_fault(
          fmt::format("line {} says {} but has a query of the other precision", stored.line, name(stored.precision)));
    }
    lines += query_line(stored) + "\n";
  }
  std::vector<StoredQuery> again;
  const bool is_read = accepts([&] { again = parse_queries(lines, "written", Precision::binary32); });
  if (!is_read || again.size() != queries.size())
    report_fault("the lines written from a query file cannot be read:\n" + lines);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    StoredQuery named = queries[i];
    named.id = again[i].id;
    if (!is_same_query(queries[i], again[i]) || query_line(named) != query_line(again[i])) {
      report_fault(fmt::format("query {} of the file changes when it is read, written and read again:\n{}\n{}", i + 1,
                               query_line(queries[i]), query_line(again[i])));
    }
  }
}

}  // namespace

void check_round_trip(std::string_view bytes) {
  check(bytes, Precision::binary32);
  check(bytes, Precision::binary64);
}

}  // namespace axiscert::fuzzing
