#include "cli/commands/query_rows.h"

#include <algorithm>

#include "cli/commands/check_output.h"
#include "fuzz/confirm/witness.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "fuzz/files/query_object.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/text/number_text.h"

namespace axiscert {
namespace {

// The length of a row is foretold by this many queries.
constexpr std::uint64_t foretold_queries = 16;
// The detail that is the nearest features, as a motion's first are named.
constexpr std::string_view features_name = "features";
// A depth and the text of a number, both of usual length.
constexpr double stand_in_depth = 0.12345678901234567;
constexpr std::string_view stand_in_text = "0x1.234567p-12";
constexpr double stand_in_number = 0x1.234567p-12;

// Every number that can be judged beside a verdict of the predicate.
MeasuresRecord stand_in_measures(const Predicate& predicate, std::size_t measure_count) {
  Examination found;
  found.answer.verdict = Verdict::contact;
  found.measures.assign(measure_count, stand_in_number);
  ContactJudgement& judged = found.contact.emplace();
  judged.share = judged.length = judged.gap = stand_in_depth;
  judged.feature_is_right = true;
  judged.feature_error = judged.normal_angle = judged.normal_length_error = judged.point_error = stand_in_depth;
  if (is_of_motions(predicate)) judged.time = TimeVerdict::early;
  else judged.separation = SeparationError{{}, {}, stand_in_depth, stand_in_depth};
  return *measures_of(predicate, found);
}

// The columns of the measures that a query of the predicate can have.
DataColumns measure_columns(const Predicate& predicate) {
  DataColumns columns;
  if (predicate.measures.empty()) return columns;
  const Json members = json_of(stand_in_measures(predicate, predicate.measures.size()));
  for (const auto& [member, value] : members.items()) columns.push_back("measures." + member);
  return columns;
}

// The columns of an entry: those of QueryRow, less what no query of the predicate has, and those whose names the
// predicate gives.
DataColumns row_columns(const Predicate& predicate, std::size_t entry) {
  DataColumns columns = {"address"};
  for (const ColumnGroup& group : groups_of(predicate.entries[entry])) columns.emplace_back(group.name);
  columns = with_columns_of<QueryRow>(std::move(columns));
  const bool has_classes = capabilities_of(predicate).input_classes != nullptr;
  const DataColumns of_measures = measure_columns(predicate);
  std::erase_if(columns, [&](const std::string& column) {
    const bool is_of_file = column == "schema" || column == "axiscert" || column == "revision";
    return is_of_file || (!has_classes && column == "exact.class") ||
           (column.starts_with("measures.") && std::ranges::find(of_measures, column) == of_measures.end());
  });
  if (capabilities_of(predicate).nearest_features != nullptr) columns.push_back("exact." + std::string(features_name));
  for (const std::string_view detail : oracles_of(predicate, entry).detail_names())
    columns.push_back("exact." + std::string(detail));
  for (const PredicateMeasure& measure : predicate.measures)
    columns.push_back("measures.given." + std::string(measure.name));
  return columns;
}

std::optional<BitText> bit_text(const std::optional<ComparisonBits>& bits, const Predicate& predicate) {
  if (!bits || predicate.comparisons.empty()) return std::nullopt;
  return BitText(bit_string(*bits, predicate.comparisons.size()));
}

}  // namespace

QueryRows::QueryRows(const QueryRange& range, const std::vector<const Kernel*>& kernels, const std::string& target,
                     const std::string& format)
    : range_(range),
      predicate_(range.source->predicate()),
      oracles_(oracles_of(predicate_, range.source->entry())),
      target_(target),
      is_csv_(format == "csv"),
      columns_(row_columns(predicate_, range.source->entry())),
      standings_(kernels.size()) {
  for (const Kernel* kernel : kernels) examiners_.emplace_back(*kernel, target_);
}

std::string QueryRows::line(const QueryRow& row) const {
  const Json json = json_of(row);
  return is_csv_ ? csv_line(columns_, json) : json.dump() + "\n";
}

std::string QueryRows::head() const { return is_csv_ ? csv_head(columns_) : ""; }

// The columns that every row of a query has, whatever is asked.
template <class Real>
QueryRow QueryRows::row_of(std::uint64_t position, const Numbers<Real>& numbers) const {
  QueryRow row;
  row.address = SeededSource{*range_.source, range_.first.seed, range_.first.precision}.address(position);
  row.numbers = groups_of_numbers(predicate_.entries[range_.source->entry()], numbers);
  return row;
}

template <class Real>
std::uint64_t QueryRows::stand_in_bytes() const {
  const std::uint64_t count = std::min(range_.size, foretold_queries);
  std::uint64_t bytes = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t position = range_.first.position() + i;
    QueryRow row = row_of(position, range_.source->make<Real>(range_.first.seed, position));
    row.standing = "decided";
    row.exact.depth = stand_in_depth;
    row.exact.comparisons = row.computed.comparisons = bit_text(0, predicate_);
    for (const std::string_view detail : oracles_.detail_names()) row.exact.details.put(detail) = stand_in_text;
    if (capabilities_of(predicate_).nearest_features != nullptr) row.exact.details.put(features_name) = stand_in_text;
    for (const Examiner& examiner : examiners_) {
      row.kernel = examiner.kernel().id;
      // Those of every other query, as if half of them had contact.
      const std::size_t count = examiner.kernel().measure_count;
      row.measures = std::nullopt;
      if (says_contacts(examiner.kernel())) row.measures.emplace();
      if (count != 0 && i % 2 == 0) row.measures->emplace(stand_in_measures(predicate_, count));
      bytes += line(row).size();
    }
  }
  return bytes * range_.size / count;
}

