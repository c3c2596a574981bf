#include "reports/certificate/canonical.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::size_t most_levels = 32;

void put_canonical(std::string& text, const Json& value) {
  if (value.is_number_float())
    throw HarnessFault(fmt::format("{} is no whole number: a certificate has none", value.dump()));
  if (value.is_array()) {
    text += '[';
    for (const Json& element : value) {
      if (text.back() != '[') text += ',';
      put_canonical(text, element);
    }
    text += ']';
  } else if (value.is_object()) {
    std::vector<std::pair<std::string_view, const Json*>> members;
    for (const auto& [name, member] : value.items()) members.emplace_back(name, &member);
    std::sort(members.begin(), members.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    text += '{';
    for (const auto& [name, member] : members) {
      if (text.back() != '{') text += ',';
      text += Json(name).dump() + ':';
      put_canonical(text, *member);
    }
    text += '}';
  } else {
    text += value.dump();
  }
}

// Takes the events of the parser, and refuses what the library would let pass. It keeps the names of the objects that
// are open.
class StrictReader {
 public:
  bool operator()(int depth, Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    // The library counts the levels around what begins, without itself.
    const bool begins = event == Event::object_start || event == Event::array_start;
    if (begins && static_cast<std::size_t>(depth) >= most_levels)
      throw Error(fmt::format("has more than {} levels", most_levels));
    if (event == Event::object_start) names_.emplace_back();
    if (event == Event::object_end) names_.pop_back();
    if (event == Event::key && !names_.back().insert(value.get_ref<const std::string&>()).second)
      throw Error(fmt::format("the member {} occurs twice", shown(value.dump())));
    if (event == Event::value && value.is_number_float())
      throw Error("has a number that is no whole one of 64 bits; figures are decimal texts");
    return true;
  }

 private:
  std::vector<std::set<std::string>> names_;
};

}  // namespace

NotValid::NotValid(const std::string& message) : std::runtime_error(printable_line(message)) {}

std::string canonical_json(const Json& value) {
  std::string text;
  put_canonical(text, value);
  return text;
}

Json strict_json(std::string_view bytes, const std::string& name, std::size_t most) {
  if (bytes.size() > most)
    throw Error(fmt::format("{}: {} bytes; a certificate has at most {}", name, bytes.size(), most));
  try {
    return Json::parse(bytes, StrictReader());
  } catch (const Json::parse_error& wrong) {
    const bool is_cut = wrong.byte > bytes.size();  // found where there was no more
    throw Error(is_cut
                    ? fmt::format("{}: it ends in the middle, after {} bytes: the file is cut off", name, bytes.size())
                    : fmt::format("{}: byte {} is not JSON", name, wrong.byte));
  } catch (const Json::exception& wrong) {
    throw Error(fmt::format("{}: is not JSON: {}", name, wrong.what()));
  } catch (const Error& wrong) {
    throw Error(fmt::format("{}: {}", name, wrong.what()));
  }
}

}  // namespace axiscert
