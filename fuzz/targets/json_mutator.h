// Changes of JSON inputs by their structure: after the flip of a byte in a kilobyte of JSON, it is nearly never JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/search/moves.h"

namespace axiscert::fuzzing {

enum class JsonMove : std::uint8_t {
  replace,    // replaces a value by a strange one: a bound of an integer, an empty object, text that is a number
  copy,       // replaces a value by another one of the document
  remove,     // removes a member or an element
  duplicate,  // repeats an element, or a member under another name of the document
  rename,     // renames a member
  nudge,      // changes a number by a little, or a text by a character
  nest,       // puts a value into an array of an array of an array, a few levels deep or very many
};
inline constexpr std::size_t json_move_count = 7;

// Whether brackets nest so deep that nlohmann's functions on the value, which recurse once per level, would exhaust the
// stack, here as in the code under test.
bool is_deep(std::string_view text);

// A document changed by the move; unchanged if the move finds nothing to change, or if the text is not JSON or is too
// deep.
std::string moved_json(std::string_view text, JsonMove move, Dice& dice);

// For LLVMFuzzerCustomMutator: changes a whole document, one line of many, or the part before the first byte `end`.
// Every other time, and where there is no JSON to change, libFuzzer makes its own changes of bytes. At most `room`
// bytes are written; returns their number.
std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed);
std::size_t mutate_json_until(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed, std::uint8_t end);
std::size_t mutate_json_line(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed);

}  // namespace axiscert::fuzzing
