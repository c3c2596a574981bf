// What exact arithmetic tells of two boxes, or of a box and a triangle, besides their verdict.
#pragma once

#include <vector>

#include "exact/boxes/measures.h"
#include "exact/trait/exact_facts.h"

namespace axiscert::boxes {

// The query is valid. The normal is the direction in which B leaves A, or the triangle the box.
std::vector<ExactFact> exact_facts(const ExactPair& q);
std::vector<ExactFact> exact_facts(const ExactBoxAndTriangle& q);

}  // namespace axiscert::boxes
