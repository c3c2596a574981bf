// The walk and the comparisons as text.
#pragma once

#include <span>

#include "examples/character/comparison.h"

namespace axiscert::character {

std::string table(const Ground& ground, const Walk& walk, std::span<const Comparison> comparisons);

}  // namespace axiscert::character
