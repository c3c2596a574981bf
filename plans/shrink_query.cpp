#include "plans/shrink_query.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fuzz/confirm/record.h"
#include "fuzz/shrink/pair.h"
#include "kernel/base/error.h"
#include "plans/given_queries.h"

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

namespace {

std::string unknown_symptom(const Predicate& predicate, std::string_view given) {
  std::vector<std::string_view> names = {"verdict"};
  for (const PredicateClause& clause : predicate.clauses) names.push_back(clause.name);
  for (const PredicateComparison& comparison : predicate.comparisons) names.push_back(comparison.name);
  for (const auto& words : {judged_measures(predicate), fault_words(predicate)}) {
    for (const std::string_view one : words) {
      if (std::ranges::find(names, one) == names.end()) names.push_back(one);
    }
  }
  names.push_back(asymmetry_name);
  const std::string_view suffix = given.find(':') == given.npos ? "" : error_suffix;
  const std::string_view word = given.substr(0, given.find(':')), guess = meant(word, names);
  return fmt::format("--what {}: unknown{} possible values: {}, and COMPARISON{}", given,
                     guess.empty() ? ";" : fmt::format("; did you mean '{}{}'?", guess, suffix),
                     fmt::join(most_alike_first(word, names), ", "), error_suffix);
}

// The symptom of that name, without the parts that have to be determined from a query; empty where there is no such
// name.
std::optional<Symptom> symptom_named(const Predicate& predicate, std::string_view what) {
  const bool is_error = what.ends_with(error_suffix);
  if (is_error) what.remove_suffix(error_suffix.size());
  if (what == "verdict" && !is_error) return Symptom{.predicate = &predicate};
  for (std::uint8_t i = 0; i < predicate.clauses.size(); ++i) {
    if (predicate.clauses[i].name == what && !is_error)
      return Symptom{.predicate = &predicate, .level = Level::axis, .index = i};
  }
  for (std::uint8_t i = 0; i < predicate.comparisons.size(); ++i) {
    if (predicate.comparisons[i].name == what)
      return Symptom{.predicate = &predicate, .level = Level::comparison, .index = i};
  }
  return std::nullopt;
}

bool is_measure(const Predicate& predicate, std::string_view what) {
  for (const MeasureFault which : enumerators<MeasureFault>) {
    if (can_have(predicate, predicate.measures.size(), which) && is_named(which, what)) return true;
  }
  return false;
}

std::string symptoms_text(const std::vector<Symptom>& symptoms) {
  std::vector<std::string> texts;
  for (const Symptom& s : symptoms) texts.push_back(text(s));
  return texts.empty() ? "its verdict and every axis and comparison are right there"
                       : fmt::format("{}", fmt::join(texts, "; "));
}

// The fault of a measure; where none is named, the first that there is.
template <class Real>
std::optional<Symptom> measure_fault(const Numbers<Real>& q, std::string_view measure, SymptomFinder<Real>& finder) {
  for (const Symptom& fault : finder.measure_faults(q)) {
    if (measure.empty() || is_named(*fault.measure, measure)) return fault;
  }
  return std::nullopt;
}

// The symptom to keep: the one requested, or the first that is wrong: verdict, axes, comparisons, the numbers beside a
// contact; and where nothing is, the largest error of a comparison.
template <class Real>
Symptom symptom_to_keep(const Numbers<Real>& q, const StoredQuery& stored, const ShrinkOptions& options,
                        const Kernel& kernel, std::string_view target) {
  const auto fail = [&](const std::string& what) {
    return NothingToKeep(fmt::format("query '{}': {}", stored.id, what));
  };
  if (oracles_of(kernel).truth(q).verdict == Verdict::invalid)
    throw fail(fmt::format("not a valid query ({}): no answer of a kernel could be wrong", stored.columns().validity));
  SymptomFinder<Real> finder(kernel, target);
  const std::vector<Symptom> flips = finder.flips(q);
  const bool is_of_measure = is_measure(*kernel.predicate, options.what);
  const bool needs_verdict = options.what.empty() ? flips.empty() : options.what == "verdict" || is_of_measure;
  if (needs_verdict || !is_promised(kernel, q)) {
    // No wrong verdict is one thing, and no verdict another.
    if (const auto why = finder.why_no_verdict(q)) {
      throw fail(
          fmt::format("{} has no verdict to keep: {}; shrink keeps verdicts, axes and comparisons that are wrong",
                      kernel.id, *why));
    }
  }
  if (options.what.empty()) {
    if (!flips.empty()) return flips.front();
    if (const auto fault = measure_fault<Real>(q, "", finder)) return *fault;
    if (const auto error = finder.largest_error(q)) return *error;
    throw fail(fmt::format("{} is not wrong on it: {}{}; to keep the error of a comparison, give --what COMPARISON{}",
                           kernel.id, symptoms_text(flips),
                           stored.address.empty() ? "" : ", and it answers no image of it differently", error_suffix));
  }
  if (is_of_measure) {
    if (const auto fault = measure_fault(q, options.what, finder)) return *fault;
    // No wrong number is one thing, and no number another.
    bool is_compared = false;
    for (const MeasureFault which : enumerators<MeasureFault>)
      is_compared |= is_named(which, options.what) && finder.is_compared(q, which);
    throw fail(fmt::format("--what {0}: {1} {2}{3}", options.what, kernel.id,
                           is_compared ? fmt::format("has no {} that is wrong there", options.what)
                                       : fmt::format("gives no {} there that could be wrong", options.what),
                           is_of_motions(*kernel.predicate) ? ", beside a right contact" : ""));
  }
  const Symptom asked = *symptom_named(*kernel.predicate, options.what);
  if (!std::string_view(options.what).ends_with(error_suffix)) {
    for (const Symptom& flip : flips) {
      if (flip.level == asked.level && flip.index == asked.index) return flip;
    }
    throw fail(fmt::format("--what {}: {} has it right; it is wrong there: {}", options.what, kernel.id,
                           flips.empty() ? "nothing" : symptoms_text(flips)));
  }
  if (finder.severity(q, asked)) return asked;
  throw fail(
      fmt::format("--what {}: {} has no measurable error there: it shows no sides of its own "
                  "formulae, or a side is not finite, or there is nothing to measure against",
                  options.what, kernel.id));
}

KeepingRule keeping_rule(const ShrinkOptions& options) {
  return options.any_class ? KeepingRule::symptom : KeepingRule::symptom_and_class;
}

// The result, as both ways of shrinking find it.
template <class Real>
Shrunk shrunk_of(const StoredQuery& stored, const StoredQuery& smaller, std::string kept,
                 const ShrinkResult<Real>& found, ShrunkQuery line) {
  const auto& classes = found.kept.classes();
  return {.asked = stored,
          .smaller = smaller,
          .kept = std::move(kept),
          .input_class = classes ? std::string(classes->front()) : "",
          .size_before = found.sizes.front(),
          .size_after = found.sizes.back(),
          .severity_before = found.before.text,
          .severity_after = found.after.text,
          .steps = found.sizes.size() - 1,
          .evaluations = found.evaluations,
          .complete = found.complete,
          .line = std::move(line)};
}

template <class Real>
Shrunk shrunk_as_pair(const Pair<Real>& pair, const StoredQuery& stored, const ShrinkOptions& options,
                      const Kernel& kernel, std::string_view target, const CountEvaluations& evaluated) {
  const auto found = shrink_pair(pair, kernel, target, options.evaluations, keeping_rule(options), evaluated);
  const StoredQuery smaller = smaller_query(stored, found.query.query);
  Shrunk made = shrunk_of(stored, smaller, fmt::format("asymmetry: {}", text(pair.symptom)), found.query,
                          shrunk_pair(stored, pair, found, kernel));
  made.image = image_of(smaller, found.image);
  return made;
}

template <class Real>
Shrunk shrink_one(const Numbers<Real>& q, const StoredQuery& stored, const ShrinkOptions& options, const Kernel& kernel,
                  std::string_view target, const CountEvaluations& evaluated) {
  const bool wants_pair = options.what == asymmetry_name;
  // Without --what, a query that is right by itself is half of a pair, if it is in one.
  const auto is_right = [&] {
    return may_be_valid(shape_of(stored.columns()), q) && SymptomFinder<Real>(kernel, target).flips(q).empty();
  };
  if (wants_pair || (options.what.empty() && is_right())) {
    if (const auto pair = asymmetric_pair(q, stored.address, kernel, target))
      return shrunk_as_pair(*pair, stored, options, kernel, target, evaluated);
  }
  // Where no map leads from the one to the other, the one that is answered wrongly is made smaller.
  if (wants_pair || (options.what.empty() && !stored.address.empty() && is_right())) {
    if (const auto relative = wrong_relative(q, stored.address, kernel, target)) {
      StoredQuery other{relative->address, stored.precision, relative->query, stored.predicate, stored.entry};
      ShrinkOptions of_verdict = options;
      of_verdict.what = "verdict";
      Shrunk made = shrink_one(relative->query, other, of_verdict, kernel, target, evaluated);
      made.is_relative = true;
      return made;
    }
  }
  if (wants_pair) {
    throw NothingToKeep(fmt::format(
        "query '{}': --what {}: {}", stored.id, asymmetry_name,
        stored.address.empty() ? "give an address, or a witness, of a family of images: it states no address"
                               : kernel.id + " answers no image of it differently, its family has none, or its "
                                             "numbers are not those of its address"));
  }
  const Symptom kept = symptom_to_keep(q, stored, options, kernel, target);
  const auto found = shrink<Real>(q, kept, kernel, target, options.evaluations, keeping_rule(options), evaluated);
  return shrunk_of(stored, smaller_query(stored, found.query), text(kept), found,
                   shrunk_query(stored, kept, found, kernel));
}

}  // namespace

