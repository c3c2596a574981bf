// The built-in kernel whose wrong verdicts a kernel shares, on queries on which the built-in kernels differ.
#include <cmath>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/text/json.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t sharp_count = 4096, general_count = 512, family_count = 128;
// A share of the queries on which forms differ, below which a kernel is not like any of them.
constexpr double least_share = 0.9;
// Queries on which both have to be wrong: right kernels agree with any form where that is right.
constexpr std::size_t least_shared = 16;

struct FormCount {
  std::string id;
  std::vector<Verdict> said;
  std::size_t agrees = 0;
  std::vector<std::string> same = {};  // of other kernels with the same verdicts on every query
};

template <class Real>
Queries<Real> telling_queries(Subject<Real>& subject) {
  const Kernel& kernel = subject.kernel();
  Queries<Real> queries = sharp_queries<Real>(kernel, subject.seed(), sharp_count);
  const Queries<Real> general = queries_of_general<Real>(kernel, subject.seed(), general_count);
  queries.insert(queries.end(), general.begin(), general.end());
  if (!scenes_of<Real>(subject.predicate()).near_tie) return queries;  // the sharp ones are of the families already
  for (const Family* family : families_of(subject.predicate())) {
    if (image_group(family->name) != nullptr || family->cost > 1) continue;
    for (std::uint64_t i = 0; i < family_count; ++i) queries.push_back(family->make<Real>(subject.seed(), i));
  }
  return queries;
}

// Whether x agrees with the kernel so much more often than y that chance does not explain it: on the queries where the
// two differ, by four standard deviations of a coin.
bool is_clearly_nearer(const FormCount& x, const FormCount& y, const std::vector<Verdict>& kernel) {
  double with_x = 0, with_y = 0;
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    if (x.said[i] == y.said[i]) continue;
    with_x += kernel[i] == x.said[i];
    with_y += kernel[i] == y.said[i];
  }
  return with_x - with_y > 4 * std::sqrt(with_x + with_y);
}

// Queries by who is wrong on them.
struct SharedErrors {
  std::size_t both = 0, kernel = 0, form = 0;  // the last two alone

  bool are_enough() const { return both >= least_shared; }
  // The kernel is wrong where the form is, and right where it is right.
  bool are_the_same() const {
    return static_cast<double>(both) >= least_share * static_cast<double>(both + kernel + form);
  }
};

SharedErrors shared_errors(const std::vector<Verdict>& truth, const std::vector<Verdict>& kernel,
                           const std::vector<Verdict>& form) {
  SharedErrors errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == Verdict::invalid) continue;
    const bool of_kernel = kernel[i] != truth[i], of_form = form[i] != truth[i];
    errors.both += of_kernel && of_form;
    errors.kernel += of_kernel && !of_form;
    errors.form += of_form && !of_kernel;
  }
  return errors;
}

// The forms with their verdicts on the queries on which not all agree and the kernel decides; equal forms are one.
template <class Real>
std::vector<FormCount> forms_on(Subject<Real>& subject, Queries<Real>& queries, std::vector<Verdict>& said) {
  std::vector<FormCount> forms;
  for (const Kernel& form : kernels()) {
    const Kernel& kernel = subject.kernel();
    if (form.predicate != kernel.predicate || form.entry != kernel.entry || !form.has(precision_of<Real>)) continue;
    forms.push_back({form.id, subject.ask(form.on<Real>(scalar_target), queries)});
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (!is_decided(said[i])) continue;
    if (std::ranges::all_of(forms, [&](const FormCount& form) { return form.said[i] == forms[0].said[i]; })) continue;
    queries[kept] = queries[i];
    said[kept] = said[i];
    for (FormCount& form : forms) form.said[kept] = form.said[i];
    ++kept;
  }
  queries.resize(kept);
  said.resize(kept);
  std::vector<FormCount> different;
  for (FormCount& form : forms) {
    form.said.resize(kept);
    const auto same = std::ranges::find(different, form.said, &FormCount::said);
    if (same != different.end()) {
      same->same.push_back(form.id);
      continue;
    }
    for (std::size_t i = 0; i < kept; ++i) form.agrees += form.said[i] == said[i];
    different.push_back(std::move(form));
  }
  std::ranges::stable_sort(different, std::greater(), &FormCount::agrees);
  return different;
}

}  // namespace

template <class Real>
ProbeFinding nearest_form(Subject<Real>& subject) {
  if (const auto why = why_not_sound(subject)) return undecided(*why);
  Queries<Real> queries = telling_queries(subject);
  std::vector<Verdict> said = subject.ask(queries);
  const std::vector<FormCount> forms = forms_on(subject, queries, said);
  if (forms.empty()) return unasked("No built-in kernel takes the numbers in this entry.");
  if (forms.size() == 1) return unasked("The built-in kernels of this predicate and entry agree on every query asked.");
  if (queries.empty()) return undecided("It decides no query on which the built-in kernels differ.");
  const FormCount &best = forms[0], &second = forms[1];
  const auto share = [&](const FormCount& form) {
    return static_cast<double>(form.agrees) / static_cast<double>(queries.size());
  };
  std::vector<Verdict> truth;
  for (const Numbers<Real>& query : queries) truth.push_back(subject.truth(query).verdict);
  const SharedErrors errors = shared_errors(truth, said, best.said);
  Json measured = {{"queries", queries.size()},
                   {"both_wrong", errors.both},
                   {"kernel_wrong", errors.kernel},
                   {"form_wrong", errors.form},
                   {"forms", Json::array()}};
  for (std::size_t k = 0; k < std::min<std::size_t>(forms.size(), 5); ++k) {
    measured["forms"].push_back({{"kernel", forms[k].id}, {"agrees", forms[k].agrees}, {"same", forms[k].same}});
  }
  const std::string facts =
      fmt::format("with {} on {} of {} queries on which the built-in kernels differ ({:.1f} %), with {} on {:.1f} %",
                  best.id, best.agrees, queries.size(), 100 * share(best), second.id, 100 * share(second));
  if (share(best) < least_share)
    return undecided("It is like no built-in kernel: it agrees most " + facts + ".", measured);
  // One of two forms alone has every answer, or one has clearly more.
  if (best.agrees != queries.size() && !is_clearly_nearer(best, second, said)) {
    return undecided("Two built-in kernels are about as near: it agrees " + facts + ".", measured);
  }
  const std::string wrong = fmt::format("both are wrong on {} of these, it alone on {}, and {} alone on {}",
                                        errors.both, errors.kernel, best.id, errors.form);
  if (errors.both + errors.kernel == 0) {
    return undecided(fmt::format("It is right on all {} queries on which the built-in kernels differ: it has no errors "
                                 "that it could share with one.",
                                 queries.size()),
                     measured);
  }
  if (!errors.are_enough() || !errors.are_the_same()) {
    return undecided(fmt::format("It agrees most {}, but its errors are not those of {}: {}.", facts, best.id, wrong),
                     measured);
  }
  std::vector<DiagnosisWitness> witnesses;
  for (std::size_t i = 0; i < queries.size() && witnesses.empty(); ++i) {
    if (best.said[i] == second.said[i] || said[i] != best.said[i]) continue;
    witnesses.push_back(subject.witness(
        queries[i], said[i],
        fmt::format("{} says {}, and {} {}", best.id, name(best.said[i]), second.id, name(second.said[i]))));
  }
  return {best.id, fmt::format("It agrees most {}; {}.", facts, wrong), std::move(witnesses), std::move(measured)};
}
template ProbeFinding nearest_form(Subject<float>&);
template ProbeFinding nearest_form(Subject<double>&);

}  // namespace axiscert::diagnosis
