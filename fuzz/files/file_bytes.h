// A file as bytes and as a name: what is hashed is what is parsed.
#pragma once

#include <fstream>
#include <span>
#include <string>

namespace axiscert {

// All throw Error that names the file and says what the system says. The whole file, or the rest of a stream:
std::string read_bytes(const std::string& path);
std::string read_bytes(std::istream& in, const std::string& name);
// A part at a time: fills the block, and returns how much it got; less only at the end.
std::ifstream open_file(const std::string& path);
std::size_t read_block(std::istream& in, std::span<char> block, const std::string& name);

// The last part of the path: all that a record says of where a file was. Throws Error where it is not UTF-8.
std::string base_name(const std::string& path);

}  // namespace axiscert
