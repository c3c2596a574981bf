#include "fuzz/files/query_file.h"

#include <fmt/format.h>

#include <iostream>
#include <set>
#include <sstream>

#include "fuzz/files/query_line.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

template <class Real>
Numbers<Real> numbers_of(const std::vector<NumberText>& texts, const Place& place) {
  Numbers<Real> values(texts.size());
  for (std::size_t k = 0; k < texts.size(); ++k) {
    try {
      values[k] = parse_number<Real>(texts[k].text);
    } catch (const Error& wrong) {
      place.fail(texts[k].field, texts[k].element + wrong.what());
    }
  }
  return values;
}

QueryNotes& query_notes() {
  static QueryNotes notes;
  return notes;
}

// Tells of the fields of one line that no line before it had.
void tell_unread(const std::vector<UnreadField>& unread, const Place& place, std::set<std::string>& told) {
  constexpr std::size_t most = 8;  // names of one file
  for (const UnreadField& field : unread) {
    if (told.size() == most || !told.insert(field.name).second || !query_notes()) continue;
    query_notes()(fmt::format("{}:{}: field '{}' is not read{}", place.file, place.line, shown(field.name),
                              field.meant.empty() ? "" : fmt::format("; did you mean '{}'?", field.meant)));
  }
}

// The next line without its end; empty if there is none. A last line without an end is a line; the empty rest after the
// last end is not.
std::optional<std::string_view> take_line(std::string_view& rest) {
  if (rest.empty()) return std::nullopt;
  const std::size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

void set_query_notes(QueryNotes notes) { query_notes() = std::move(notes); }

std::string Place::default_id() const { return fmt::format("line-{}", line); }

void Place::fail(std::string_view field, std::string_view what) const {
  if (field.empty()) throw Error(fmt::format("{}:{}: {}", file, line, what));
  throw Error(fmt::format("{}:{}: field '{}': {}", file, line, shown(field), what));
}

StoredQuery stored_query(std::string_view id, Precision precision, const EntryOfPredicate& of,
                         const std::vector<NumberText>& numbers, const Place& place) {
  StoredQuery stored{printable_line(id), precision, {}, of.predicate, of.entry, place.line};
  switch (precision) {
    case Precision::binary32:
      stored.numbers = numbers_of<float>(numbers, place);
      break;
    case Precision::binary64:
      stored.numbers = numbers_of<double>(numbers, place);
      break;
  }
  return stored;
}

std::vector<StoredQuery> parse_queries(std::string_view bytes, std::string_view name, Precision csv_precision,
                                       KnownPredicates known) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  std::vector<StoredQuery> queries;
  std::optional<CsvHeader> csv;
  bool first = true;
  Place place{name, 0};
  std::set<std::string> told;
  while (const auto line = take_line(bytes)) {
    ++place.line;
    if (line->find_first_not_of(" \t") == line->npos) continue;
    // The JSON parser treats a NUL as the end of its input.
    if (line->find('\0') != line->npos) place.fail("", "a NUL byte; a query file is text (UTF-8)");
    if (first) {
      first = false;
      csv = csv_header(*line, place, known);
      if (csv) continue;
    }
    std::vector<UnreadField> unread;
    queries.push_back(csv ? query_of_csv(*line, *csv, csv_precision, place)
                          : query_of_json(*line, place, known, &unread));
    tell_unread(unread, place, told);
  }
  if (queries.empty()) {
    throw Error(
        fmt::format("{}: no queries; write JSON Lines, or CSV under the header [id,]{}", name, csv_columns(known)));
  }
  return queries;
}

std::vector<StoredQuery> read_queries(std::istream& in, std::string_view name, Precision csv_precision) {
  return parse_queries(read_bytes(in, std::string(name)), name, csv_precision);
}

std::vector<StoredQuery> read_query_file(const std::string& path, Precision csv_precision) {
  if (path == "-") return parse_queries(standard_input(), "stdin", csv_precision);
  return parse_queries(read_bytes(path), path, csv_precision);
}

}  // namespace axiscert
