// What a compiler made of the operations of a built-in form: fused, flushed,
// reassociated (kernel/permitted).
//
// Where a kernel answers otherwise than a form as it stands, some permissions
// can make that answer of the form, and others cannot. The one that makes all
// of them, where each other leaves some, is what the kernel's compiler does; if
// all together are needed it does several things; if they do not suffice the
// kernel is not that form.
#include <array>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/text/json.h"
#include "kernel/permitted/graph.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t near_count = 4096, each_family = 256;
constexpr std::size_t least_differing = 8;  // from which on an effect is taken to be there
constexpr std::size_t least_open = 64;      // queries that some permission would answer otherwise
constexpr std::size_t forms_tried = 12;     // of those that it agrees with most
constexpr std::size_t each_scene = 512;

// A value, and the part of permissions that makes it.
struct Explanation {
  Evaluated value;
  std::string_view part;
};
constexpr auto explanations = std::to_array<Explanation>({{Evaluated::fused, "fused"},
                                                          {Evaluated::flushed, "flushed"},
                                                          {Evaluated::faithful, "faithful"},
                                                          {Evaluated::reassociated, "factored"}});

struct RecordedForm {
  const Kernel* kernel;
  std::vector<std::size_t> differing;  // the queries that it answers otherwise
};

class EvaluationProbe {
 public:
  explicit EvaluationProbe(Subject<float>& subject) : subject_(subject) {
    const Kernel& kernel = subject.kernel();
    queries_ = sharp_queries<float>(kernel, subject.seed(), near_count);
    if (!clear_queries<float>(kernel, 1).empty()) {
      const Queries<float> small = scenes_of<float>(subject.predicate()).small(kernel);
      queries_.insert(queries_.end(), small.begin(), small.end());
    }
    for (const Family* family : families_of(subject.predicate(), kernel.entry)) {
      if (image_group(family->name) != nullptr || family->cost > 1) continue;
      for (std::uint64_t i = 0; i < each_family; ++i) queries_.push_back(family->make<float>(subject.seed(), i));
    }
    said_ = subject.ask(queries_);
  }

  ProbeFinding found() {
    const std::vector<RecordedForm> forms = nearest_forms();
    if (forms.empty())
      return unasked(
          "No built-in form of this predicate and entry is known to "
          "permissions.");
    for (const RecordedForm& form : forms) {
      if (form.differing.empty()) return with_losses(form, as_written(form));
    }
    for (const RecordedForm& form : forms) {
      if (form.differing.size() < least_differing || permitted(form, "wgsl") < form.differing.size()) continue;
      return with_losses(form, explained(form));
    }
    return undecided(
        fmt::format("It is no evaluation of a built-in form: of {}, the "
                    "nearest, it answers {} of {} queries "
                    "otherwise, and permissions explain {} of these.",
                    forms[0].kernel->id, forms[0].differing.size(), queries_.size(), permitted(forms[0], "wgsl")));
  }

 private:
  std::vector<RecordedForm> nearest_forms() {
    std::vector<RecordedForm> forms;
    for (const Kernel& form : kernels()) {
      const Kernel& kernel = subject_.kernel();
      if (form.predicate != kernel.predicate || form.entry != kernel.entry || !form.has(Precision::binary32)) continue;
      if (!form.is_reference || form.id.find('+') != form.id.npos || !permitted::recorder_of(form)) continue;
      const auto by_form = subject_.ask(form.on<float>(scalar_target), queries_);
      forms.push_back({&form, {}});
      for (std::size_t i = 0; i < queries_.size(); ++i) {
        if (is_decided(said_[i]) && said_[i] != by_form[i]) forms.back().differing.push_back(i);
      }
    }
    std::ranges::stable_sort(forms, {}, [](const RecordedForm& form) { return form.differing.size(); });
    if (forms.size() > forms_tried) forms.resize(forms_tried);
    return forms;
  }

  // How many of the answers that differ some evaluation gives that this part
  // permits.
  std::size_t permitted(const RecordedForm& form, std::string_view part) {
    std::size_t count = 0;
    for (const Verdict verdict : {Verdict::separated, Verdict::contact}) {
      Queries<float> queries;
      for (const std::size_t i : form.differing) {
        if (said_[i] == verdict) queries.push_back(queries_[i]);
      }
      const auto said = subject_.ask(worst(form, part, verdict), queries);
      count += static_cast<std::size_t>(std::ranges::count(said, verdict));
    }
    return count;
  }
  Implementation<float> worst(const RecordedForm& form, std::string_view part, Verdict verdict) const {
    return find_kernel(
               fmt::format("{}+{}-{}", form.kernel->id, part, verdict == Verdict::separated ? "misses" : "invents"))
        .on<float>(scalar_target);
  }

