// Prints what belongs into fuzz/families/digests.txt: run it after raising a family's version.
#include <fmt/format.h>

#include "fuzz/digest.h"

int main() {
  using namespace axiscert;
  for (const Family* family : families()) {
    for (const Precision precision : {Precision::binary32, Precision::binary64}) {
      fmt::print("{}\n", digest_line(*family, precision));
    }
  }
}
