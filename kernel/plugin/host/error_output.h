// Standard error of a program, of which the end is kept.
#pragma once

#include <span>
#include <string>

namespace axiscert::plugin {

// The end of what a program says on standard error: its last few thousand bytes, however many there are.
class ErrorOutput {
 public:
  void add(std::span<const char> bytes);
  void clear() { kept_.clear(); }
  // The last line that says something: not a place in a stack, nor the interpreter's version. Empty where there is
  // none.
  std::string last_line() const;

 private:
  std::string kept_;
};

}  // namespace axiscert::plugin
