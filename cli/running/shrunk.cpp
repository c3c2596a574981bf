#include "cli/running/shrunk.h"

namespace axiscert {
namespace {

// Adds what is kept besides the symptom: the class of the input and the definitions of classes that it meets.
void put_classes(Json& kept, const Keep& keep) {
  kept["class"] = kept["classes"] = nullptr;
  if (!keep.classes()) return;
  kept["class"] = keep.classes()->front();
  kept["classes"] = *keep.classes();
}

Json kept_json(const Symptom& s) {
  return {{"level", level_names[s.level]},
          {"name", name(s)},
          {"kind", s.kind ? Json(flip_kind_names[*s.kind]) : Json("error")},
          {"links", names(s.links)}};
}

template <class Real>
Json line_of(const StoredQuery& stored, Json kept, const Shrunk<Real>& found, const Kernel& kernel) {
  Json line = Json::parse(query_line(smaller_query(stored, found.query)));
  put_classes(kept, found.kept);
  line["kernel"] = kernel.id;
  line["kept"] = std::move(kept);
  line["before"] = Json::parse(query_line(stored));
  line["severity"] = {{"before", found.before.text}, {"after", found.after.text}};
  line["bits"] = {{"before", found.sizes.front().bits}, {"after", found.sizes.back().bits}};
  line["nonzero"] = {{"before", found.sizes.front().nonzero}, {"after", found.sizes.back().nonzero}};
  line["steps"] = found.sizes.size() - 1;
  line["evaluations"] = found.evaluations;
  line["complete"] = found.complete;
  return line;
}

}  // namespace

StoredQuery smaller_query(const StoredQuery& stored, AnyNumbers numbers) {
  return {"shrunk-" + stored.id, stored.precision, std::move(numbers), stored.test, stored.entry};
}

StoredQuery image_of(const StoredQuery& stored, AnyNumbers image) {
  return {stored.id + "-image", stored.precision, std::move(image), stored.test, stored.entry};
}

template <class Real>
Json shrunk_json(const StoredQuery& stored, const Symptom& kept, const Shrunk<Real>& found, const Kernel& kernel) {
  return line_of(stored, kept_json(kept), found, kernel);
}
template Json shrunk_json(const StoredQuery&, const Symptom&, const Shrunk<float>&, const Kernel&);
template Json shrunk_json(const StoredQuery&, const Symptom&, const Shrunk<double>&, const Kernel&);

template <class Real>
Json shrunk_pair_json(const StoredQuery& stored, const Pair<Real>& pair, const ShrunkPair<Real>& found,
                      const Kernel& kernel) {
  const PairSymptom& symptom = pair.symptom;
  const Level level = symptom.which ? Level::comparison : Level::verdict;
  Json line = line_of(stored,
                      {{"level", level_names[level]},
                       {"name", symptom.which ? symptom.test->comparisons[*symptom.which].name : "verdict"},
                       {"kind", "asymmetry"},
                       {"links", Json::array()}},
                      found.query, kernel);
  line["answers"] = {name(symptom.of_query), name(symptom.of_image)};
  line["image"] = Json::parse(query_line(image_of(smaller_query(stored, found.query.query), found.image)));
  line["before"]["image"] = Json::parse(query_line(image_of(stored, pair.image)));
  return line;
}
template Json shrunk_pair_json(const StoredQuery&, const Pair<float>&, const ShrunkPair<float>&, const Kernel&);
template Json shrunk_pair_json(const StoredQuery&, const Pair<double>&, const ShrunkPair<double>&, const Kernel&);

std::string shrunk_witnesses(const Record& record, const std::string& target, std::uint64_t evaluations,
                             const ShowProgress& report) {
  std::string text;
  ProgressCount progress(report, record.witnesses.size(), "the witnesses are made smaller");
  for (const WitnessRecord& witness : record.witnesses) {
    progress.finished();  // when the next one is begun
    const Kernel& kernel = find_kernel(witness.kernel);
    Json line = json_of(witness);
    line["test"] = kernel.test->id;
    const StoredQuery stored = parse_queries(line.dump(), witness.id, Precision::binary32).front();
    std::visit(
        [&]<class Real>(const Numbers<Real>& q) {
          if (witness.flips.empty()) {  // half of a pair, or kept as an extreme
            if (const auto pair = asymmetric_pair(q, stored.address, kernel, target)) {
              const auto found = shrink_pair(*pair, kernel, target, evaluations);
              text += shrunk_pair_json(stored, *pair, found, kernel).dump() + "\n";
            }
            return;
          }
          SymptomFinder<Real> finder(kernel, target);
          const auto flips = finder.flips(q);
          // Somebody else's code may give another answer today.
          if (flips.empty() || !finder.severity(q, flips.front())) return;
          const auto found = shrink<Real>(q, flips.front(), kernel, target, evaluations);
          text += shrunk_json(stored, flips.front(), found, kernel).dump() + "\n";
        },
        stored.numbers);
  }
  return text;
}

}  // namespace axiscert