  ProbeFinding as_written(const RecordedForm& form) {
    std::size_t open = 0;
    const auto separated = subject_.ask(worst(form, "wgsl", Verdict::separated), queries_),
               contact = subject_.ask(worst(form, "wgsl", Verdict::contact), queries_);
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      open += is_decided(said_[i]) && separated[i] == Verdict::separated && contact[i] == Verdict::contact;
    }
    const Json measured = {{"form", form.kernel->id}, {"open", open}};
    if (open < least_open) {
      return undecided(fmt::format("It answers as {} does, on queries of which "
                                   "permissions leave {} open: too few to say.",
                                   form.kernel->id, open),
                       measured);
    }
    return decided(Evaluated::as_written,
                   fmt::format("It evaluates {} as it stands: it answers {} "
                               "queries as that does, of which permissions "
                               "leave {} open.",
                               form.kernel->id, queries_.size(), open),
                   {}, measured);
  }

  // With the deepest contact of everyday scenes that a compiler of shaders may separate, without barriers and behind
  // them.
  ProbeFinding with_losses(const RecordedForm& form, ProbeFinding finding) {
    const Oracles& oracles = oracles_of(subject_.kernel());
    Queries<float> scenes;
    for (const Family* family : families_of(subject_.predicate(), subject_.kernel().entry)) {
      if (family->trust_group != TrustGroup::scene || family->is_by_name) continue;
      for (std::uint64_t i = 0; i < each_scene; ++i) scenes.push_back(family->make<float>(subject_.seed(), i));
    }
    if (finding.value == not_known || !oracles.has_depth() || scenes.empty()) return finding;
    // The depth to which contacts are separated, and these.
    const auto lost = [&](std::string_view part, const Queries<float>& queries) {
      std::pair<double, Queries<float>> found;
      const auto separated = subject_.ask(worst(form, part, Verdict::separated), queries);
      for (std::size_t i = 0; i < queries.size(); ++i) {
        if (separated[i] != Verdict::separated || subject_.truth(queries[i]).verdict != Verdict::contact) continue;
        found.first = std::max(found.first, oracles.depth(queries[i]).value_or(0));
        found.second.push_back(queries[i]);
      }
      return found;
    };
    const auto [without, queries] = lost("wgsl", scenes);
    const double behind = lost("wgsl-kept", queries).first;
    finding.sentence += fmt::format(
        " As a shader, compiled in other ways, it may miss contacts of everyday scenes as deep as {:.2g} of the scene; "
        "with the translated vertices and the quotients behind barriers, {:.2g} (docs/gpu.md).",
        without, behind);
    finding.measured["shader_misses"] = {{"without_barriers", without}, {"behind_barriers", behind}};
    return finding;
  }

  // `faithful` permits nearly all answers near touching, those of other
  // compilers among them: it is looked at last.
  ProbeFinding explained(const RecordedForm& form) {
    const std::size_t all = form.differing.size();
    Json by_part = Json::object();
    std::vector<Evaluated> explaining;
    bool is_faithful = false;
    for (const Explanation& one : explanations) {
      const std::size_t count = permitted(form, one.part);
      by_part[std::string(one.part)] = count;
      if (count < all) continue;
      if (one.value == Evaluated::faithful) is_faithful = true;
      else explaining.push_back(one.value);
    }
    if (explaining.empty() && is_faithful) explaining.push_back(Evaluated::faithful);
    const Json measured = {{"form", form.kernel->id}, {"differ", all}, {"permitted", by_part}};
    const std::string facts = fmt::format("it answers {} of {} queries otherwise than {} as it stands", all,
                                          queries_.size(), form.kernel->id);
    if (std::ranges::all_of(form.differing,
                            [&](std::size_t i) { return subject_.truth(queries_[i]).verdict == said_[i]; }))
      return undecided(fmt::format("It is right where a form is not: {}, each time rightly.", facts), measured);
    if (explaining.size() > 1)
      return undecided(fmt::format("More than one permission makes all: {}, {}.", facts, by_part.dump()), measured);
    const std::size_t shown = form.differing.front();
    const std::vector<DiagnosisWitness> witnesses = {subject_.witness(
        queries_[shown], said_[shown], fmt::format("{} as it stands says the other", form.kernel->id))};
    if (explaining.size() == 1) {
      return decided(explaining.front(),
                     fmt::format("Its operations are {}: {}, and this "
                                 "permission makes all of these.",
                                 name(explaining.front()), facts),
                     witnesses, measured);
    }
    return decided(Evaluated::several,
                   fmt::format("Its operations are changed in several ways: "
                               "{}, and no single permission makes all of "
                               "these, but all together.",
                               facts),
                   witnesses, measured);
  }

  Subject<float>& subject_;
  Queries<float> queries_;
  std::vector<Verdict> said_;
};

}  // namespace

template <class Real>
ProbeFinding evaluation(Subject<Real>& subject) {
  if constexpr (sizeof(Real) == 4) {
    if (const auto why = why_not_sound(subject)) return undecided(*why);
    return EvaluationProbe(subject).found();
  } else {
    return unasked("Permissions are those of shaders: they are known in binary32.");
  }
}
template ProbeFinding evaluation(Subject<float>&);
template ProbeFinding evaluation(Subject<double>&);

}  // namespace axiscert::diagnosis