void require_known_symptom(const Kernel& kernel, std::string_view what) {
  const Predicate& predicate = *kernel.predicate;
  if (what.empty() || is_measure(predicate, what)) return;
  if (what != asymmetry_name && !symptom_named(predicate, what)) throw Error(unknown_symptom(predicate, what));
}

const Kernel& kernel_to_shrink(const StoredQuery& stored, const std::vector<const Kernel*>& given) {
  const Kernel& kernel = given.size() == 1 ? *given.front()
                                           : kernel_for_query(given, *stored.predicate, stored.entry,
                                                              fmt::format("query '{}'", stored.id));
  if (stored.predicate != kernel.predicate || stored.entry != kernel.entry) {
    throw Error(fmt::format("query '{}' is of the predicate {}, entry {}, and kernel {} of {}, {}", stored.id,
                            stored.predicate->id, stored.columns().name, kernel.id, kernel.predicate->id,
                            kernel.predicate->entries[kernel.entry].name));
  }
  if (!kernel.has(stored.precision)) {
    throw Error(fmt::format("query '{}' is in {}, in which kernel {} does not exist", stored.id, name(stored.precision),
                            kernel.id));
  }
  return kernel;
}

Shrunk shrunk(const StoredQuery& stored, const ShrinkOptions& options, const Kernel& kernel, std::string_view target,
              const CountEvaluations& evaluated) {
  return std::visit([&](const auto& q) { return shrink_one(q, stored, options, kernel, target, evaluated); },
                    stored.numbers);
}

}  // namespace axiscert
