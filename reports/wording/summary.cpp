#include "reports/wording/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

// Members that are maxima over queries; every other number is a count.
const std::set<std::string, std::less<>> maxima = {"deepest",
                                                   "deepest_false_separation",
                                                   "deepest_false_contact",
                                                   "max_error_u",
                                                   "smallest_passing_tolerance",
                                                   "largest_ulps",
                                                   "largest_in_u",
                                                   "deepest_tunnel",
                                                   "largest_gap",
                                                   "largest_angle",
                                                   "largest_error"};

// The six digits of a text of a number too large for binary64 are kept by the logarithm.
double magnitude(const Json& number) {
  if (number.is_number()) return std::log10(number.get<double>());
  const auto& text = number.get_ref<const std::string&>();
  const std::size_t e = text.find('e');
  double mantissa = 0, exponent = 0;
  std::from_chars(text.data(), text.data() + e, mantissa);
  std::from_chars(text.data() + e + 2, text.data() + text.size(), exponent);
  return exponent + std::log10(mantissa);
}

void merge(Json& total, const Json& part, const std::string& name) {
  if (part.is_null()) return;
  if (total.is_null()) {
    total = part;
  } else if (part.is_object()) {
    for (const auto& [member, value] : part.items()) merge(total[member], value, member);
  } else if (part.is_boolean()) {
    total = total.get<bool>() && part.get<bool>();
  } else if (maxima.count(name) != 0) {
    if (is_less(total, part)) total = part;
  } else {
    total = total.get<std::uint64_t>() + part.get<std::uint64_t>();
  }
}

// Number of queries that can count as a failure: valid, and within the kernel's limits.
std::uint64_t valid_queries(const Json& family) {
  const Json& outside = family["verdict"]["outside_limits"];
  return family["trials"].get<std::uint64_t>() - family["truth"]["invalid"].get<std::uint64_t>() -
         (outside.is_null() ? 0 : outside["trials"].get<std::uint64_t>());
}

}  // namespace

const EnumArray<Link, std::string_view> link_meanings = {
    "The formulae are wrong even in exact arithmetic: no precision mends it.",
    "Rounding each operation to the precision changed the answer, exponents unlimited.",
    "Overflow or underflow changed the answer: with unlimited exponents it would not have.",
    "The kernel differs from the scalar reference of its own formulae and order of operations.",
    "The kernel has no reference to compare it with: which link its own arithmetic breaks between the exact formulae, "
    "or "
    "the truth where it claims none, and its answer is not known."};

bool is_less(const Json& x, const Json& y) {
  if (x.is_number() && y.is_number()) return x.get<double>() < y.get<double>();
  return magnitude(x) < magnitude(y);
}

void add_counts(Json& total, const Json& part) { merge(total, part, ""); }

Json all_families(const Json& kernel) {
  Json total;
  for (Json family : kernel["families"]) {
    for (const char* median : {"median_ulps", "signed_median_ulps"}) family["critical_radius"].erase(median);
    family["verdict"].erase("first_by_link");  // places in a family cannot be added up
    family.erase("asymmetry");                 // exist for a few families only
    family.erase("invariance");
    family.erase("classes");  // added up in reports/wording/classes.cpp
    merge(total, family, "");
  }
  if (total.is_null()) return Json::object();
  total["critical_radius"] = kernel["critical_radius"];
  return total;
}

double per_million(std::uint64_t count, const Json& family) {
  const std::uint64_t n = valid_queries(family);
  return n == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(n);
}

std::string plain_text(const Json& value) {
  return value.is_null() ? "-" : value.is_string() ? value.get<std::string>() : value.dump();
}

std::string thousands(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3)
    text.insert(static_cast<std::size_t>(i), 1, ',');
  return text;
}

std::string share_rounded_down(std::uint64_t part, std::uint64_t of) {
  if (part == 0) return "none";
  const auto tenths = static_cast<std::uint64_t>(1000 * static_cast<long double>(part) / static_cast<long double>(of));
  if (tenths == 0) return "less than 0.1 %";
  return tenths % 10 == 0 ? fmt::format("{} %", tenths / 10) : fmt::format("{}.{} %", tenths / 10, tenths % 10);
}

