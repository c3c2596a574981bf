// A query file and the corpus as sources: their queries in order, separately for each precision.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iostream>

#include "fuzz/files/corpus.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/sha256.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

template <class Real>
std::uint64_t distinct_triangles(const std::vector<Query<Real>>& queries) {
  std::vector<std::array<std::uint64_t, 9>> triangles;
  for (const Query<Real>& q : queries) {
    auto& bits = triangles.emplace_back();
    const auto v = coordinates(q);
    for (std::size_t k = 0; k < bits.size(); ++k) bits[k] = std::bit_cast<std::uint64_t>(static_cast<double>(v[k]));
  }
  std::sort(triangles.begin(), triangles.end());
  return static_cast<std::uint64_t>(std::unique(triangles.begin(), triangles.end()) - triangles.begin());
}

class QueryFileSource final : public Source {
 public:
  // `kind` is "queries", or "corpus", of which there is only one; the hash is that of `bytes`.
  QueryFileSource(const char* kind, const FileInfo& file, const std::string& bytes,
                  const std::vector<StoredQuery>& queries)
      : kind_(kind), file_(file) {
    for (const StoredQuery& stored : queries) {
      switch (stored.precision) {
        case Precision::binary32:
          binary32_.push_back(std::get<Query<float>>(stored.query));
          break;
        case Precision::binary64:
          binary64_.push_back(std::get<Query<double>>(stored.query));
          break;
      }
    }
    triangles32_ = distinct_triangles(binary32_);
    triangles64_ = distinct_triangles(binary64_);
    file_.kind = "queries";
    file_.sha256 = sha256_hex(std::as_bytes(std::span(bytes)));
    file_.queries = binary32_.size() + binary64_.size();
  }

  std::string name() const override { return kind_ == "corpus" ? kind_ : kind_ + "/" + file_.name; }
  std::string address_name() const override { return kind_ + "-" + file_.sha256; }
  std::string purpose() const override {
    return kind_ == "corpus" ? "queries that were hard once: public reports, degenerate classics, witnesses"
                             : "the queries of a file, as they stand";
  }
  int version() const override { return 1; }
  std::optional<std::uint64_t> fixed_size(Precision precision) const override {
    switch (precision) {
      case Precision::binary32:
        return binary32_.size();
      case Precision::binary64:
        return binary64_.size();
    }
    return std::nullopt;
  }
  std::uint64_t base_triangles(Precision precision, std::uint64_t trials) const override {
    return std::min(trials, precision == Precision::binary32 ? triangles32_ : triangles64_);
  }
  std::optional<FileInfo> file() const override { return file_; }

  void make(std::uint64_t, std::uint64_t position, Query<float>& out) const override { out = at(binary32_, position); }
  void make(std::uint64_t, std::uint64_t position, Query<double>& out) const override { out = at(binary64_, position); }

 private:
  template <class Real>
  Query<Real> at(const std::vector<Query<Real>>& queries, std::uint64_t position) const {
    if (position < queries.size()) return queries[position];
    throw Error(fmt::format("{}: there is no {} query at position {}; the number of queries is {}", file_.name,
                            axiscert::name(precision_of<Real>), position, queries.size()));
  }

  std::string kind_;
  std::vector<Query<float>> binary32_;
  std::vector<Query<double>> binary64_;
  std::uint64_t triangles32_, triangles64_;
  FileInfo file_;
};

}  // namespace

SourcePtr query_file_source(const std::string& path, Precision csv_precision) {
  const bool piped = path == "-";
  const std::string where = piped ? "stdin" : path, bytes = piped ? read_bytes(std::cin, where) : read_bytes(path);
  return std::make_shared<QueryFileSource>("queries", FileInfo{path, base_name(where)}, bytes,
                                           parse_queries(bytes, where, csv_precision));
}

SourcePtr corpus_source(const std::string& folder) {
  std::string lines;
  std::vector<StoredQuery> queries;
  for (const CorpusEntry& entry : read_corpus(folder)) {
    lines += query_line(entry.stored) + "\n";
    queries.push_back(entry.stored);
  }
  return std::make_shared<QueryFileSource>("corpus", FileInfo{folder, "corpus"}, lines, queries);
}

}  // namespace axiscert
