// Tables for a terminal.
#pragma once

#include <string>
#include <vector>

namespace axiscert {

// Whether a cell is one number, perhaps with a sign: such cells are right-aligned.
bool is_number(const std::string& cell);
// Aligned columns, two spaces before each; every row has a cell for each column. A control character, which a terminal
// would obey, is shown as '?'.
std::string aligned_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows);

}  // namespace axiscert
