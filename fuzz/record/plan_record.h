// The plan of a run as its record states it: with the files and this version of axiscert, enough to make it again.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/text/values.h"
#include "kernel/kernel.h"
#include "kernel/names.h"

namespace axiscert {

struct Sha256Rule {
  static constexpr std::size_t longest = 64;
  static constexpr std::string_view pattern = "^[0-9a-f]{64}$";
};
using Sha256 = Text<Sha256Rule>;

struct FileKindRule {
  static constexpr std::size_t longest = 64;
  static constexpr std::string_view pattern =
      "^(mesh|queries|corpus|plugin|manifest|program(-[0-9]+)?|file(-[0-9]+)?|lock)$";
};

// A decimal number of u.
struct ToleranceRule {
  static constexpr std::size_t longest = 1000;
  static constexpr std::string_view pattern = "^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$";
};

struct LevelRule {
  static constexpr std::size_t longest = 4200;
};
using LevelText = Text<LevelRule>;

struct GeneratorRecord {
  std::uint64_t version = 0;
  bool exact_arithmetic = false;
  std::string purpose;

  static constexpr std::string_view about = "A family's source of queries.";
  AXISCERT_FIELDS(GeneratorRecord,
                  AXISCERT_FIELD(version, "Raised whenever the same address would make another query."),
                  AXISCERT_FIELD(exact_arithmetic,
                                 "Whether the precision's arithmetic is exact on every query, so that no rounding can "
                                 "be the cause of an error."),
                  AXISCERT_FIELD(purpose, "The purpose of the family, in one line."))
};

struct FileRecord {
  Name name;
  Text<FileKindRule> kind;
  std::optional<Sha256> sha256;
  std::optional<std::uint64_t> queries, triangles, degenerate_triangles, skipped_primitives;
  std::optional<std::map<Precision, std::uint64_t>> left_out;

  bool has_queries() const { return kind == "queries" || kind == "corpus"; }
  // That of its queries, or of a mesh.
  std::string family_name() const { return kind == "corpus" ? std::string(kind) : kind + "/" + name; }

  static constexpr std::string_view about = "A file that was read.";
  AXISCERT_FIELDS(FileRecord, AXISCERT_FIELD(name, "Base name."),
                  AXISCERT_FIELD(kind,
                                 "mesh: triangles at which the queries aim; queries: stored queries; corpus; "
                                 "plugin: somebody else's kernel; manifest, program or file, lock: a program's "
                                 "manifest, a file that its command names, the lock file of its packages."),
                  AXISCERT_FIELD(sha256, "SHA-256 of the file's bytes; null where it could not be read."),
                  AXISCERT_OPTIONAL_FIELD(queries, "Of queries: those read."),
                  AXISCERT_OPTIONAL_FIELD(triangles, "Of a mesh: triangles read."),
                  AXISCERT_OPTIONAL_FIELD(degenerate_triangles,
                                          "Of a mesh: triangles of exactly zero area among them."),
                  AXISCERT_OPTIONAL_FIELD(skipped_primitives, "Of a mesh: points and lines, which have no triangle."),
                  AXISCERT_OPTIONAL_FIELD(left_out,
                                          "Of queries: those of a precision that --precision leaves out. Absent where "
                                          "it leaves out none."))
};

struct RepliesRecord {
  std::optional<std::string> conforms_to, formulae;
  TouchingPolicy touching = TouchingPolicy::contact;
  bool may_decline = false;
  std::optional<std::uint64_t> measures;
  std::optional<double> margin;
  std::optional<SidesPolicy> sides;

