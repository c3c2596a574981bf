// What is said beside a result while a plan is made: on standard error, or as whoever asks has it.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <utility>

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

}  // namespace axiscert