std::vector<std::string> no_verdict_words(const NoVerdict& counts, std::string_view declined) {
  std::vector<std::string> words;
  const auto add = [&](std::uint64_t count, std::string_view what) {
    if (count != 0) words.push_back(fmt::format("{} {}", thousands(count), what));
  };
  add(counts.declined, declined);
  add(counts.invalid, "called invalid");
  add(counts.unanswered, "without an answer");
  return words;
}

std::string amount(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (value < 1000 || value >= 1e15) return text;
  double rounded = 0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  const std::size_t point = text.find('e') == text.npos ? text.find('.') : text.npos;
  return thousands(static_cast<std::uint64_t>(rounded)) + (point == text.npos ? "" : text.substr(point));
}

std::string error_amount(const Json& error) {
  if (error.is_null()) return "not measured";
  return error.is_number() ? amount(error.get<double>()) : error.get<std::string>();
}

std::string touching_text(const Json& kernel) {
  if (kernel["touching"] == name(Touching::separated)) return "a touching sphere is separated";
  if (kernel["touching"] == name(Touching::either)) return "a touching sphere may be called either";
  return "a touching sphere is in contact";
}

namespace {

// The part of its promise about motions that the kernel leaves out.
void add_policy(const Json& kernel, std::vector<std::string>& parts) {
  const auto policy = kernel.find("motion");
  if (policy == kernel.end()) return;
  if ((*policy)["start"] == "ignored") parts.emplace_back("no contact before the motion");
  if ((*policy)["start"] == "approaching") parts.emplace_back("no contact before a motion that does not approach");
  if ((*policy)["still"] == "ignored") parts.emplace_back("a displacement that is not zero");
  if ((*policy)["sides"] == "front") parts.emplace_back("triangles met from the front");
}

}  // namespace

std::string limits_text(const Json& kernel) {
  if (!has_limits(kernel)) return "none: it promises to be right everywhere";
  std::vector<std::string> parts;
  add_policy(kernel, parts);
  const Json& limits = kernel["limits"];
  if (limits.is_null()) return fmt::format("{}", fmt::join(parts, ", "));
  const auto range = [&](const std::string& what, const Json& least, const Json& greatest) {
    std::string part = what;
    if (!least.is_null()) part += fmt::format(" from {:.6g}", least.get<double>());
    if (!greatest.is_null()) part += fmt::format(" to {:.6g}", greatest.get<double>());
    if (part != what) parts.push_back(part);
  };
  range("|coordinates|", limits["least_coordinate"], limits["greatest_coordinate"]);
  range("area", limits["least_area"], nullptr);
  range("radius", limits["least_radius"], limits["greatest_radius"]);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<const Json*> worst_witnesses(const Json& record, std::size_t limit) {
  std::vector<const Json*> witnesses;
  for (const Json& witness : record["witnesses"]) witnesses.push_back(&witness);
  const auto depth = [](const Json* w) { return (*w)["depth"].is_null() ? -1.0 : (*w)["depth"].get<double>(); };
  const auto deeper = [&](const Json* x, const Json* y) { return depth(x) > depth(y); };
  std::stable_sort(witnesses.begin(), witnesses.end(), deeper);

  std::map<std::string, std::size_t> seen;  // by kernel, precision, family and kind
  std::map<const Json*, std::size_t> rank;
  for (const Json* w : witnesses) {
    Json group = Json::array({(*w)["kernel"], (*w)["precision"], (*w)["family"]});
    for (const Json& flip : (*w)["flips"]) {
      if (flip["level"] == "verdict") group.push_back(flip["kind"]);
    }
    rank[w] = seen[group.dump()]++;
  }
  std::stable_sort(witnesses.begin(), witnesses.end(), [&](const Json* x, const Json* y) { return rank[x] < rank[y]; });
  witnesses.resize(std::min(limit, witnesses.size()));
  std::stable_sort(witnesses.begin(), witnesses.end(), deeper);
  return witnesses;
}

}  // namespace axiscert
