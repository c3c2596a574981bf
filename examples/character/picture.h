// The walk as SVG, seen from above: one panel for the walk, and one for each kernel with the contacts that it missed
// and invented.
#pragma once

#include <span>
#include <string>

#include "examples/character/comparison.h"

namespace axiscert::character {

std::string picture(const Ground& ground, const Walk& walk, std::span<const Comparison> comparisons,
                    const std::string& title);

}  // namespace axiscert::character
