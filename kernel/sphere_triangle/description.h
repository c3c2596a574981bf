// The description of the test sphere against triangle.
#pragma once

namespace axiscert {

struct TestDescription;  // kernel/test.h

const TestDescription& sphere_triangle_test();

}  // namespace axiscert
