// The report of `axiscert league`: kernels and libraries side by side on the same queries, and kernels with a fault.
#pragma once

#include <map>

#include "fuzz/campaign/campaign.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

struct League {
  Questions questions;
  std::vector<const Kernel*> kernels;
  std::size_t contenders = 0;  // the first so many of the kernels compete; the others have a planted fault
  // Nanoseconds for each query, by precision and number of the kernel; absent where no time was taken.
  std::map<std::pair<Precision, std::size_t>, double> nanoseconds;
  std::vector<std::string> not_checked;  // one sentence each
};

// Each contender and precision with no decided query, with its counts: of these nothing was looked at.
std::vector<std::string> undecided_contenders(const League& league, const CampaignResult& result);

InstrumentReport league_report(const League& league, const CampaignResult& result, const std::string& command);

}  // namespace axiscert
