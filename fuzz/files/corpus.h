// The corpus: queries that are kept because they were hard once, with their origin and the exact answers.
//
// A folder of *.jsonl, each a query file whose lines have, in addition to the query with its `id` as a name:
//   "provenance": {"kind": "address" | "search" | "report" | "made", "where": TEXT}; for a report also
//                 "about": "static" | "sweep" | "other", the subject of the report
//   "note": TEXT, optional
//   "expected": {"verdict", "touching", "squared_distance", "comparisons", "ties"}, as the `exact` of `axiscert check`;
//   the last three are null if the verdict is `invalid`. For a query of a predicate that compares no distance the first
//   two, and whatever else `exact` has for that predicate.
#pragma once

#include <optional>

#include "exact/numbers/rational.h"
#include "fuzz/files/query_file.h"
#include "fuzz/files/query_object.h"
#include "fuzz/queries/source.h"

namespace axiscert {

struct Provenance {
  std::string kind, where, about;
};

// The exact answers to a query; the last three are empty if the verdict is `invalid`, or the predicate compares no
// distance.
struct ExactAnswers {
  Verdict verdict = Verdict::invalid;
  bool touching = false;
  std::optional<Rational> squared_distance = {};
  std::optional<ComparisonBits> comparisons = {}, ties = {};  // those of the published formulae, strict
  bool operator==(const ExactAnswers&) const = default;
};
// Computed by all oracles of the predicate. Throws OracleDisagreement.
ExactAnswers exact_answers(const StoredQuery& stored);

// Text that two queries of one precision share if and only if one is an image of the other (Capabilities); of a
// predicate without the capability each query has its own. Zeros have no sign.
std::string canonical_form(const StoredQuery& stored);

struct CorpusEntry {
  StoredQuery stored;  // its id is the entry's name, its line the line in its file
  Provenance provenance;
  std::string note;
  ExactAnswers expected;
  std::string file;  // path
};

// Every entry, file by file in the order of their names. Throws Error that names file, line and field: a folder that
// cannot be read or has no entry, a name given twice, two entries that are equal up to a symmetry of the predicate.
std::vector<CorpusEntry> read_corpus(const std::string& folder);
// One line of a corpus file, as a struct, and without its line end.
struct ProvenanceLine {
  Name kind;
  std::string where;
  std::optional<std::string> subject;

  AXISCERT_FIELDS(ProvenanceLine, AXISCERT_FIELD(kind, "address, search, report or made."),
                  AXISCERT_FIELD(where, "The address, link or title."),
                  field(&Of::subject, {.name = "about", .about = "The subject of a report.", .may_be_absent = true}))
};
struct ExpectedLine {
  Verdict verdict = Verdict::invalid;
  bool touching = false;
  std::optional<std::optional<std::string>> squared_distance, comparisons, ties;
  NamedValues<Json> details;  // of the predicate, by name

  static constexpr std::string_view about = "The exact answers, with what else the predicate's oracles tell.";
  AXISCERT_FIELDS(ExpectedLine, AXISCERT_FIELD(verdict, "The answer."),
                  AXISCERT_FIELD(touching, "Whether the two touch and no more."),
                  AXISCERT_OPTIONAL_FIELD(
                      squared_distance,
                      "A fraction; this and the next two of a predicate that compares a distance, null where invalid."),
                  AXISCERT_OPTIONAL_FIELD(comparisons,
                                          "Comparison bits, a digit each in the order of `axiscert predicates`."),
                  AXISCERT_OPTIONAL_FIELD(ties, "Which of the comparisons are ties."), rest(&Of::details))
};
struct CorpusLine : StoredLine {
  ProvenanceLine provenance;
  std::optional<std::string> note;
  ExpectedLine expected;

  static constexpr std::string_view title = "A query that is kept",
                                    about =
                                        "A line of `axiscert corpus list --format jsonl` and of the files of a corpus: "
                                        "a line of a query file (docs/queries.md) with its exact answers "
                                        "(docs/corpus.md). The files are written by hand too, so no line names the "
                                        "format.";
  AXISCERT_FIELDS(CorpusLine, base<Of, StoredLine>(), AXISCERT_FIELD(provenance, "Where it came from."),
                  AXISCERT_OPTIONAL_FIELD(note, "What it shows."), AXISCERT_FIELD(expected, ExpectedLine::about))
};
std::string corpus_line(const CorpusEntry& entry);
// The entry that a query is a symmetric image of, if any.
const CorpusEntry* find_image(const std::vector<CorpusEntry>& entries, const StoredQuery& stored);
// Parses KIND:WHERE, for instance "address:1:tangent:1:binary32:0:1234"; `about` is for reports only. Throws Error that
// says what is right.
Provenance parse_provenance(const std::string& text, const std::string& about);

// The folder share/axiscert/corpus beside an installed command, otherwise that of the source tree.
std::string default_corpus_folder();

// The corpus's queries of one entry of a predicate as a source of that name. Its address is "corpus-SHA256", the hash
// of the queries' lines, one file after the other. Throws Error where it has none.
SourcePtr corpus_source(const std::string& folder, const Predicate& predicate, std::size_t entry = 0);

}  // namespace axiscert
