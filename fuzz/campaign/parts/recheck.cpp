#include "fuzz/campaign/parts/recheck.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "kernel/base/sha256.h"
#include "kernel/kernel.h"

namespace axiscert {
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
