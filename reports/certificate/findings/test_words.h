// What reports say of one test alone, as its room in reports/ has it.
#pragma once

#include <span>
#include <string_view>

#include "kernel/test.h"
#include "reports/certificate/findings/situations.h"

namespace axiscert {

struct TestWords {
  // The part of the documents on what the test's built-in kernels answer.
  std::string_view section_of_forms = {};
  // The most everyday ones first; the last takes queries of no family, as those of a mesh are. None in a test whose
  // wrong verdicts have the class of their input instead.
  std::span<const Situation> situations = {};
};

// Of a test on the list of kernel/test_list.h: NAME_words() of its room.
const TestWords& test_words_of(const TestDescription& test);

}  // namespace axiscert
