// What depends on whether somebody looks: colour.
#pragma once

#include <string>

namespace axiscert {

enum class TextColour { red, yellow, green };

// Standard output is a terminal that shows colours, and NO_COLOR is not set to anything.
bool output_has_colour();
// The text in that colour where output_has_colour(), else as it is. A line's end stays outside.
std::string coloured(const std::string& text, TextColour colour);

}  // namespace axiscert
