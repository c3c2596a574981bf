#include "reports/certificate/findings/test_words.h"

namespace axiscert {

const TestWords& sphere_triangle_words() {
  static constexpr TestWords words = {"docs/kernels.md#what-each-answers", {}};
  return words;
}

}  // namespace axiscert
