// Where this program is, beside which it finds what comes with it.
#pragma once

#include <filesystem>

namespace axiscert {

// The folder of the command; of a library that another program has loaded, the one that set_own_folder() was given.
std::filesystem::path own_folder();
// Before anything is looked for.
void set_own_folder(const std::filesystem::path& folder);

}  // namespace axiscert
