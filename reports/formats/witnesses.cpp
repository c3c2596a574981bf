// witnesses.jsonl: every witness as a line of a query file.
#include "fuzz/files/nested_text.h"
#include "reports/formats/format.h"
#include "reports/run_folder/record_names.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

std::string render_witnesses(const Run& run) {
  const Predicate& predicate = predicate_of(run.record.plan);
  std::string text;
  for (const WitnessRecord& witness : run.record.witnesses) {
    Json query = {{"id", json_of(witness.id)}, {"precision", name(witness.precision)}};
    const PredicateEntry& entry = *entry_of(predicate, witness);
    if (const std::string_view written = written_name(predicate); !written.empty()) query["predicate"] = written;
    if (&entry != &predicate.entries.front()) query["entry"] = entry.name;
    for (const ColumnGroup& group : groups_of(entry))
      member_at(query, group.name) = json_of(witness.numbers.at(group.name));
    text += query.dump() + "\n";
  }
  return text;
}

}  // namespace

extern const Format witnesses_format = {"witnesses.jsonl", "every witness as a query file", render_witnesses};

}  // namespace axiscert
