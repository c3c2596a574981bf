// A source of queries: a family, a mesh or a query file. The campaign asks it for queries by position.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/queries/family.h"

namespace axiscert {
inline constexpr std::uint64_t unit_size = std::uint64_t{1} << 16;

// The record's description of a file that queries came from.
struct FileInfo {
  std::string path = {};      // as given; not in the record
  std::string name = {};      // the base name
  std::string kind = {};      // "mesh", "queries", "corpus", "plugin"
  std::string sha256 = {};    // hash of the bytes, 64 hex digits
  std::uint64_t queries = 0;  // for kinds "queries" and "corpus"
  std::uint64_t triangles = 0, degenerate_triangles = 0, skipped_primitives = 0;  // for kind "mesh"
  std::string kernel = {};  // for kind "plugin": the id of the kernel that it is
};

// The names of sources that are lists of queries: "queries/FILE", and that of the corpus, of which there is only one.
inline constexpr std::string_view corpus_name = "corpus", query_file_prefix = "queries/";
inline bool is_query_file(std::string_view source) { return source.starts_with(query_file_prefix); }
inline bool is_query_list(std::string_view source) { return source == corpus_name || is_query_file(source); }

// Random access without state: any thread may ask for any position at any time.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::string name() const = 0;          // in the record: "tangent", "mesh/spider.obj", "queries/mine.jsonl"
  virtual std::string address_name() const = 0;  // in an address: "tangent", "mesh-SHA256", "queries-SHA256"
  virtual std::string purpose() const = 0;
  virtual int version() const = 0;
  virtual bool exact_arithmetic() const { return false; }
  virtual int trial_divisor() const { return 1; }  // Family::trial_divisor
  // The number of queries in this precision, if the caller cannot choose it.
  virtual std::optional<std::uint64_t> fixed_size(Precision) const { return std::nullopt; }
  // The number of triangles from which `trials` queries are drawn: queries that share a triangle are not independent.
  virtual std::uint64_t base_triangles(Precision, std::uint64_t trials) const { return trials; }
  // Which of these the query at a position shares: an image group, a triangle. Statistics count queries that share one
  // as one cluster. `cluster_run` positions after each other, from a multiple of it on, share one; 0: a triangle comes
  // again later.
  virtual std::uint64_t cluster(Precision, std::uint64_t position) const { return position; }
  virtual std::size_t cluster_run() const { return 1; }
  virtual std::optional<FileInfo> file() const { return std::nullopt; }

  // The predicate whose queries these are, and its entry in which their numbers are given.
  virtual const Predicate& predicate() const = 0;
  virtual std::size_t entry() const { return 0; }
  const std::vector<PredicateColumn>& columns() const { return predicate().entries[entry()].columns; }

  // Sets the columns, which are these, to the queries at `first` and after: as many as they have.
  virtual void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<float>& out) const = 0;
  virtual void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<double>& out) const = 0;
  // Sets `out`, which has these columns, to `count` queries, at most its capacity.
  template <class Real>
  void fill(std::uint64_t seed, std::uint64_t first, std::size_t count, QueryBatch<Real>& out) const {
    out.resize(count);
    fill_columns(seed, first, out.mutable_columns());
  }
  // The query at one position.
  template <class Real>
  Numbers<Real> make(std::uint64_t seed, std::uint64_t position) const {
    return filled_numbers<Real>(columns().size(),
                                [&](const MutableColumns<Real>& one) { fill_columns(seed, position, one); });
  }
};

using SourcePtr = std::shared_ptr<const Source>;

SourcePtr family_source(const Family& family);  // in fuzz/queries/family.cpp
// Defined in fuzz/files/mesh.cpp: any format that assimp reads. Throws Error with the file and its fault, or for a
// predicate that is not one of mesh_predicates().
SourcePtr mesh_source(const std::string& path, const Predicate& predicate);
// The predicates of which a mesh has queries.
std::vector<const Predicate*> mesh_predicates();
// Defined in fuzz/files/query_source.cpp: JSON Lines or CSV, "-" for standard input; `csv_precision` applies to CSV,
// which does not state one, and `known` are the predicates of which queries are understood. Throws Error if the queries
// have not one predicate and one entry.
SourcePtr query_file_source(const std::string& path, Precision csv_precision,
                            std::span<const Predicate* const> known = predicates());

// An address: all that is needed to make one query again, on any machine.

// The text form is SEED:NAME:VERSION:PRECISION:UNIT:INDEX, for instance 1:tangent:1:binary32:0:1234. The name of a mesh
// or a query file is mesh-SHA256 or queries-SHA256.
struct Address {
  std::uint64_t seed;
  std::string name;
  int version;
  Precision precision;
  std::uint64_t unit, index;  // index < 2^16

  std::uint64_t position() const { return unit * unit_size + index; }
};

// The text of the address of a position, for code that lists positions and does not know their source.
using AddressOf = std::function<std::string(std::uint64_t position)>;

std::string text(const Address& address);
Address address_of(const Source& source, std::uint64_t seed, Precision precision, std::uint64_t position);

// The queries of a source in a precision, made of a seed.
struct SeededSource {
  const Source& source;
  std::uint64_t seed;
  Precision precision;

  // The text of a position's address.
  std::string address(std::uint64_t position) const { return text(address_of(source, seed, precision, position)); }
  AddressOf addresses() const {
    return [of = *this](std::uint64_t position) { return of.address(position); };
  }
};

// Throws Error that says which field is wrong and shows the form.
Address parse_address(std::string_view text);
// Throws Error that lists the precisions that exist.
Precision parse_precision(std::string_view text);

}  // namespace axiscert
