#include "fuzz/targets/json_mutator.h"

#include <algorithm>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t room);

namespace axiscert::fuzzing {
namespace {

Dice dice_of(unsigned seed) {
  constexpr std::uint64_t generator = name_hash("fuzz-json");
  Stream stream(seed, generator, 1, Precision::binary32, 0);
  return Dice(stream);
}

// Replaces text[begin, end) of the data; makes libFuzzer's own change if that has no effect.
std::size_t mutate_part(std::uint8_t* data, std::size_t size, std::size_t room, std::size_t begin, std::size_t end,
                        Dice& dice) {
  if (dice.coin()) return LLVMFuzzerMutate(data, size, room);
  const std::string whole(reinterpret_cast<const char*>(data), size);
  const auto move = static_cast<JsonMove>(dice.below(json_move_count));
  const std::string part = whole.substr(begin, end - begin);
  const std::string changed = whole.substr(0, begin) + moved_json(part, move, dice) + whole.substr(end);
  if (changed == whole || changed.size() > room) return LLVMFuzzerMutate(data, size, room);
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}

}  // namespace

std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  Dice dice = dice_of(seed);
  return mutate_part(data, size, room, 0, size, dice);
}

std::size_t mutate_json_until(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed, std::uint8_t end) {
  Dice dice = dice_of(seed);
  return mutate_part(data, size, room, 0, static_cast<std::size_t>(std::find(data, data + size, end) - data), dice);
}

std::size_t mutate_json_line(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  Dice dice = dice_of(seed);
  const auto lines = static_cast<std::uint64_t>(std::count(data, data + size, '\n')) + 1;
  std::uint8_t* begin = data;
  for (std::uint64_t skipped = dice.below(lines); skipped > 0; --skipped)
    begin = std::find(begin, data + size, '\n') + 1;
  const std::uint8_t* end = std::find(begin, data + size, '\n');
  return mutate_part(data, size, room, static_cast<std::size_t>(begin - data), static_cast<std::size_t>(end - data),
                     dice);
}

}  // namespace axiscert::fuzzing
