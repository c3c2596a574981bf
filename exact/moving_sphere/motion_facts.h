// What exact arithmetic tells of a motion besides its verdict.
#pragma once

#include <vector>

#include "exact/moving_sphere/first_contact.h"
#include "exact/trait/exact_facts.h"

namespace axiscert::moving_sphere {

// The place of the first contact, each coordinate exactly: of the triangle's point that is nearest to the centre then,
// and of the unit vector from there to the centre, empty where they are one point.
struct ExactPlace {
  std::array<RootNumber, 3> point;
  std::vector<RootNumber> normal;
};
ExactPlace exact_place(const GivenMotion& q, const MotionPieces& motion, const FirstContact& contact);

// The query is valid.
std::vector<ExactFact> exact_facts(const GivenMotion& q);

}  // namespace axiscert::moving_sphere
