#include "plans/shrunk.h"

namespace axiscert {
namespace {

KeptLine kept_line(const Symptom& s) {
  return {.level = s.measure ? std::nullopt : std::optional(s.level),
          .name = name(s),
          .kind = s.measure ? name(*s.measure)
                  : s.kind  ? flip_kind_names[*s.kind]
                            : "error",
          .links = {s.links.begin(), s.links.end()},
          .input_class = {},
          .classes = {}};
}

template <class Real>
ShrunkQuery line_of(const StoredQuery& stored, KeptLine kept, const ShrinkResult<Real>& found, const Kernel& kernel) {
  // The class of the input, and the definitions of classes that it meets.
  if (const auto& classes = found.kept.classes()) {
    kept.input_class = classes->front();
    kept.classes.emplace(classes->begin(), classes->end());
  }
  const QuerySize &before = found.sizes.front(), &after = found.sizes.back();
  const auto count = [](int number) { return static_cast<std::uint64_t>(number); };
  return {stored_line(smaller_query(stored, found.query)),
          kernel.id,
          std::move(kept),
          {stored_line(stored), {}},
          {found.before.text, found.after.text},
          {count(before.bits), count(after.bits)},
          {count(before.nonzero), count(after.nonzero)},
          found.sizes.size() - 1,
          found.evaluations,
          found.complete,
          {},
          {}};
}

}  // namespace

StoredQuery smaller_query(const StoredQuery& stored, AnyNumbers numbers) {
  return {"shrunk-" + stored.id, stored.precision, std::move(numbers), stored.predicate, stored.entry};
}

StoredQuery image_of(const StoredQuery& stored, AnyNumbers image) {
  return {stored.id + "-image", stored.precision, std::move(image), stored.predicate, stored.entry};
}

template <class Real>
ShrunkQuery shrunk_query(const StoredQuery& stored, const Symptom& kept, const ShrinkResult<Real>& found,
                         const Kernel& kernel) {
  return line_of(stored, kept_line(kept), found, kernel);
}
template ShrunkQuery shrunk_query(const StoredQuery&, const Symptom&, const ShrinkResult<float>&, const Kernel&);
template ShrunkQuery shrunk_query(const StoredQuery&, const Symptom&, const ShrinkResult<double>&, const Kernel&);

template <class Real>
ShrunkQuery shrunk_pair(const StoredQuery& stored, const Pair<Real>& pair, const ShrunkPair<Real>& found,
                        const Kernel& kernel) {
  const PairSymptom& symptom = pair.symptom;
  const KeptLine kept{.level = symptom.which ? Level::comparison : Level::verdict,
                      .name = symptom.which ? symptom.predicate->comparisons[*symptom.which].name : "verdict",
                      .kind = "asymmetry",
                      .links = {},
                      .input_class = {},
                      .classes = {}};
  ShrunkQuery line = line_of(stored, kept, found.query, kernel);
  line.answers = std::vector{symptom.of_query, symptom.of_image};
  line.image = stored_line(image_of(smaller_query(stored, found.query.query), found.image));
  line.before.image = stored_line(image_of(stored, pair.image));
  return line;
}
template ShrunkQuery shrunk_pair(const StoredQuery&, const Pair<float>&, const ShrunkPair<float>&, const Kernel&);
template ShrunkQuery shrunk_pair(const StoredQuery&, const Pair<double>&, const ShrunkPair<double>&, const Kernel&);

std::string shrunk_witnesses(const Record& record, const std::string& target, std::uint64_t evaluations,
                             const ShowProgress& report) {
  std::string text;
  ProgressCount progress(report, record.witnesses.size(), "the witnesses are made smaller");
  for (const WitnessRecord& witness : record.witnesses) {
    progress.finish_unit();  // when the next one is begun
    const Kernel& kernel = find_kernel(witness.kernel);
    Json line = json_of(witness);
    line["predicate"] = kernel.predicate->id;
    const StoredQuery stored = parse_queries(line.dump(), witness.id, Precision::binary32).front();
    std::visit(
        [&]<class Real>(const Numbers<Real>& q) {
          if (witness.flips.empty()) {  // half of a pair, or kept as an extreme
            if (const auto pair = asymmetric_pair(q, stored.address, kernel, target)) {
              const auto found = shrink_pair(*pair, kernel, target, evaluations);
              text += json_of(shrunk_pair(stored, *pair, found, kernel)).dump() + "\n";
              return;
            }
          }
          SymptomFinder<Real> finder(kernel, target);
          auto flips = finder.flips(q);
          if (flips.empty()) flips = finder.measure_faults(q);
          // Somebody else's code may give another answer today.
          if (flips.empty() || !finder.severity(q, flips.front())) return;
          const auto found = shrink<Real>(q, flips.front(), kernel, target, evaluations);
          text += json_of(shrunk_query(stored, flips.front(), found, kernel)).dump() + "\n";
        },
        stored.numbers);
  }
  return text;
}

}  // namespace axiscert
