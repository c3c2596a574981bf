#include "kernel/plugin/host/error_output.h"

#include <string_view>

namespace axiscert::plugin {
namespace {

constexpr std::size_t kept_errors = std::size_t{1} << 14;  // bytes; a stack trace begins with what it is about

}  // namespace

void ErrorOutput::add(std::span<const char> bytes) {
  if (bytes.size() > kept_errors) bytes = bytes.last(kept_errors);
  kept_.append(bytes.data(), bytes.size());
  if (kept_.size() > 2 * kept_errors) kept_.erase(0, kept_.size() - kept_errors);
}

std::string ErrorOutput::last_line() const {
  const auto says_something = [](std::string_view line) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    return !line.empty() && line.front() != ' ' && line.front() != '\t' && line.find_first_of(letters) != line.npos &&
           !line.starts_with("Node.js v");
  };
  std::string_view rest = kept_;
  while (!rest.empty()) {
    const std::size_t end = rest.rfind('\n');
    const std::string_view line = end == rest.npos ? rest : rest.substr(end + 1);
    constexpr std::size_t longest = 300;
    if (says_something(line)) return std::string(line.substr(0, longest));
    rest = end == rest.npos ? std::string_view() : rest.substr(0, end);
  }
  return "";
}

}  // namespace axiscert::plugin
