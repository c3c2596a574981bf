// What kernels give in place of the separation, normal and point of a sphere and a triangle.
#pragma once

#include <span>

#include "fuzz/diagnosis/contact_likenesses.h"

namespace axiscert {

std::span<const ContactLikeness* const> sphere_triangle_contact_likenesses();

}  // namespace axiscert
