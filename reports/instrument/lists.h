// What `axiscert families`, `tests` and `kernels` list.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reports/instrument/data.h"

namespace axiscert {

struct ListedFamily {
  Name name, test;
  std::string purpose;
  std::uint64_t version = 0;
  bool exact_arithmetic = false;
  std::uint64_t cost = 1;

  static constexpr std::string_view about = "One generator of queries.";
  static constexpr auto fields(auto&& visit) {
    using Of = ListedFamily;
    return visit(
        field(&Of::name, {"name", "What --family takes."}), field(&Of::test, {"test", "The test of its queries."}),
        field(&Of::purpose, {"purpose", "What kind of queries it makes, and why."}),
        field(&Of::version, {"version", "Raised when its queries change; part of their addresses."}),
        field(&Of::exact_arithmetic,
              {"exact_arithmetic", "Whether formulae of degree 6 round nothing on its queries."}),
        field(&Of::cost, {"cost", "How many times as long as a query of `general` one of its queries takes."}));
  }
};

struct FamiliesData : DataHead<FamiliesData> {
  std::vector<ListedFamily> families;

  static constexpr std::string_view format = "axiscert-families/1", title = "The families",
                                    about = "`axiscert families --format json`. It depends on the version alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = FamiliesData;
    return visit(base<Of, DataHead<Of>>(), field(&Of::families, {"families", "Every family of the test."}));
  }
};

}  // namespace axiscert
