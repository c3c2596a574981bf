// What is said beside a result: the notices while a plan is made, on standard error or as whoever asks has it; and
// before anything else that a kernel is not fit to be asked.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

using TakeNotice = std::function<void(const std::string& line)>;

// From here on `take` is given each line, in the thread that makes the plan; before, it is printed on standard error
// after "axiscert: ". An empty one prints again. Set while no plan is made.
void set_notices(TakeNotice take);

void take_notice(const std::string& line);
template <class... Args>
void notice(fmt::format_string<Args...> format, Args&&... args) {
  take_notice(fmt::format(format, std::forward<Args>(args)...));
}

// Looks at each kernel of a user's file, and prints on standard error what is wrong at first sight: a line, before
// anything else is printed. The command goes on, and says what comes of it.
void print_first_look(const std::vector<const Kernel*>& kernels);
void print_first_look(const Kernel& kernel);

}  // namespace axiscert
