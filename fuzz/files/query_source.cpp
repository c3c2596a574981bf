// A query file and the corpus as sources: their queries in order, separately for each precision.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iostream>
#include <map>

#include "fuzz/files/corpus.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"

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

// For each query the index, among all that differ, of its first `columns` numbers, bit for bit.
struct DistinctParts {
  std::vector<std::uint32_t> of_query;
  std::uint64_t count = 0;
};
template <class Real>
DistinctParts distinct(const Rows<Real>& queries, std::size_t columns) {
  DistinctParts parts;
  std::map<std::vector<std::uint64_t>, std::uint32_t> found;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    std::vector<std::uint64_t> bits(columns);
    for (std::size_t k = 0; k < columns; ++k) {
      bits[k] = std::bit_cast<std::uint64_t>(static_cast<double>(queries[i][k]));
    }
    parts.of_query.push_back(found.emplace(std::move(bits), static_cast<std::uint32_t>(found.size())).first->second);
  }
  parts.count = found.size();
  return parts;
}

class QueryFileSource final : public Source {
 public:
  // `kind` is "queries", or "corpus", of which there is only one; the hash is that of `bytes`, and the address that of
  // `addressed`. There is a query, and all are of one predicate and entry.
  QueryFileSource(const char* kind, const FileInfo& file, const std::string& bytes, const std::string& addressed,
                  const std::vector<StoredQuery>& queries)
      : addressed_(hash_of(addressed)),
        predicate_(*queries.front().predicate),
        entry_(queries.front().entry),
        binary32_(queries.front().columns().columns.size()),
        binary64_(queries.front().columns().columns.size()),
        file_(file) {
    for (const StoredQuery& stored : queries) {
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
    parts32_ = distinct(binary32_, columns);
    parts64_ = distinct(binary64_, columns);
    file_.kind = kind;
    file_.sha256 = hash_of(bytes);
    file_.queries = binary32_.size() + binary64_.size();
  }

  std::string name() const override { return is_corpus() ? file_.name : std::string(query_file_prefix) + file_.name; }
  std::string address_name() const override { return file_.kind + "-" + addressed_; }
  std::string purpose() const override {
    return is_corpus() ? "queries that were hard once: public reports, degenerate classics, witnesses"
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
    return std::min(trials, parts(precision).count);
  }
  std::uint64_t cluster(Precision precision, std::uint64_t position) const override {
    return parts(precision).of_query.at(position);
  }
  std::size_t cluster_run() const override { return 0; }
  std::optional<FileInfo> file() const override { return file_; }

  const Predicate& predicate() const override { return predicate_; }
  std::size_t entry() const override { return entry_; }
  void fill_columns(std::uint64_t, std::uint64_t first, const MutableColumns<float>& out) const override {
    copy(first, out);
  }
  void fill_columns(std::uint64_t, std::uint64_t first, const MutableColumns<double>& out) const override {
    copy(first, out);
  }

 private:
  template <class Real>
  void copy(std::uint64_t first, const MutableColumns<Real>& out) const {
    const auto& queries = rows<Real>();
    for (std::size_t i = 0; i < out.size; ++i) {
      if (first + i >= queries.size()) {
        throw Error(fmt::format("{}: there is no {} query at position {}; the number of queries is {}", file_.name,
                                axiscert::name(precision_of<Real>), first + i, queries.size()));
      }
      for (std::size_t k = 0; k < out.count; ++k) out.column[k][i] = queries[first + i][k];
    }
  }
  template <class Real>
  const Rows<Real>& rows() const {
    if constexpr (precision_of<Real> == Precision::binary32) return binary32_;
    else return binary64_;
  }

  const DistinctParts& parts(Precision precision) const {
    return precision == Precision::binary32 ? parts32_ : parts64_;
  }

  static std::string hash_of(const std::string& bytes) { return sha256_hex(std::as_bytes(std::span(bytes))); }

  bool is_corpus() const { return file_.kind == corpus_name; }

  std::string addressed_;
  const Predicate& predicate_;
  std::size_t entry_;
  Rows<float> binary32_;
  Rows<double> binary64_;
  DistinctParts parts32_, parts64_;
  FileInfo file_;
};

}  // namespace

std::vector<SourcePtr> query_file_sources(const std::string& path, Precision csv_precision,
                                          std::span<const Predicate* const> known) {
  const bool piped = path == "-";
  const std::string where = piped ? "stdin" : path;
  const std::string bytes = piped ? standard_input() : read_bytes(path);
  std::vector<std::vector<StoredQuery>> parts;
  for (StoredQuery& query : parse_queries(bytes, where, csv_precision, known)) {
    auto part = std::ranges::find_if(parts, [&](const std::vector<StoredQuery>& other) {
      return other.front().predicate == query.predicate && other.front().entry == query.entry;
    });
    if (part == parts.end()) part = parts.insert(part, std::vector<StoredQuery>());
    part->push_back(std::move(query));
  }
  std::vector<SourcePtr> sources;
  for (const std::vector<StoredQuery>& part : parts) {
    // A part of a file has an address of its own, which says of which file and which part.
    const std::string name = part_text(*part.front().predicate, part.front().entry);
    const std::string addressed = parts.size() == 1 ? bytes : name + "\n" + bytes;
    sources.push_back(
        std::make_shared<QueryFileSource>("queries", FileInfo{path, base_name(where)}, bytes, addressed, part));
  }
  return sources;
}

std::vector<PartCount> counts_of(const std::vector<SourcePtr>& parts) {
  std::vector<PartCount> counts;
  for (const SourcePtr& part : parts) counts.push_back({&part->predicate(), part->entry(), part->file()->queries});
  return counts;
}

std::vector<PartCount> counts_of(const std::vector<StoredQuery>& queries) {
  std::vector<PartCount> counts;
  for (const StoredQuery& query : queries) {
    auto count = std::ranges::find_if(counts, [&](const PartCount& other) {
      return other.predicate == query.predicate && other.entry == query.entry;
    });
    if (count == counts.end()) count = counts.insert(count, {query.predicate, query.entry, 0});
    ++count->queries;
  }
  return counts;
}

std::string part_text(const Predicate& predicate, std::size_t entry) {
  return entry == 0 ? std::string(predicate.id)
                    : fmt::format("{}, entry {}", predicate.id, predicate.entries[entry].name);
}

std::string parts_text(const std::vector<PartCount>& parts) {
  std::string text;
  for (const PartCount& part : parts) {
    const char* what = !text.empty() ? "" : part.queries == 1 ? " query" : " queries";
    text += fmt::format("{}{}{} of {}", text.empty() ? "" : ", ", part.queries, what,
                        part_text(*part.predicate, part.entry));
  }
  return text;
}

const std::string& standard_input() {
  static const std::string bytes = read_bytes(std::cin, "stdin");
  return bytes;
}

SourcePtr query_file_source(const std::string& path, Precision csv_precision, std::span<const Predicate* const> known) {
  const std::vector<SourcePtr> parts = query_file_sources(path, csv_precision, known);
  if (parts.size() == 1) return parts.front();
  throw Error(fmt::format("{}: it has {}, and here the queries of a file have one predicate and one entry",
                          path == "-" ? "stdin" : path, parts_text(counts_of(parts))));
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
  return std::make_shared<QueryFileSource>("corpus", FileInfo{folder, "corpus"}, lines, lines, queries);
}

}  // namespace axiscert
