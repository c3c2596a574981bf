// Stretches of a plan, run by the threads of this process.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "fuzz/campaign/parts/stretch.h"
#include "fuzz/campaign/progress.h"

namespace axiscert {

// Runs these stretches on the plan's threads and hands each to `done`, in any order, from this thread; begins no other
// once `interrupted`. Throws what judging throws.
void run_stretches(const Plan& plan, const Stretches& stretches, const std::vector<std::uint64_t>& numbers,
                   const std::atomic<bool>& interrupted, const ShowProgress& show,
                   const std::function<void(const Entry&)>& done);

}  // namespace axiscert