std::uint64_t QueryRows::bytes() const {
  const bool is_single = range_.first.precision == Precision::binary32;
  return head().size() + (is_single ? stand_in_bytes<float>() : stand_in_bytes<double>());
}

std::string QueryRows::next(std::uint64_t most) {
  const std::uint64_t first = range_.first.position() + done_, count = std::min(most, range_.size - done_);
  done_ += count;
  if (count == 0) return "";
  return range_.first.precision == Precision::binary32 ? rows<float>(first, count) : rows<double>(first, count);
}

template <class Real>
std::string QueryRows::rows(std::uint64_t first, std::uint64_t count) {
  const InputClasses* const classes = capabilities_of(predicate_).input_classes;
  const NearestFeatures* const features = capabilities_of(predicate_).nearest_features;
  QueryBatch<Real> queries(static_cast<std::size_t>(count), range_.source->columns().size());
  range_.source->fill(range_.first.seed, first, static_cast<std::size_t>(count), queries);
  std::string text;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Numbers<Real> numbers = queries[i];
    QueryRow row = row_of(first + i, numbers);
    if (oracles_.is_valid(numbers)) {
      if (oracles_.has_depth()) row.exact.depth = oracles_.depth(numbers);
      if (classes != nullptr) row.exact.input_class = Name(classes->of(numbers).front());
      if (features != nullptr) row.exact.details.put(features_name) = features->of(numbers);
      for (const Detail& detail : oracles_.details(numbers)) row.exact.details.put(detail.name) = detail_json(detail);
    }
    for (std::size_t k = 0; k < examiners_.size(); ++k) {
      const Kernel& kernel = examiners_[k].kernel();
      const Examination found = examiners_[k].examine(numbers);
      const std::string_view standing =
          standing_of(kernel, found.truth.verdict, found.is_promised, found.answer.verdict);
      ++standings_[k][standing];
      row.kernel = kernel.id;
      row.standing = standing;
      row.wrong = found.judgement.verdict_flip.has_value();
      row.links.clear();
      for (const Link link : enumerators<Link>) {
        if (row.wrong && found.judgement.verdict_links.contains(link)) row.links.push_back(link);
      }
      row.exact.verdict = found.truth.verdict;
      row.exact.touching = found.truth.touching;
      row.exact.comparisons = bit_text(found.exact ? std::optional(found.exact->holds) : std::nullopt, predicate_);
      row.computed = {found.answer.verdict, bit_text(found.answer.bits, predicate_)};
      row.findings.clear();
      for (const Finding& finding : found.findings) row.findings.push_back(finding.kind);
      row.measures = std::nullopt;
      if (says_contacts(kernel)) row.measures.emplace(measures_of(predicate_, found));
      text += line(row);
    }
  }
  return text;
}

}  // namespace axiscert
