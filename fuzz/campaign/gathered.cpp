#include "fuzz/campaign/gathered.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/kernel.h"

namespace axiscert {
// A begun note is a CBOR number; a finished stretch is an array.
std::string begun_note(std::uint64_t stretch) {
  std::string bytes;
  nlohmann::json::to_cbor(stretch, bytes);
  return bytes;
}

std::optional<Entry> finished_in(std::string_view content) {
  const nlohmann::json note = nlohmann::json::from_cbor(content, true, false);
  return note.is_number_unsigned() ? std::nullopt : std::optional(decode_entry(content));
}

GatheredStretches::GatheredStretches(const Questions& questions, std::size_t kernels, const Stretches& stretches)
    : predicate_(&questions.predicate()), stretches_(stretches), is_done_(stretches.count()) {
  result_.cells = cells_of(questions, kernels);
}

void GatheredStretches::replay(std::string_view content) {
  if (const auto entry = finished_in(content)) {
    add(*entry);
    return;
  }
  begun_.push_back(whole_number<std::uint64_t>(nlohmann::json::from_cbor(content)));
  if (begun_.back() >= stretches_.count()) throw Error(fmt::format("the plan has no stretch {}", begun_.back()));
}

void GatheredStretches::add(const Entry& entry) {
  if (entry.stretch >= stretches_.count()) throw Error(fmt::format("the plan has no stretch {}", entry.stretch));
  if (is_done_[entry.stretch]) throw Error(fmt::format("{}: already finished", stretches_.text(entry.stretch)));
  const Stretch stretch = stretches_.at(entry.stretch);
  CellResult& cell = result_.cells[stretch.cell];
  if (entry.tallies.size() != cell.tallies.size()) throw Error("a stretch with the tallies of other kernels");
  for (std::size_t k = 0; k < cell.tallies.size(); ++k)
    cell.tallies[k].merge(decode_tally(entry.tallies[k], *predicate_));
  const Costs costs = decode_costs(entry.costs);
  cell.steps.merge(costs.steps);
  cell.core_seconds += costs.core_seconds;
  cell.units_done += stretch.units();
  cell.queries += stretch.queries;
  result_.second_opinions += costs.second_opinions;
  is_done_[entry.stretch] = true;
  ++done_;
  units_ += stretch.units();
  queries_ += stretch.queries;
}

std::uint64_t GatheredStretches::lost_units() const {
  std::vector<std::uint64_t> times(stretches_.count());
  for (const std::uint64_t stretch : begun_) ++times[stretch];
  std::uint64_t lost = 0;
  for (std::uint64_t stretch = 0; stretch < times.size(); ++stretch) {
    if (times[stretch] > is_done_[stretch])
      lost += (times[stretch] - is_done_[stretch]) * stretches_.at(stretch).units();
  }
  return lost;
}

std::vector<std::uint64_t> GatheredStretches::missing() const {
  std::vector<std::uint64_t> missing;
  for (std::uint64_t stretch = 0; stretch < stretches_.count(); ++stretch) {
    if (!is_done_[stretch]) missing.push_back(stretch);
  }
  return missing;
}

CampaignResult GatheredStretches::take() && {
  result_.complete = done_ == stretches_.count();
  return std::move(result_);
}

namespace {

std::vector<std::string> digests_of(const Entry& entry) {
  std::vector<std::string> digests;
  for (const std::string& tally : entry.tallies) digests.push_back(sha256_hex(std::as_bytes(std::span(tally))));
  return digests;
}

}  // namespace

std::vector<std::uint64_t> sample_of(const std::vector<std::uint64_t>& numbers, double fraction, std::uint64_t seed) {
  const double wanted = std::ceil(fraction * static_cast<double>(numbers.size()));
  std::vector<std::uint64_t> sample;
  std::mt19937_64 random(seed);
  std::sample(numbers.begin(), numbers.end(), std::back_inserter(sample),
              std::max<std::int64_t>(1, std::lround(wanted)), random);
  return sample;
}

Recheck::Recheck(const std::vector<const Kernel*>& kernels, const Stretches& stretches,
                 const std::vector<std::uint64_t>& sample)
    : kernels_(kernels), stretches_(stretches) {
  for (const std::uint64_t stretch : sample) digests_[stretch];
}

void Recheck::add_first(const Entry& entry) { digests_[entry.stretch] = digests_of(entry); }

void Recheck::add_again(const Entry& entry) {
  const std::vector<std::string>& before = digests_.at(entry.stretch);
  const std::vector<std::string> now = digests_of(entry);
  for (std::size_t k = 0; k < kernels_.size(); ++k) {
    if (k < before.size() && k < now.size() && before[k] == now[k]) continue;
    differences_.push_back(fmt::format("kernel {} on {}: its tally had the digest {:.16}, but {:.16} when repeated",
                                       kernels_[k]->id, stretches_.text(entry.stretch),
                                       k < before.size() ? before[k] : "none", k < now.size() ? now[k] : "none"));
  }
  ++compared_;
}

}  // namespace axiscert
