#include "fuzz/queries/capabilities.h"

#include "fuzz/sphere_triangle/screen.h"

namespace axiscert {
namespace {

class SphereTriangleScreens final : public Screens {
 public:
  std::unique_ptr<Screen<float>> screen(const Screened<float>& of) const override {
    return std::make_unique<SphereTriangleScreen<float>>(of);
  }
  std::unique_ptr<Screen<double>> screen(const Screened<double>& of) const override {
    return std::make_unique<SphereTriangleScreen<double>>(of);
  }
};

}  // namespace

const Capabilities& sphere_triangle_capabilities() {
  static const SphereTriangleScreens screens;
  static const Capabilities all = {.screens = &screens, .has_input_classes = true};
  return all;
}

}  // namespace axiscert
