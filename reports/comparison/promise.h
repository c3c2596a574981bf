// A kernel's promise in one precision, which is part of the kernel. Who promises less than before is worse by that
// alone, and figures over two promises are not figures over the same queries.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/record/kernel_record.h"
#include "kernel/kernel.h"

namespace axiscert {

struct Promise {
  TouchingPolicy touching = TouchingPolicy::contact;
  Limits limits = {};
  std::optional<MotionPolicy> motion = {};  // of a predicate of motions
  bool may_decline = false;
  bool operator==(const Promise&) const = default;
};

// That of a kernel of a record, and that of a kernel as it is loaded here.
Promise promise_in(const KernelRecord& entry);
Promise promise_of_kernel(const Kernel& kernel);

// How a promise differs from one before, a text for each part: "radius from 1e+30, was none".
struct PromiseChange {
  std::vector<std::string> less;   // parts that leave out more
  std::vector<std::string> other;  // parts that leave out less, or that mean another answer
  bool is_none() const { return less.empty() && other.empty(); }
  std::string text() const;  // of all parts
  AXISCERT_FIELDS(PromiseChange,
                  AXISCERT_FIELD(less, "Parts that leave out more, as text. An alarm where there is any.", "parts"),
                  AXISCERT_FIELD(other, "Parts that leave out less, or that mean another answer.", "parts"))
};
PromiseChange change_of(const Promise& before, const Promise& now);

// A kernel's promise in one precision, where it is another in NEW.
struct ComparedPromise {
  std::string kernel, precision;
  PromiseChange change;

  bool is_alarm() const { return !change.less.empty(); }
  // "K binary32 promises less: radius from 1e+30, was none", or "... promises other things: ...".
  std::string text() const;
  AXISCERT_FIELDS(ComparedPromise, AXISCERT_FIELD(kernel, "What both runs know it by."),
                  AXISCERT_FIELD(precision, "The precision."), inlined(&Of::change))
};

// The promise in words that a file can hold: "touching=contact", "radius>=1e+30", "start=reported",
// "may_decline". What it does not limit is not named, but for `touching` and the policies of
// a predicate of motions.
std::vector<std::string> words_of_promise(const Promise& promise);
// The same, read. Each word may stand once. Throws Error that names the word and says what would be right.
Promise promise_of_words(std::span<const std::string> words);

}  // namespace axiscert
