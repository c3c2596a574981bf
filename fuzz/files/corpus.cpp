#include "fuzz/files/corpus.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "exact/judge/oracles.h"
#include "fuzz/files/query_line.h"
#include "fuzz/files/query_object.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"

namespace axiscert {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kinds = {"address", "search", "report", "made"};
constexpr std::array<std::string_view, 3> subjects = {"static", "sweep", "other"};

// The fault of a provenance, and the member at fault.
struct Wrong {
  std::string field, what;
};
std::optional<Wrong> fault(const Provenance& p) {
  const auto is_one_of = [](const auto& known, const std::string& given) {
    return std::find(known.begin(), known.end(), given) != known.end();
  };
  if (!is_one_of(kinds, p.kind)) {
    return Wrong{"kind", unknown_name("kind", "kinds", p.kind, {kinds.begin(), kinds.end()})};
  }
  if (p.where.empty()) return Wrong{"where", "empty; an address, a command, or the report's URL belongs here"};
  if (p.kind == "report" && !is_one_of(subjects, p.about)) {
    return Wrong{"about", unknown_name("subject of a report", "subjects", p.about, {subjects.begin(), subjects.end()})};
  }
  if (p.kind != "report" && !p.about.empty()) return Wrong{"about", "only a report has this member"};
  return std::nullopt;
}

// Reads the members of a corpus line other than its query.
class EntryReader {
 public:
  EntryReader(const json& line, const Place& place) : line_(line), place_(place) {}

  Provenance provenance() const {
    const json& given = object(line_, "provenance");
    Provenance p{text(given, "kind"), text(given, "where"), given.contains("about") ? text(given, "about") : ""};
    if (const auto wrong = fault(p)) place_.fail(wrong->field, wrong->what);
    return p;
  }

  std::string note() const { return line_.contains("note") ? text(line_, "note") : ""; }

  ExactAnswers expected(const Predicate& predicate) const {
    const json& given = object(line_, "expected");
    ExactAnswers out;
    const std::string verdict = text(given, "verdict");
    const auto known = std::find(verdict_names.begin(), verdict_names.end(), verdict);
    out.verdict = static_cast<Verdict>(known - verdict_names.begin());
    if (verdict != "contact" && verdict != "separated" && verdict != "invalid") {
      place_.fail("verdict", fmt::format("'{}'; contact, separated or invalid belongs here", verdict));
    }
    const json& touching = member(given, "touching");
    if (!touching.is_boolean()) place_.fail("touching", "true or false belongs here");
    out.touching = touching.get<bool>();
    if (out.verdict == Verdict::invalid || !oracles_of(predicate).has_squared_distance()) return out;
    out.squared_distance = fraction(text(given, "squared_distance"));
    out.comparisons = bits(given, "comparisons", predicate.comparisons.size());
    out.ties = bits(given, "ties", predicate.comparisons.size());
    return out;
  }

 private:
  const json& member(const json& from, const char* name) const {
    if (!from.contains(name)) place_.fail(name, "missing");
    return from[name];
  }
  const json& object(const json& from, const char* name) const {
    const json& value = member(from, name);
    if (!value.is_object()) place_.fail(name, "an object belongs here");
    return value;
  }
  std::string text(const json& from, const char* name) const {
    const json& value = member(from, name);
    if (!value.is_string()) place_.fail(name, "a string belongs here");
    return printable_line(value.get<std::string>());
  }
  Rational fraction(const std::string& given) const {
    Rational value;
    const std::size_t slash = given.find('/');
    const bool digits = given.find_first_not_of("0123456789/") == given.npos && slash != given.npos;
    if (!digits || value.set_str(given, 10) != 0 || value.get_den() == 0) {
      place_.fail("squared_distance", "\"NUMERATOR/DENOMINATOR\" belongs here");
    }
    value.canonicalize();
    return value;
  }
  ComparisonBits bits(const json& from, const char* name, std::size_t count) const {
    const std::string given = text(from, name);
    if (given.size() != count || given.find_first_not_of("01") != given.npos) {
      place_.fail(name, fmt::format("'{}'; {} digits 0 or 1 belong here", given, count));
    }
    ComparisonBits out = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (given[i] == '1') out |= one_bit<ComparisonBits>(i);
    }
    return out;
  }

  const json& line_;
  const Place& place_;
};

std::vector<std::string> corpus_files(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code problem;
  for (fs::directory_iterator it(folder, problem), end; !problem && it != end; it.increment(problem)) {
    if (it->path().extension() == ".jsonl") paths.push_back(it->path().string());
  }
  if (problem) throw Error(fmt::format("{}: the corpus cannot be read: {}", folder, problem.message()));
  if (paths.empty()) throw Error(fmt::format("{}: an empty corpus: it contains no *.jsonl file", folder));
  std::sort(paths.begin(), paths.end());
  return paths;
}

void read_file(const std::string& path, std::vector<CorpusEntry>& into) {
  const std::string bytes = read_bytes(path);
  std::vector<std::string_view> lines;
  for (std::string_view rest = bytes; !rest.empty();) {
    const std::size_t end = rest.find('\n');
    lines.push_back(rest.substr(0, end));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
  }
  for (StoredQuery& stored : parse_queries(bytes, path, Precision::binary32)) {
    const Place place{path, stored.line};
    const json line = json::parse(lines[stored.line - 1], nullptr, false);
    if (!line.is_object()) place.fail("", "a corpus is JSON Lines, each line one object");
    if (!line.contains("id")) place.fail("id", "missing; an entry needs a name");
    const EntryReader reader(line, place);
    Provenance provenance = reader.provenance();
    std::string note = reader.note();
    ExactAnswers expected = reader.expected(*stored.predicate);
    into.push_back({std::move(stored), std::move(provenance), std::move(note), std::move(expected), path});
  }
}

