#include "cli/running/shrunk.h"

#include "fuzz/files/sphere_triangle_query.h"

namespace axiscert {
namespace {

Json kept_json(const Symptom& s) {
  return {{"level", level_names[s.level]},
          {"name", name(s)},
          {"kind", s.kind ? Json(flip_kind_names[*s.kind]) : Json("error")},
          {"links", names(s.links)}};
}

}  // namespace

template <class Real>
Json shrunk_json(const StoredQuery& stored, const Symptom& kept, const Shrunk<Real>& found, const Kernel& kernel) {
  Json line = Json::parse(query_line({"shrunk-" + stored.id, stored.precision, found.query, 0}));
  line["kernel"] = kernel.id;
  line["kept"] = kept_json(kept);
  line["before"] = Json::parse(query_line(stored));
  line["severity"] = {{"before", found.before.text}, {"after", found.after.text}};
  line["bits"] = {{"before", found.sizes.front().bits}, {"after", found.sizes.back().bits}};
  line["nonzero"] = {{"before", found.sizes.front().nonzero}, {"after", found.sizes.back().nonzero}};
  line["steps"] = found.sizes.size() - 1;
  line["evaluations"] = found.evaluations;
  line["complete"] = found.complete;
  return line;
}
template Json shrunk_json(const StoredQuery&, const Symptom&, const Shrunk<float>&, const Kernel&);
template Json shrunk_json(const StoredQuery&, const Symptom&, const Shrunk<double>&, const Kernel&);

std::string shrunk_witnesses(const Json& record, const std::string& target, std::uint64_t evaluations,
                             const ShowProgress& report) {
  std::string text;
  ProgressCount progress(report, record["witnesses"].size(), "the witnesses are made smaller");
  for (const Json& witness : record["witnesses"]) {
    progress.finished();                     // when the next one is begun
    if (witness["flips"].empty()) continue;  // kept as an extreme, nothing is wrong
    const Kernel& kernel = find_kernel(witness["kernel"].get<std::string>());
    const std::string id = witness["id"];
    const StoredQuery stored = parse_queries(witness.dump(), id, Precision::binary32).front();
    std::visit(
        [&]<class Real>(const Query<Real>& q) {
          Diagnosis<Real> diagnosis(kernel, target);
          const auto flips = diagnosis.flips(q);
          // Somebody else's code may give another answer today.
          if (flips.empty() || !diagnosis.severity(q, flips.front())) return;
          const auto found = shrink(q, flips.front(), kernel, target, evaluations);
          text += shrunk_json(stored, flips.front(), found, kernel).dump() + "\n";
        },
        sphere_triangle_query(stored));
  }
  return text;
}

}  // namespace axiscert
