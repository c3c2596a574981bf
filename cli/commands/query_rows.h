// The rows of `axiscert check` for a range of queries: one for each query and kernel, made as they are read.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/examine.h"
#include "plans/given_queries.h"
#include "reports/instrument/data.h"
#include "reports/instrument/query_data.h"

namespace axiscert {

// How often a kernel had which standing (cli/commands/check_output.h).
using StandingCounts = std::map<std::string_view, std::size_t>;

class QueryRows {
 public:
  // `format` is csv or jsonl. The kernels exist in the precision of the range, and take its queries.
  QueryRows(const QueryRange& range, const std::vector<const Kernel*>& kernels, const std::string& target,
            const std::string& format);
  QueryRows(const QueryRows&) = delete;
  QueryRows& operator=(const QueryRows&) = delete;

  std::uint64_t size() const { return range_.size * examiners_.size(); }
  // About how long all of them are, by the numbers of the first queries: nothing is judged.
  std::uint64_t bytes() const;
  // The line of names, of CSV.
  std::string head() const;
  // The rows of the next queries, at most `most` of them; empty: there are none. Throws OracleDisagreement.
  std::string next(std::uint64_t most);
  // Counts of the rows so far, by kernel.
  const std::vector<StandingCounts>& standings() const { return standings_; }

 private:
  template <class Real>
  std::string rows(std::uint64_t first, std::uint64_t count);
  template <class Real>
  std::uint64_t stand_in_bytes() const;
  template <class Real>
  QueryRow row_of(std::uint64_t position, const Numbers<Real>& numbers) const;
  std::string line(const QueryRow& row) const;

  const QueryRange& range_;
  const Predicate& predicate_;
  const Oracles& oracles_;
  const std::string target_;
  const bool is_csv_;
  const DataColumns columns_;
  std::deque<Examiner> examiners_;
  std::vector<StandingCounts> standings_;
  std::uint64_t done_ = 0;
};

}  // namespace axiscert