// Requires that no two entries have the same name and that none is an image of another.
void require_distinct(const std::vector<CorpusEntry>& entries) {
  std::map<std::string, const CorpusEntry*> names, forms;
  for (const CorpusEntry& entry : entries) {
    const auto place = [](const CorpusEntry& e) { return fmt::format("{}:{}", e.file, e.stored.line); };
    const auto [named, is_new_name] = names.try_emplace(entry.stored.id, &entry);
    if (!is_new_name) {
      throw Error(fmt::format("{}: field 'id': '{}' is already the name of {}", place(entry), entry.stored.id,
                              place(*named->second)));
    }
    const auto [formed, is_new_form] = forms.try_emplace(canonical_form(entry.stored), &entry);
    if (!is_new_form) {
      throw Error(fmt::format("{}: '{}' is equal to '{}' of {} up to a symmetry of the predicate", place(entry),
                              entry.stored.id, formed->second->stored.id, place(*formed->second)));
    }
  }
}

}  // namespace

ExactAnswers exact_answers(const StoredQuery& stored) {
  const Oracles& oracles = oracles_of(*stored.predicate, stored.entry);
  const auto asked = std::visit([&](const auto& q) { return oracles.about(q); }, stored.numbers);
  const Truth truth = asked->truth();
  ExactAnswers answers{truth.verdict, truth.touching};
  if (truth.verdict == Verdict::invalid || !oracles.has_squared_distance()) return answers;
  answers.squared_distance = asked->squared_distance();
  const std::optional<ExactSigns> signs = asked->published_signs();
  answers.comparisons = signs->holds;
  answers.ties = signs->ties;
  return answers;
}

std::string canonical_form(const StoredQuery& stored) {
  if (const auto own = capabilities_of(*stored.predicate).canonical_form) return own(stored);
  std::string text = fmt::format("{} {}", stored.predicate->id, name(stored.precision));
  std::visit(
      [&](const auto& q) {
        for (const auto x : q) text += " " + format_number(x == 0 ? x - x : x);
      },
      stored.numbers);
  return text;
}

std::vector<CorpusEntry> read_corpus(const std::string& folder) {
  std::vector<CorpusEntry> entries;
  for (const std::string& path : corpus_files(folder)) read_file(path, entries);
  if (entries.empty()) throw Error(fmt::format("{}: an empty corpus: it has no query of sphere-triangle", folder));
  require_distinct(entries);
  return entries;
}

std::string corpus_line(const CorpusEntry& entry) {
  CorpusLine line{stored_line(entry.stored), {entry.provenance.kind, entry.provenance.where, {}}, {}, {}};
  if (!entry.provenance.about.empty()) line.provenance.subject = entry.provenance.about;
  if (!entry.note.empty()) line.note = entry.note;
  ExpectedLine& expected = line.expected;
  expected.verdict = entry.expected.verdict;
  expected.touching = entry.expected.touching;
  const Oracles& oracles = oracles_of(*entry.stored.predicate, entry.stored.entry);
  if (oracles.has_squared_distance()) {
    for (auto* member : {&expected.squared_distance, &expected.comparisons, &expected.ties}) member->emplace();
  } else if (entry.expected.verdict != Verdict::invalid) {
    for (const Detail& detail : std::visit([&](const auto& q) { return oracles.details(q); }, entry.stored.numbers))
      expected.details.put(detail.name) = detail_json(detail);
  }
  if (const auto& d = entry.expected.squared_distance) {
    expected.squared_distance = d->get_num().get_str() + "/" + d->get_den().get_str();
    const std::size_t count = entry.stored.predicate->comparisons.size();
    expected.comparisons = bit_string(*entry.expected.comparisons, count);
    expected.ties = bit_string(*entry.expected.ties, count);
  }
  return json_of(line).dump();
}

const CorpusEntry* find_image(const std::vector<CorpusEntry>& entries, const StoredQuery& stored) {
  const std::string form = canonical_form(stored);
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const CorpusEntry& e) { return canonical_form(e.stored) == form; });
  return found == entries.end() ? nullptr : &*found;
}

Provenance parse_provenance(const std::string& text, const std::string& about) {
  const std::size_t colon = text.find(':');
  const Provenance p{text.substr(0, colon), colon == text.npos ? "" : text.substr(colon + 1), about};
  if (const auto wrong = fault(p)) {
    throw Error(fmt::format("--{} {}: {}: {}; the form is KIND:WHERE, for instance address:1:tangent:1:binary32:0:1234",
                            wrong->field == "about" ? "about" : "provenance", wrong->field == "about" ? about : text,
                            wrong->field, wrong->what));
  }
  return p;
}

std::string default_corpus_folder() {
  std::error_code problem;
  const fs::path installed = own_folder() / "../share/axiscert/corpus";
  return fs::is_directory(installed, problem) ? fs::canonical(installed).string() : AXISCERT_CORPUS;
}

}  // namespace axiscert
