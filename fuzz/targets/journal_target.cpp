// The journal: appended contents are read again; from a damaged file either a beginning of the appended contents is
// read, in their order, or it is refused by Error. The target also checks the contents: stretches, tallies and costs.
//
// Input: byte 0 chooses a damage, bytes 1 and 2 its position; then entries, each a length of one byte and its content.
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <vector>

#include "fuzz/text/file_bytes.h"
#include "fuzz/campaign/gathered.h"
#include "fuzz/campaign/journal.h"
#include "fuzz/targets/target.h"
#include "kernel/sphere_triangle/query.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;

enum class Damage : std::uint8_t { none, truncated, flipped, zeroed, raw };
constexpr unsigned damage_count = 5;

std::vector<std::string> contents_of(std::string_view input) {
  std::vector<std::string> contents;
  while (!input.empty()) {
    const std::size_t size = std::min<std::size_t>(static_cast<unsigned char>(input[0]), input.size() - 1);
    contents.emplace_back(input.substr(1, size));
    input.remove_prefix(1 + size);
  }
  return contents;
}

std::string damaged(std::string bytes, Damage damage, std::size_t at) {
  at %= bytes.size();
  switch (damage) {
    case Damage::none:
    case Damage::raw:
      break;
    case Damage::truncated:
      bytes.resize(at);
      break;
    case Damage::flipped:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
      break;
    case Damage::zeroed:
      std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), '\0');
      break;
  }
  return bytes;
}

// Checks that a journal gives these contents, or a beginning of them, and no others.
void check_file(const std::string& bytes, const std::string& digest, const std::vector<std::string>& appended,
                bool is_whole) {
  const MemoryFile file(bytes);
  std::vector<std::string> read;
  JournalEnd end;
  const bool is_read =
      accepts([&] { end = read_journal(file.path(), digest, [&](std::string_view one) { read.emplace_back(one); }); });
  if (is_whole && (!is_read || read != appended || end.torn != 0))
    report_fault("a journal that was written cannot be read");
  if (read.size() > appended.size() || !std::equal(read.begin(), read.end(), appended.begin())) {
    report_fault(fmt::format("entry {} read from a damaged journal is not the one appended there", read.size()));
  }
  if (is_read && end.whole + end.torn > bytes.size()) report_fault("a journal has more bytes than its file");
}

// Reads bytes as an entry, and as its parts: either Error, or writing and reading the result gives the same.
void check_content(std::string_view content) {
  std::optional<Entry> entry;
  if (accepts([&] { entry = finished_in(content); }) && entry) {
    if (encode(decode_entry(encode(*entry))) != encode(*entry))
      report_fault("a stretch changes when it is written, read and written again");
    for (const std::string& tally : entry->tallies) {
      std::optional<Tally> read;
      if (!accepts([&] { read = decode_tally(tally, sphere_triangle_predicate()); })) continue;
      const std::string again = encode(*read);
      if (encode(decode_tally(again, sphere_triangle_predicate())) != again)
        report_fault("a tally changes when it is written, read and written again");
    }
    accepts([&] { encode(decode_costs(entry->costs)); });
  }
  accepts([&] { decode_tally(content, sphere_triangle_predicate()); });
  accepts([&] { decode_costs(content); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const auto damage = static_cast<Damage>(data[0] % damage_count);
  const std::size_t at = data[1] | data[2] << 8;
  const std::string_view rest = text_of(data + 3, size - 3);
  const std::string digest(64, 'd');
  if (damage == Damage::raw) {
    check_file(std::string(rest), digest, {}, false);
    check_content(rest);
    return 0;
  }
  const std::vector<std::string> contents = contents_of(rest);
  const MemoryFile file("");
  {
    Journal journal(file.path(), digest, [](std::string_view) { report_fault("an empty journal has an entry"); });
    for (const std::string& content : contents) journal.append(content);
  }
  for (const std::string& content : contents) check_content(content);
  check_file(damaged(read_bytes(file.path()), damage, at), digest, contents, damage == Damage::none);
  return 0;
}
