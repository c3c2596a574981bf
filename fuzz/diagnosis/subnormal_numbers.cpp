// Whether subnormal numbers are numbers for a kernel, or zero.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/text/json_form.h"
#include "kernel/registry/called.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t subnormal_scenes = 64;
// Queries that tell a form from the same with subnormal numbers flushed.
constexpr std::size_t least_telling = 16;

// A kernel is as a form where the two agree on every small scene, from those that every form has right down to those
// that none has: else something else, such as a threshold, may give the answers of a form whose small numbers are zero.
struct FormAgreement {
  std::string form;
  std::size_t asked = 0, telling = 0, as_kept = 0, as_flushed = 0;  // telling: the form and its flushed self differ
  bool is_kept() const { return telling >= least_telling && as_kept == asked; }
  bool is_flushed() const { return telling >= least_telling && as_flushed == asked; }
};

template <class Real>
class SubnormalProbe {
 public:
  explicit SubnormalProbe(Subject<Real>& subject)
      : subject_(subject),
        queries_(scenes_of<Real>(subject.predicate()).small(subject.kernel())),
        said_(subject.ask(queries_)) {}

  ProbeFinding found() {
    if (auto kept = by_subnormal_queries()) return *kept;
    const std::optional<std::size_t> changed = changed_by_the_caller();
    if (changed) {
      return decided(Subnormals::kept,
                     fmt::format("Subnormal numbers are numbers to it: called with the processor's mode that flushes "
                                 "them it answers {} small scenes otherwise.",
                                 *changed),
                     {*witness_});
    }
    std::optional<FormAgreement> kept, flushed;
    for (const FormAgreement& form : agreements()) {
      if (form.is_kept() && !kept) kept = form;
      if (form.is_flushed() && !flushed) flushed = form;
    }
    const auto text = [](const FormAgreement& form, const char* how, const char* other) {
      return fmt::format(
          "it answers all {} small scenes as {} does with subnormal numbers {}, which answers {} of them "
          "otherwise where they are {}.",
          form.asked, form.form, how, form.telling, other);
    };
    if (flushed && !kept) {
      return decided(Subnormals::flushed, "Subnormal numbers are zero to it: " + text(*flushed, "flushed", "kept"),
                     {*witness_}, json_of(*flushed));
    }
    if (kept && !flushed) {
      return decided(Subnormals::kept, "Subnormal numbers are numbers to it: " + text(*kept, "kept", "flushed"),
                     {*witness_}, json_of(*kept));
    }
    const auto decides = static_cast<std::size_t>(std::ranges::count_if(said_, is_decided));
    if (decides != said_.size()) {
      return undecided(
          fmt::format("It decides {} of {} small scenes: what it declines does not tell.", decides, said_.size()));
    }
    return undecided(
        "Small scenes do not tell: it answers neither as a built-in form nor as one with subnormal numbers "
        "flushed, and is not right on nine in ten scenes in which every length is subnormal.");
  }

 private:
  static Json json_of(const FormAgreement& form) {
    return {{"form", form.form}, {"asked", form.asked}, {"telling", form.telling}};
  }

  // Right where every number of the query is subnormal: zero would be one answer for all.
  std::optional<ProbeFinding> by_subnormal_queries() {
    Queries<Real> queries;
    std::vector<Verdict> truths;
    for (const auto& query : clear_queries<Real>(subject_.kernel(), subnormal_scenes)) {
      queries.push_back(in_unit(subject_.kernel(), query.numbers, std::numeric_limits<Real>::min_exponent - 3));
      truths.push_back(subject_.truth(queries.back()).verdict);
    }
    const auto said = subject_.ask(queries);
    std::size_t contacts = 0, separated = 0;
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (said[i] != truths[i]) continue;
      ++(said[i] == Verdict::contact ? contacts : separated);
      if (!first && said[i] == Verdict::separated) first = i;
    }
    if (contacts < 4 || separated < 4 || 10 * (contacts + separated) < 9 * said.size()) return std::nullopt;
    return decided(
        Subnormals::kept,
        fmt::format("Subnormal numbers are numbers to it: it is right on {} of {} scenes in which every number that is "
                    "a length is subnormal, contacts and separations.",
                    contacts + separated, said.size()),
        {subject_.witness(queries[*first], said[*first], "every number that is a length is subnormal")});
  }

  // Answers that another mode of the caller's changes; no mode reaches a kernel in a process of its own.
  std::optional<std::size_t> changed_by_the_caller() {
    if (!subject_.is_built_in() || subject_.kernel().call.has_modes()) return std::nullopt;
    const Kernel flushed = called(subject_.kernel(), "flushed");
    const auto said = subject_.ask(flushed.template on<Real>(subject_.target()), queries_);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (said[i] == said_[i]) continue;
      ++changed;
      if (!witness_) {
        witness_ = subject_.witness(queries_[i], fmt::format("{}, {}", name(said_[i]), name(said[i])),
                                    "as it stands, and called with subnormal numbers flushed");
      }
    }
    return changed == 0 ? std::nullopt : std::optional(changed);
  }

  std::vector<FormAgreement> agreements() {
    std::vector<FormAgreement> all;
    for (const Kernel& form : kernels()) {
      if (form.predicate != subject_.kernel().predicate || form.entry != subject_.kernel().entry) continue;
      if (!form.has(precision_of<Real>) || form.exposes != Exposure::sides) continue;
      const Kernel flushed_form = called(form, "flushed");
      const auto kept = subject_.ask(form.on<Real>(scalar_target), queries_),
                 flushed = subject_.ask(flushed_form.on<Real>(scalar_target), queries_);
      FormAgreement agreement{form.id};
      for (std::size_t i = 0; i < queries_.size(); ++i) {
        ++agreement.asked;
        agreement.as_kept += said_[i] == kept[i];
        agreement.as_flushed += said_[i] == flushed[i];
        if (kept[i] == flushed[i]) continue;
        ++agreement.telling;
        if (!witness_ && is_decided(said_[i])) {
          witness_ = subject_.witness(queries_[i], said_[i],
                                      fmt::format("{} says {}, and {} with subnormal numbers flushed", form.id,
                                                  name(kept[i]), name(flushed[i])));
        }
      }
      all.push_back(agreement);
    }
    return all;
  }

  Subject<Real>& subject_;
  const Queries<Real> queries_;
  const std::vector<Verdict> said_;
  std::optional<DiagnosisWitness> witness_;
};

}  // namespace

template <class Real>
ProbeFinding subnormal_numbers(Subject<Real>& subject) {
  if (clear_queries<Real>(subject.kernel(), 1).empty())
    return unasked("This predicate has no queries here that are known to be far from every boundary.");
  return SubnormalProbe<Real>(subject).found();
}
template ProbeFinding subnormal_numbers(Subject<float>&);
template ProbeFinding subnormal_numbers(Subject<double>&);

}  // namespace axiscert::diagnosis
