// A file as bytes and as a name: what is hashed is what is parsed.
#pragma once

#include <iosfwd>
#include <string>

namespace axiscert {

// The whole file, or the rest of a stream. Throws Error naming it and what the system says.
std::string read_bytes(const std::string& path);
std::string read_bytes(std::istream& in, const std::string& name);
// The last part of the path: all that a record says of where a file was.
std::string base_name(const std::string& path);

}  // namespace axiscert
