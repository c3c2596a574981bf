#include "reports/formats/render.h"

#include <map>
#include <string>

#include "reports/formats/format.h"

namespace axiscert {

extern const Format html_format, junit_format, markdown_format, ratchet_format, sarif_format, witnesses_format;
namespace {
const Format* const registry[] = {&html_format,  &markdown_format, &junit_format,
                                  &sarif_format, &ratchet_format,  &witnesses_format};
}

void render_reports(const std::filesystem::path& run_folder) {
  const Run run = read_run(run_folder);
  std::map<std::string, std::string> texts;
  for (const Format* format : registry) texts[format->file] = format->render(run);
  write_files(run_folder, texts);
}

}  // namespace axiscert
