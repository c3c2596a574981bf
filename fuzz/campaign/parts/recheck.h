// Finished stretches that are done a second time, in another way, and have to give the same tallies.
#pragma once

#include <map>

#include "fuzz/campaign/parts/stretch.h"

namespace axiscert {

// This fraction of the numbers, chosen at random, in their order; at least one.
std::vector<std::uint64_t> sample_of(const std::vector<std::uint64_t>& numbers, double fraction, std::uint64_t seed);

class Recheck {
 public:
  Recheck(const std::vector<const Kernel*>& kernels, const Stretches& stretches,
          const std::vector<std::uint64_t>& sample);

  bool is_in(std::uint64_t stretch) const { return digests_.contains(stretch); }
  void add_first(const Entry& entry);
  // To be called after add_first() with the same stretch.
  void add_again(const Entry& entry);
  std::uint64_t compared() const { return compared_; }
  // Each message names units, kernel and digests.
  const std::vector<std::string>& differences() const { return differences_; }

 private:
  const std::vector<const Kernel*>& kernels_;
  const Stretches& stretches_;
  std::map<std::uint64_t, std::vector<std::string>> digests_;  // for each stretch, one per kernel
  std::uint64_t compared_ = 0;
  std::vector<std::string> differences_;
};

}  // namespace axiscert
