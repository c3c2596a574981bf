// The corpus: queries that are kept because they were hard once, with where they came from and the exact answers.
//
// A folder of *.jsonl, each a query file whose lines have beside the query, named by its `id`:
//   "provenance": {"kind": "address" | "search" | "report" | "made", "where": TEXT}; of a report also
//                 "about": "static" | "sweep" | "other", what the report was about
//   "note": TEXT, may be left out
//   "expected": {"verdict", "touching", "squared_distance", "comparisons", "ties"}, as the `exact` of `axiscert check`;
//               the last three null where the verdict is `invalid`
#pragma once

#include <optional>

#include "exact/numbers/rational.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/source.h"

namespace axiscert {

struct Provenance {
  std::string kind, where, about;
};

// What exact arithmetic says of a query; the last three empty where the verdict is `invalid`.
struct ExactAnswers {
  Verdict verdict = Verdict::invalid;
  bool touching = false;
  std::optional<Rational> squared_distance = {};
  std::optional<ComparisonBits> comparisons = {}, ties = {};  // of the published formulae, strict
  bool operator==(const ExactAnswers&) const = default;
};
// By CGAL, the exact formulae and MPFR. Throws OracleDisagreement.
ExactAnswers exact_answers(const StoredQuery& stored);

struct CorpusEntry {
  StoredQuery stored;  // its id is the entry's name, its line that of its file
  Provenance provenance;
  std::string note;
  ExactAnswers expected;
  std::string file;  // path
};

// Every entry, file by file in the order of their names. Throws Error that names file, line and field: a folder that
// cannot be read or holds no entry, a name given twice, two entries that are one by the symmetries of the test.
std::vector<CorpusEntry> read_corpus(const std::string& folder);
// One line of a corpus file, without its end.
std::string corpus_line(const CorpusEntry& entry);
// The entry that a query is a symmetric image of, if any.
const CorpusEntry* find_image(const std::vector<CorpusEntry>& entries, const StoredQuery& stored);
// "address", "search: ...", from "KIND:WHERE"; `about` is for reports alone. Throws Error that says what is right.
Provenance parse_provenance(const std::string& text, const std::string& about);

// share/axiscert/corpus beside an installed command, else the source tree's.
std::string default_corpus_folder();

// Its queries as a source named "corpus", its address "corpus-SHA256": of the queries' lines, one file after the other.
SourcePtr corpus_source(const std::string& folder);

}  // namespace axiscert
