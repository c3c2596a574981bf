// JSON inputs, changed by their structure: a byte that is flipped in a kilobyte of JSON nearly always leaves none.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/search/dice.h"

namespace axiscert::fuzzing {

enum class JsonMove : std::uint8_t {
  replace,    // a value by a strange one: a bound of an integer, an empty object, text that is a number
  copy,       // a value by another of the document
  remove,     // a member or an element
  duplicate,  // an element once more; a member under a name of the document
  rename,     // a member
  nudge,      // a number by a little, a text by a character
  nest,       // a value into an array of an array of an array, some levels or very many
};
inline constexpr std::size_t json_move_count = 7;

// Whether brackets open so deep that nlohmann's functions on the value, which call themselves once a level, would take
// the stack: here as in what is tested.
bool is_deep(std::string_view text);

// A document changed by the move; as it was where the move finds nothing to change, the text is no JSON, or deep.
std::string moved_json(std::string_view text, JsonMove move, Dice& dice);

// For LLVMFuzzerCustomMutator: a whole document, one line of many, or what stands before the first such byte. Every
// other time, and where there is no JSON to change, libFuzzer's own changes of bytes. `room` bytes at most are written,
// and their number returned.
std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed);
std::size_t mutate_json_until(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed, std::uint8_t end);
std::size_t mutate_json_line(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed);

}  // namespace axiscert::fuzzing
