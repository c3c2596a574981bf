#include "fuzz/files/query_object.h"

#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"

namespace axiscert {

Json detail_json(const Detail& detail) {
  if (const double* number = std::get_if<double>(&detail.value)) return format_number(*number);
  if (const auto* word = std::get_if<std::string_view>(&detail.value)) return *word;
  if (const auto* names = std::get_if<std::vector<std::string_view>>(&detail.value)) return *names;
  return nullptr;
}

}  // namespace axiscert
