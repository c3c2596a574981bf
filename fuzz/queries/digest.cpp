#include "fuzz/queries/digest.h"

#include <fmt/format.h>

#include <bit>
#include <vector>

#include "kernel/base/sha256.h"

namespace axiscert {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class Real>
std::string digest(const Family& family) {
  std::vector<Real> numbers;
  const auto add = [&](std::uint64_t position) {
    const Numbers<Real> query = family.make<Real>(1, position);
    numbers.insert(numbers.end(), query.begin(), query.end());
  };
  for (std::uint64_t position = 0; position < 4096; ++position) add(position);
  for (std::uint64_t unit = 1; unit <= 64; ++unit) add(unit << 16);
  return sha256_hex(std::as_bytes(std::span(numbers)));
}

}  // namespace

std::string family_digest(const Family& family, Precision precision) {
  switch (precision) {
    case Precision::binary32:
      return digest<float>(family);
    case Precision::binary64:
      return digest<double>(family);
  }
  return {};
}

std::string digest_line(const Family& family, Precision precision) {
  return fmt::format("{} {} {} {}", family.name, family.version, name(precision), family_digest(family, precision));
}

std::vector<std::string> digest_lines(const Predicate& predicate) {
  std::vector<std::string> lines;
  for (const Family* family : all_families_of(predicate)) {
    for (const Precision precision : {Precision::binary32, Precision::binary64}) {
      lines.push_back(digest_line(*family, precision));
    }
  }
  return lines;
}

}  // namespace axiscert
