// Prints the digests of the families of each predicate that is named: the content of the digests.txt beside their list.
// Run it after raising a family's version.
#include <fmt/format.h>

#include "fuzz/queries/digest.h"
#include "kernel/base/error.h"

int main(int count, char** words) {
  using namespace axiscert;
  try {
    if (count < 2) throw Error("name the predicates whose digests are to be printed, as sphere-triangle");
    for (int i = 1; i < count; ++i) {
      for (const std::string& line : digest_lines(find_predicate(words[i]))) fmt::print("{}\n", line);
    }
  } catch (const Error& wrong) {
    fmt::print(stderr, "write_digests: {}\n", wrong.what());
    return 2;
  }
}
