// The predicates that exist, of the one list.
#include <algorithm>

#include "kernel/base/error.h"
#include "kernel/predicate.h"
#include "kernel/predicate_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name) const Predicate& name##_predicate();
AXISCERT_PREDICATES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

namespace {

const std::vector<const Predicate*>& all_predicates() {
#define AXISCERT_POINT(name) &name##_predicate(),
  static const std::vector<const Predicate*> all = {AXISCERT_PREDICATES(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

}  // namespace

std::span<const Predicate* const> predicates() { return all_predicates(); }

const Predicate& find_predicate(std::string_view id, std::span<const Predicate* const> known) {
  std::vector<std::string_view> ids;
  for (const Predicate* predicate : known) {
    if (predicate->id == id) return *predicate;
    ids.push_back(predicate->id);
  }
  throw Error(unknown_name("predicate", "predicates", id, ids));
}

std::string_view written_name(const Predicate& predicate) {
  return predicate.is_implied ? std::string_view() : predicate.id;
}

const Predicate& predicate_named(std::string_view written, std::span<const Predicate* const> known) {
  const auto implied =
      std::find_if(known.begin(), known.end(), [](const auto* predicate) { return predicate->is_implied; });
  return written.empty() && implied != known.end() ? **implied : find_predicate(written, known);
}

std::string id_prefix(const Predicate& predicate) {
  const std::string_view name = written_name(predicate);
  return name.empty() ? std::string() : std::string(name) + "/";
}

}  // namespace axiscert
