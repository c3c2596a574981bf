#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/sphere_triangle/confirm.h"

namespace axiscert {
namespace {

class SphereTriangleClasses final : public InputClasses {
 public:
  std::vector<std::string_view> of(const Numbers<float>& q) const override { return names<float>(q); }
  std::vector<std::string_view> of(const Numbers<double>& q) const override { return names<double>(q); }

 private:
  template <class Real>
  static std::vector<std::string_view> names(const Query<Real>& q) {
    std::vector<std::string_view> all;
    for (const InputClass which : input_classes(q, squared_distance(q))) all.push_back(input_class_names[which]);
    return all;
  }
};

}  // namespace

const InputClasses& sphere_triangle_input_classes() {
  static const SphereTriangleClasses classes;
  return classes;
}

}  // namespace axiscert