  static constexpr std::string_view about =
      "Present where the replies of a program were judged (axiscert judge) and no kernel was run: what the program "
      "claims to be.";
  AXISCERT_FIELDS(
      RepliesRecord,
      AXISCERT_FIELD(conforms_to, "The kernel that it claims to equal bit for bit, as given to --conforms-to."),
      AXISCERT_FIELD(formulae, "The kernel whose formulae it claims to evaluate, as given to --formulae."),
      AXISCERT_FIELD(touching, "Its intended answer for a sphere that touches the triangle."),
      AXISCERT_FIELD(may_decline, "Whether it may answer `undecided`, as --may-decline says."),
      AXISCERT_OPTIONAL_FIELD(measures,
                              "So many of the predicate's measures came with each reply, from the first on, as given "
                              "to generate --measures. Absent: none."),
      AXISCERT_OPTIONAL_FIELD(
          margin,
          "It may report contact where the two are apart by at most this, as given to --margin. Absent: nowhere.",
          "length"),
      AXISCERT_OPTIONAL_FIELD(
          sides, "front: it promises the front side of the triangle alone, as given to --sides. Absent: both."))
};

// What was given to --require: JSON has null where there is none, one level as text, several as an array.
struct RequiredLevels {
  std::vector<LevelText> levels;
};
template <>
struct JsonForm<RequiredLevels> {
  static Json write(const RequiredLevels& value);
  static void read(const JsonPlace& place, RequiredLevels& into);
  static Json schema();
};

// For each family, a count in each precision.
using CountsByFamily = NamedValues<std::map<Precision, std::uint64_t>>;

struct PlanRecord {
  Name axiscert, predicate;
  WholeNumber seed;
  std::vector<Name> kernels;
  std::vector<Precision> precisions;
  std::vector<Name> families;
  NamedValues<GeneratorRecord> generators;
  CountsByFamily trials;
  std::vector<FileRecord> files;
  NamedValues<Text<ToleranceRule>> tolerance;
  RequiredLevels require;
  std::optional<std::vector<LevelText>> allow_unchecked;
  std::uint64_t margin_queries = 0;
  std::optional<RepliesRecord> replies;
  std::optional<Name> unit;
  std::optional<CountsByFamily> planned, units_done;

  static constexpr std::string_view about =
      "The plan of the run: together with the files and this version of axiscert, enough to make the record again.";
  AXISCERT_FIELDS(
      PlanRecord, AXISCERT_FIELD(axiscert, "The version of axiscert that ran it."),
      AXISCERT_FIELD(predicate,
                     "The predicate of all kernels and queries, as `axiscert predicates` lists it. Its description "
                     "says which axes, comparisons and numbers of a query this record has: those and no others."),
      AXISCERT_FIELD(seed, "The seed of every generator's random stream; 64 bits."),
      AXISCERT_FIELD(kernels, "Ids as given to --kernel."),
      AXISCERT_FIELD(precisions,
                     "The precisions asked for in which a kernel exists; empty where none could be loaded."),
      AXISCERT_FIELD(families,
                     "In order: generator families by name, meshes as mesh/FILE, query files as queries/FILE, the "
                     "corpus as corpus."),
      AXISCERT_FIELD(generators, "The generator of each family's queries."),
      AXISCERT_FIELD(trials, "Number of queries, per family and precision."),
      AXISCERT_FIELD(files, "The meshes, query files and plug-ins that were read, by base name."),
      AXISCERT_FIELD(tolerance,
                     "The error T, in u, above which a comparison of the predicate fails, as it was written. A "
                     "comparison without one is not checked."),
      AXISCERT_FIELD(require,
                     "What was given to --require: a level, or several of them as a list; null where none was given."),
      AXISCERT_OPTIONAL_FIELD(allow_unchecked,
                              "The levels that pass where they are not checked, as given to --allow-unchecked; absent "
                              "where there are none."),
      AXISCERT_FIELD(
          margin_queries,
          "The number of queries, the first of each family and precision, whose exact margins were counted."),
      AXISCERT_OPTIONAL_FIELD(replies, RepliesRecord::about),
      AXISCERT_OPTIONAL_FIELD(unit,
                              "The unit of length of the queries' numbers, as given to --unit. Absent: it was not "
                              "said, and levels take it for the metre, in which families of scenes are."),
      AXISCERT_OPTIONAL_FIELD(planned,
                              "Of how many queries `trials` are those that were asked, per family and precision; "
                              "with --time, of files alone. Absent where these were all."),
      AXISCERT_FIELD(units_done,
                     "Units of 2^16 queries done, per family and precision, where the plan does not determine them: "
                     "with --time, or after an interruption. Null otherwise."))
};

}  // namespace axiscert
