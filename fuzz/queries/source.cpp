#include "fuzz/queries/source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <limits>
#include <utility>
#include <vector>

#include "fuzz/queries/family.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

// An address that can be taken: that of a query of the first family.
std::string example() {
  const Family& family = *families().front();
  return text({1, std::string(family.name), family.version, Precision::binary32, 0, 1234});
}

[[noreturn]] void throw_misnamed_precision(std::string_view given, Precision precision) {
  throw Error(fmt::format("unknown precision '{}'; did you mean '{}'? precisions: {}", given, name(precision),
                          fmt::join(precision_names, ", ")));
}

}  // namespace

std::string text(const Address& a) {
  return fmt::format("{}:{}:{}:{}:{}:{}", a.seed, a.name, a.version, name(a.precision), a.unit, a.index);
}

Address address_of(const Source& source, std::uint64_t seed, Precision precision, std::uint64_t position) {
  return {seed, source.address_name(), source.version(), precision, position / unit_size, position % unit_size};
}

Precision parse_precision(std::string_view given) {
  for (const Precision p : {Precision::binary32, Precision::binary64}) {
    if (name(p) == given) return p;
  }
  // The names of the two elsewhere.
  for (const auto& [other, meant] : {std::pair<std::string_view, Precision>{"float", Precision::binary32},
                                     {"single", Precision::binary32},
                                     {"32", Precision::binary32},
                                     {"f32", Precision::binary32},
                                     {"float32", Precision::binary32},
                                     {"double", Precision::binary64},
                                     {"64", Precision::binary64},
                                     {"f64", Precision::binary64},
                                     {"float64", Precision::binary64}}) {
    if (other == given) throw_misnamed_precision(given, meant);
  }
  throw Error(unknown_name("precision", "precisions", given,
                           std::vector<std::string_view>(precision_names.begin(), precision_names.end())));
}

Address parse_address(std::string_view given) {
  const auto fail = [&](const std::string& what) {
    return Error(fmt::format("address '{}': {}; the form is SEED:NAME:VERSION:PRECISION:UNIT:INDEX, for instance {}",
                             given, what, example()));
  };
  const auto parts = split(given, ':');
  if (given.size() > 1 && given.find_first_not_of("0123456789", 1) == given.npos && given.front() == 'w') {
    throw fail(
        fmt::format("is the id of a witness, whose query is a line of witnesses.jsonl in the folder of its run, "
                    "as in grep '\"{}\"' out/witnesses.jsonl",
                    given));
  }
  if (parts.size() != 6) throw fail(fmt::format("{} field{} instead of 6", parts.size(), parts.size() == 1 ? "" : "s"));
  const auto number = [&](std::size_t i, const char* field, std::uint64_t most) {
    std::uint64_t value = 0;
    const char* end = parts[i].data() + parts[i].size();
    const auto [stop, problem] = std::from_chars(parts[i].data(), end, value);
    const bool is_too_large = problem == std::errc::result_out_of_range;
    if (stop != end || (problem != std::errc() && !is_too_large)) {
      throw fail(fmt::format("{} '{}' is not a whole number >= 0", field, parts[i]));
    }
    if (is_too_large || value > most) throw fail(fmt::format("{} {} is too large: at most {}", field, parts[i], most));
    return value;
  };
  Address a{};
  a.seed = number(0, "seed", std::numeric_limits<std::uint64_t>::max());
  a.name = parts[1];
  a.version = static_cast<int>(number(2, "version", std::numeric_limits<int>::max()));
  try {
    a.precision = parse_precision(parts[3]);
  } catch (const Error& wrong) {
    throw fail(wrong.what());
  }
  a.unit = number(4, "unit", (std::uint64_t{1} << 47) - 1);
  a.index = number(5, "index", unit_size - 1);
  return a;
}

}  // namespace axiscert
