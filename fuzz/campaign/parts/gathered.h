// What is finished of a plan: merged, and which stretches it is.
#pragma once

#include "fuzz/campaign/parts/stretch.h"

namespace axiscert {

// What a journal keeps of a stretch that was handed out, so that one that never came back is known.
std::string begun_note(std::uint64_t stretch);
// The finished stretch that a journal's entry is; none where it is such a note. Throws Error.
std::optional<Entry> finished_in(std::string_view content);

class Gathered {
 public:
  Gathered(const Plan& plan, const Stretches& stretches);

  // The content of a journal's entry. Throws Error where its stretch is none of the plan, or is there already.
  void replay(std::string_view content);
  void add(const Entry& entry);
  bool has(std::uint64_t stretch) const { return is_done_[stretch]; }
  std::uint64_t stretches() const { return done_; }
  std::uint64_t units() const { return units_; }
  std::uint64_t queries() const { return queries_; }
  // Begun and not finished, by the journals: units lost when a process was.
  std::uint64_t lost_units() const;
  std::vector<std::uint64_t> missing() const;

  CampaignResult take() &&;  // `complete` where nothing is missing

 private:
  const Stretches& stretches_;
  CampaignResult result_;
  std::vector<bool> is_done_;
  std::vector<std::uint64_t> begun_;
  std::uint64_t done_ = 0, units_ = 0, queries_ = 0;
};

}  // namespace axiscert
