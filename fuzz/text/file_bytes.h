// A file's bytes and its name: the bytes that are hashed are those that are parsed.
#pragma once

#include <fstream>
#include <span>
#include <string>

namespace axiscert {

// All functions throw Error that names the file and quotes the system's message. The whole file, or the rest of a
// stream:
std::string read_bytes(const std::string& path);
std::string read_bytes(std::istream& in, const std::string& name);
// Reads part by part: fills the block and returns the number of bytes read; fewer only at the end.
std::ifstream open_file(const std::string& path);
std::size_t read_block(std::istream& in, std::span<char> block, const std::string& name);

// The last part of the path: all that a record contains about a file's location. Throws Error if it is not UTF-8.
std::string base_name(const std::string& path);

}  // namespace axiscert
