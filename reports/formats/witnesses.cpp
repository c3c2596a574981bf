// witnesses.jsonl: every witness as a line of a query file.
#include "reports/formats/format.h"

namespace axiscert {
namespace {

std::string render_witnesses(const Run& run) {
  std::string text;
  for (const Json& witness : run.record["witnesses"]) {
    Json query;
    for (const char* member : {"id", "precision", "a", "b", "c", "p", "r"}) query[member] = witness[member];
    text += query.dump() + "\n";
  }
  return text;
}

}  // namespace

extern const Format witnesses_format = {"witnesses.jsonl", "every witness as a query file", render_witnesses};

}  // namespace axiscert
