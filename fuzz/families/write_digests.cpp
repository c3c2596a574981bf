// Prints the digests of the families of each test that is named, or of the first where none is: the content of the
// digests.txt beside their list. Run it after raising a family's version.
#include <fmt/format.h>

#include "fuzz/queries/digest.h"
#include "kernel/base/error.h"

int main(int count, char** words) {
  using namespace axiscert;
  try {
    std::vector<const TestDescription*> named;
    for (int i = 1; i < count; ++i) named.push_back(&find_test(words[i]));
    if (named.empty()) named.push_back(&first_test());
    for (const TestDescription* test : named) {
      for (const std::string& line : digest_lines(*test)) fmt::print("{}\n", line);
    }
  } catch (const Error& wrong) {
    fmt::print(stderr, "write_digests: {}\n", wrong.what());
    return 2;
  }
}
