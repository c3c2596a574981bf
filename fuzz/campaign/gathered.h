// The finished part of a plan: merged results, and the stretches they come from.
#pragma once

#include <map>

#include "fuzz/campaign/stretch.h"

namespace axiscert {
// The journal's note that a stretch was handed out, so that a stretch that was never finished is known.
std::string begun_note(std::uint64_t stretch);
// The finished stretch in a journal's entry; empty if the entry is such a note. Throws Error.
std::optional<Entry> finished_in(std::string_view content);

class GatheredStretches {
 public:
  // The stretches of the questions, each answered by so many kernels.
  GatheredStretches(const Questions& questions, std::size_t kernels, const Stretches& stretches);

  // Takes the content of a journal's entry. Throws Error if its stretch is not part of the plan or is already finished.
  void replay(std::string_view content);
  void add(const Entry& entry);
  bool has(std::uint64_t stretch) const { return is_done_[stretch]; }
  std::uint64_t stretches() const { return done_; }
  std::uint64_t units() const { return units_; }
  std::uint64_t queries() const { return queries_; }
  // Units that were begun but not finished according to the journals: lost when a process died.
  std::uint64_t lost_units() const;
  std::vector<std::uint64_t> missing() const;

  CampaignResult take() &&;  // `complete` if nothing is missing

 private:
  const Predicate* predicate_;
  const Stretches& stretches_;
  CampaignResult result_;
  std::vector<bool> is_done_;
  std::vector<std::uint64_t> begun_;
  std::uint64_t done_ = 0, units_ = 0, queries_ = 0;
};

// Finished stretches that are done a second time, in another way, and have to give the same tallies.

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
