#include "fuzz/queries/address.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <vector>

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
  throw Error(fmt::format("unknown precision '{}'; precisions: {}", given, fmt::join(precision_names, ", ")));
}

Address parse_address(std::string_view given) {
  const auto fail = [&](const std::string& what) {
    return Error(
        fmt::format("address '{}': {}; the form is SEED:NAME:VERSION:PRECISION:UNIT:INDEX, for instance "
                    "1:tangent:1:binary32:0:1234",
                    given, what));
  };
  const auto parts = split(given, ':');
  if (parts.size() != 6) throw fail(fmt::format("{} fields instead of 6", parts.size()));
  const auto number = [&](std::size_t i, const char* field) {
    std::uint64_t value = 0;
    const char* end = parts[i].data() + parts[i].size();
    const auto [stop, problem] = std::from_chars(parts[i].data(), end, value);
    if (problem != std::errc() || stop != end || parts[i].empty()) {
      throw fail(fmt::format("{} '{}' is not a number", field, parts[i]));
    }
    return value;
  };
  Address a{};
  a.seed = number(0, "seed");
  a.name = parts[1];
  a.version = static_cast<int>(number(2, "version"));
  try {
    a.precision = parse_precision(parts[3]);
  } catch (const Error& wrong) {
    throw fail(wrong.what());
  }
  a.unit = number(4, "unit");
  a.index = number(5, "index");
  if (a.index >= unit_size) throw fail(fmt::format("index {} is not below {}", a.index, unit_size));
  if (a.unit >= (std::uint64_t{1} << 47)) throw fail(fmt::format("unit {} is not below 2^47", a.unit));
  return a;
}

}  // namespace axiscert
