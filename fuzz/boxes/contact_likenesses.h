// Numbers that kernels give in place of those of a contact of two boxes, or of a box and a triangle.
#pragma once

#include <span>

#include "fuzz/diagnosis/contact_likenesses.h"

namespace axiscert::boxes {

std::span<const ContactLikeness* const> box_box_contact_likenesses();
std::span<const ContactLikeness* const> box_triangle_contact_likenesses();

}  // namespace axiscert::boxes
