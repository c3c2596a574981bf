// A source of queries: a family, a mesh or a query file. The campaign asks it for queries by position.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "fuzz/queries/family.h"

namespace axiscert {

inline constexpr std::uint64_t unit_size = std::uint64_t{1} << 16;

// The record's description of a file that queries came from.
struct FileInfo {
  std::string path = {};                                                          // as given; not in the record
  std::string name = {};                                                          // the base name
  std::string kind = {};                                                          // "mesh", "queries", "plugin"
  std::string sha256 = {};                                                        // hash of the bytes, 64 hex digits
  std::uint64_t queries = 0;                                                      // for kind "queries"
  std::uint64_t triangles = 0, degenerate_triangles = 0, skipped_primitives = 0;  // for kind "mesh"
};

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
  virtual std::optional<FileInfo> file() const { return std::nullopt; }

  virtual void make(std::uint64_t seed, std::uint64_t position, Query<float>& out) const = 0;
  virtual void make(std::uint64_t seed, std::uint64_t position, Query<double>& out) const = 0;
  // Sets `out` to the queries at `first` to first + count - 1, which equal those of make(); `count` is at most its
  // capacity.
  virtual void fill(std::uint64_t seed, std::uint64_t first, std::size_t count, QueryBatch<float>& out) const;
  virtual void fill(std::uint64_t seed, std::uint64_t first, std::size_t count, QueryBatch<double>& out) const;
};

using SourcePtr = std::shared_ptr<const Source>;

SourcePtr family_source(const Family& family);
// Defined in fuzz/meshes/mesh.cpp: any format that assimp reads. Throws Error with the file and its fault.
SourcePtr mesh_source(const std::string& path);
// Defined in fuzz/files/query_source.cpp: JSON Lines or CSV, "-" for standard input; `csv_precision` applies to CSV,
// which does not state one.
SourcePtr query_file_source(const std::string& path, Precision csv_precision);

}  // namespace axiscert
