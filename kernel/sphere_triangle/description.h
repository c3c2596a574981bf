// The test sphere against triangle, described for what goes by descriptions.
#pragma once

namespace axiscert {

struct TestDescription;  // kernel/test.h

const TestDescription& sphere_triangle_test();

}  // namespace axiscert
