// A query file and the corpus as sources: their queries in order, separately for each precision.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iostream>
#include <set>

#include "fuzz/files/corpus.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/sha256.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// The queries of one precision, one after the other.
template <class Real>
class Rows {
 public:
  explicit Rows(std::size_t columns) : columns_(columns) {}
  std::size_t size() const { return size_; }
  const Real* operator[](std::size_t i) const { return numbers_.data() + i * columns_; }
  void push_back(const Numbers<Real>& query) {
    numbers_.insert(numbers_.end(), query.begin(), query.end());
    ++size_;
  }

 private:
  std::size_t columns_, size_ = 0;
  std::vector<Real> numbers_;
};

// How many queries differ, bit for bit, in their first `columns` numbers.
template <class Real>
std::uint64_t distinct(const Rows<Real>& queries, std::size_t columns) {
  std::set<std::vector<std::uint64_t>> found;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    std::vector<std::uint64_t> bits(columns);
    for (std::size_t k = 0; k < columns; ++k) {
      bits[k] = std::bit_cast<std::uint64_t>(static_cast<double>(queries[i][k]));
    }
    found.insert(std::move(bits));
  }
  return found.size();
}

std::string query_text_of(const StoredQuery& stored) {
  return stored.entry == 0 ? std::string(stored.predicate->id)
                           : fmt::format("{}, entry {}", stored.predicate->id, stored.columns().name);
}

class QueryFileSource final : public ColumnSource<QueryFileSource> {
 public:
  // `kind` is "queries", or "corpus", of which there is only one; the hash is that of `bytes`. There is a query.
  QueryFileSource(const char* kind, const FileInfo& file, const std::string& bytes,
                  const std::vector<StoredQuery>& queries)
      : kind_(kind),
        predicate_(*queries.front().predicate),
        entry_(queries.front().entry),
        binary32_(queries.front().columns().columns.size()),
        binary64_(queries.front().columns().columns.size()),
        file_(file) {
    for (const StoredQuery& stored : queries) {
      if (stored.predicate != &predicate_ || stored.entry != entry_) {
        throw Error(fmt::format(
            "{}:{}: a query of {}, but those before it are of {}; the queries of a file have one predicate and "
            "one entry",
            file.path == "-" ? "stdin" : file.path, stored.line, query_text_of(stored),
            query_text_of(queries.front())));
      }
      switch (stored.precision) {
        case Precision::binary32:
          binary32_.push_back(std::get<Numbers<float>>(stored.numbers));
          break;
        case Precision::binary64:
          binary64_.push_back(std::get<Numbers<double>>(stored.numbers));
          break;
      }
    }
    const PredicateEntry& entry = queries.front().columns();
    const std::size_t columns = entry.shared_columns != 0 ? entry.shared_columns : entry.columns.size();
    independent32_ = distinct(binary32_, columns);
    independent64_ = distinct(binary64_, columns);
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
    return std::min(trials, precision == Precision::binary32 ? independent32_ : independent64_);
  }
  std::optional<FileInfo> file() const override { return file_; }

  const Predicate& predicate() const override { return predicate_; }
  std::size_t entry() const override { return entry_; }
  template <class Real>
  void fill_columns(std::uint64_t, std::uint64_t first, const MutableColumns<Real>& out) const {
    const auto& queries = rows<Real>();
    for (std::size_t i = 0; i < out.size; ++i) {
      if (first + i >= queries.size()) {
        throw Error(fmt::format("{}: there is no {} query at position {}; the number of queries is {}", file_.name,
                                axiscert::name(precision_of<Real>), first + i, queries.size()));
      }
      for (std::size_t k = 0; k < out.count; ++k) out.column[k][i] = queries[first + i][k];
    }
  }

 private:
  template <class Real>
  const Rows<Real>& rows() const {
    if constexpr (precision_of<Real> == Precision::binary32) return binary32_;
    else return binary64_;
  }

  std::string kind_;
  const Predicate& predicate_;
  std::size_t entry_;
  Rows<float> binary32_;
  Rows<double> binary64_;
  std::uint64_t independent32_, independent64_;
  FileInfo file_;
};

}  // namespace

SourcePtr query_file_source(const std::string& path, Precision csv_precision, std::span<const Predicate* const> known) {
  const bool piped = path == "-";
  const std::string where = piped ? "stdin" : path, bytes = piped ? read_bytes(std::cin, where) : read_bytes(path);
  return std::make_shared<QueryFileSource>("queries", FileInfo{path, base_name(where)}, bytes,
                                           parse_queries(bytes, where, csv_precision, known));
}

SourcePtr corpus_source(const std::string& folder, const Predicate& predicate, std::size_t entry) {
  std::string lines;
  std::vector<StoredQuery> queries;
  for (const CorpusEntry& kept : read_corpus(folder)) {
    if (kept.stored.predicate != &predicate || kept.stored.entry != entry) continue;
    lines += query_line(kept.stored) + "\n";
    queries.push_back(kept.stored);
  }
  if (queries.empty()) {
    throw Error(fmt::format("{}: the corpus has no query of the predicate {}, entry {}", folder, predicate.id,
                            predicate.entries[entry].name));
  }
  return std::make_shared<QueryFileSource>("corpus", FileInfo{folder, "corpus"}, lines, queries);
}

}  // namespace axiscert
