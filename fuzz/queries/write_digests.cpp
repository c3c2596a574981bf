// Prints the content of fuzz/families/sphere_triangle/digests.txt: run it after raising a family's version.
#include <fmt/format.h>

#include "fuzz/queries/digest.h"

int main() {
  using namespace axiscert;
  for (const Family* family : families()) {
    for (const Precision precision : {Precision::binary32, Precision::binary64}) {
      fmt::print("{}\n", digest_line(*family, precision));
    }
  }
}
