#include "reports/formats/render.h"

#include <map>
#include <string>

#include "reports/formats/format.h"

// The formats that exist, one line each: X(NAME) is `NAME_format`, which a file of its own defines.
#define AXISCERT_FORMATS(X) \
  X(html)                   \
  X(csv)                    \
  X(witnesses)              \
  X(markdown)               \
  X(junit)                  \
  X(sarif)                  \
  X(ratchet)

namespace axiscert {

#define AXISCERT_DECLARE(name) extern const Format name##_format;
AXISCERT_FORMATS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

std::span<const Format* const> formats() {
#define AXISCERT_POINT(name) &name##_format,
  static const Format* const all[] = {AXISCERT_FORMATS(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

void render_reports(const std::filesystem::path& run_folder) {
  const Run run = read_run(run_folder);
  std::map<std::string, std::string> texts;
  for (const Format* format : formats()) texts[format->file] = format->render(run);
  write_files(run_folder, texts);
}

}  // namespace axiscert
