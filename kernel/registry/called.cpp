#include "kernel/registry/called.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "kernel/base/error.h"
#include "kernel/plugin/load.h"

namespace axiscert {
namespace {

std::vector<std::string_view> split(std::string_view words) {
  std::vector<std::string_view> all;
  for (std::size_t comma; (comma = words.find(',')) != words.npos; words.remove_prefix(comma + 1)) {
    all.push_back(words.substr(0, comma));
  }
  all.push_back(words);
  return all;
}

std::string known_words() {
  std::vector<std::string_view> modes;
  for (const CallMode& mode : call_modes()) modes.push_back(mode.name);
  return fmt::format("instruction sets here: {}; modes: {}", fmt::join(available_targets(), ", "),
                     fmt::join(modes, ", "));
}

// The words that may have been meant, before known_words.
std::string guess(std::string_view word, const std::vector<std::string>& targets) {
  std::vector<std::string_view> known(targets.begin(), targets.end());
  for (const CallMode& mode : call_modes()) known.push_back(mode.name);
  return did_you_mean(word, known);
}

// The call that "WORD,WORD" describes. Throws Error with a message that begins with `id`.
Call parsed(std::string_view words, const std::string& id) {
  const auto refuse = [&](const std::string& why) { throw Error(fmt::format("kernel '{}': {}", id, why)); };
  const std::vector<std::string> targets = available_targets();
  Call call;
  for (const std::string_view word : split(words)) {
    const auto is_word = [&](std::string_view known) { return same_letters(known, word); };
    const auto target = std::ranges::find_if(targets, is_word);
    const auto mode = std::ranges::find_if(call_modes(), is_word, &CallMode::name);
    const auto set = [&](auto& value, const auto& unset, const auto& asked, const char* what) {
      if (value == asked) refuse(fmt::format("'{}' appears twice", word));
      if (value != unset) refuse(fmt::format("two {}; a kernel is called with one", what));
      value = asked;
    };
    if (target != targets.end()) set(call.target, "", *target, "instruction sets");
    else if (word.empty()) refuse(fmt::format("a word is missing after '@' or ','; {}", known_words()));
    else if (mode == call_modes().end())
      refuse(
          fmt::format("after '@', '{}' is not a way to call a kernel{} {}", word, guess(word, targets), known_words()));
    else if (mode->flush) set(call.flush, false, true, "");
    else set(call.rounding, Rounding::nearest, mode->rounding, "directions of rounding");
  }
  return call;
}

std::vector<std::string_view> words_of(const Call& call) {
  std::vector<std::string_view> words;
  if (!call.target.empty()) words.emplace_back(call.target);
  for (const CallMode& mode : call_modes()) {
    if (mode.flush ? call.flush : call.rounding == mode.rounding) words.push_back(mode.name);
  }
  return words;
}

// The function is called through a pointer, so that the compiler cannot move any of its operations out of the scope.
template <class... Arguments>
std::function<void(Arguments...)> in_modes(const std::function<void(Arguments...)>& function, const Call& call) {
  if (!function) return {};
  return [function, rounding = call.rounding, flush = call.flush](Arguments... arguments) {
    const FloatingEnvironment callers(rounding, flush);
    function(arguments...);
  };
}

template <class Real>
using On = std::function<Implementation<Real>(std::string_view target)>;

// An empty function stays empty.
template <class Real>
On<Real> on_call(const On<Real>& on, const Call& call) {
  if (!on) return {};
  return [=](std::string_view target) {
    Implementation<Real> implementation = on(call.target.empty() ? target : call.target);
    if (!call.has_modes()) return implementation;
    implementation.verdicts = in_modes(implementation.verdicts, call);
    implementation.explain = in_modes(implementation.explain, call);
    implementation.measure = in_modes(implementation.measure, call);
    implementation.bits = in_modes(implementation.bits, call);
    return implementation;
  };
}

}  // namespace

const std::vector<CallMode>& call_modes() {
  static const std::vector<CallMode> all = {
      {"upward", "the caller rounds toward +infinity", Rounding::upward, false},
      {"downward", "the caller rounds toward -infinity", Rounding::downward, false},
      {"toward-zero", "the caller rounds toward zero", Rounding::toward_zero, false},
      {"flushed", "subnormal results and operands are zero for the caller (FTZ and DAZ)", Rounding::nearest, true},
  };
  return all;
}

Kernel called(const Kernel& kernel, std::string_view words) {
  const std::string given = fmt::format("{}@{}", kernel.id, words);
  const Call call = parsed(words, given);
  if (!kernel.has_simd && !call.target.empty() && call.target != scalar_target) {
    throw Error(fmt::format("kernel '{}': {} has the same instructions on every target; call it on {}", given,
                            kernel.id, scalar_target));
  }
  Kernel as_called = kernel;
  as_called.id = fmt::format("{}@{}", kernel.id, fmt::join(words_of(call), ","));
  as_called.summary = fmt::format("{}; called: {}", kernel.summary, fmt::join(words_of(call), ", "));
  as_called.binary32 = on_call(kernel.binary32, call);
  as_called.binary64 = on_call(kernel.binary64, call);
  as_called.call = call;
  as_called.has_simd = kernel.has_simd && call.target.empty();
  as_called.is_reference = kernel.is_reference && !call.has_modes();
  as_called.takes_arithmetic = false;
  return as_called;
}

std::optional<std::size_t> call_in(std::string_view id) {
  std::size_t at = id.find('@');
  if (plugin::is_given_by_file(id)) {
    const auto is_file = [](std::string_view plugin) {
      return std::filesystem::is_regular_file(*plugin::plugin_path(plugin));
    };
    at = is_file(id) ? id.npos : id.rfind('@');
    if (at != id.npos && !is_file(id.substr(0, at))) at = id.npos;
  }
  return at == id.npos ? std::nullopt : std::optional(at);
}

}  // namespace axiscert
