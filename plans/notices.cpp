#include "plans/notices.h"

#include <cstdio>

namespace axiscert {
namespace {

TakeNotice& taker() {
  static TakeNotice take;
  return take;
}

}  // namespace

void set_notices(TakeNotice take) { taker() = std::move(take); }

void take_notice(const std::string& line) {
  if (taker()) taker()(line);
  else fmt::print(stderr, "axiscert: {}\n", line);
}

}  // namespace axiscert
