#include "cli/commands/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.h"
#include "cli/ending.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"
#include "kernel/plugin/load.h"
#include "plans/plan_file.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/derived.h"
#include "reports/certificate/page.h"
#include "reports/certificate/statement.h"
#include "reports/gates/level.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Whether an id names a kernel that is built in, and nothing that would have to be loaded.
bool is_built_in(const std::string& id) {
  if (plugin::is_given_by_file(id)) return false;
  try {
    return !plugin::plugin_path(id) && find_kernel(id).file.empty();
  } catch (const Error&) {
    return false;
  }
}

// The subjects of the kernel that was given, by its files alone: nothing is loaded or started. Sets the id by which it
// could be loaded.
std::vector<SubjectStatement> subjects_given(const std::string& given, std::string& id) {
  id = given;
  if (is_built_in(given)) return {built_in_subject(given)};
  std::string path = given;
  std::error_code ignored;
  if (const auto known = plugin::plugin_path(given)) path = *known;
  else if (std::filesystem::is_regular_file(given, ignored))
    id = std::string(given.ends_with(".json") ? plugin::by_manifest : plugin::by_path) + given;
  else {
    std::vector<std::string_view> ids;
    for (const Kernel& kernel : kernels()) ids.push_back(kernel.id);
    throw Error(
        fmt::format("--kernel {}: is no file, and no kernel{} give the kernel's file, or its id as `axiscert "
                    "kernels` has it",
                    given, did_you_mean(given, ids)));
  }
  if (plugin::is_program(id, path)) return subjects_of(plugin::load_program(id, path));  // which starts nothing
  return {file_subject(path, "plugin")};
}

void require_subjects(const std::vector<SubjectStatement>& stated, const std::vector<SubjectStatement>& given,
                      const std::string& kernel, const std::string& name) {
  for (const SubjectStatement& subject : stated) {
    const std::string& what = subject.annotations.what;
    const auto is_same = [&](const SubjectStatement& other) { return other.annotations.what == what; };
    const auto found = std::find_if(given.begin(), given.end(), is_same);
    if (found == given.end()) {
      throw NotValid(fmt::format("{}: it is about another kernel: {} has no {}, and the certificate's is {}", name,
                                 kernel, what, axiscert::shown(subject.name)));
    }
    // Built-in kernels are made of the same sources.
    if (what == "built-in" && found->name != subject.name) {
      throw NotValid(
          fmt::format("{}: it is about another kernel: about {}, not {}", name, axiscert::shown(subject.name), kernel));
    }
    if (found->digest.sha256 == subject.digest.sha256) continue;
    throw NotValid(fmt::format("{}: it is about another kernel: the {} of {} has the SHA-256 {}, the certificate's {}",
                               name, what, kernel, found->digest.sha256, subject.digest.sha256));
  }
  if (given.size() > stated.size())
    throw NotValid(fmt::format("{}: it is about another kernel: {} has more files than it", name, kernel));
}

void require_plan_digest(const Certificate& certificate, const std::string& name) {
  const PlanMaterial& plan = certificate.predicate().materials.plan;
  const std::string digest = digest_of_json(plan.plan.json);
  if (plan.digest == digest) return;
  throw NotValid(fmt::format("{}: the digest of its plan is {}, but it states {}", name, digest, plan.digest));
}

// The signature with the key that was given, and what the predicate says of the signer. Returns what is to be said.
std::string signature_said(const Certificate& certificate, const std::optional<SigningKey>& key,
                           const VerifyOptions& options) {
  const CertificatePredicate& predicate = certificate.predicate();
  const std::string& name = options.certificate;
  if (key && !certificate.envelope)
    throw NotValid(fmt::format("{}: it is not signed, and --key {} asks for a signature", name, options.key));
  if (key) require_signature(*certificate.envelope, *key, name);
  if (certificate.envelope.has_value() != predicate.signed_by.has_value()) {
    throw NotValid(certificate.envelope
                       ? fmt::format("{}: it is in an envelope, and names no signer", name)
                       : fmt::format("{}: it is said to be {}, and is not signed", name, signer_sentence(predicate)));
  }
  if (!key) {
    if (!certificate.envelope) return "none: anybody may have written it";
    return fmt::format("NOT CHECKED: it is said to be {}; give the public key with --key", signer_sentence(predicate));
  }
  if (*predicate.signed_by != key->id()) {
    throw NotValid(fmt::format("{}: it is signed by the key {}, and names another signer, {}", name, key->id(),
                               axiscert::shown(Json(*predicate.signed_by).dump())));
  }
  return fmt::format("by the key {}, at {}", key->id(), predicate.signed_at.value_or("no stated time"));
}

// The kind of the kernel has to be that of its files.
void require_kind(const Certificate& certificate, const std::string& name) {
  const KernelKind kind = certificate.predicate().kernel.kind;
  for (const SubjectStatement& subject : certificate.statement.subject) {
    const std::string& what = subject.annotations.what;
    for (const KernelKind one : {KernelKind::replies, KernelKind::built_in}) {
      if ((kind == one) != (what == axiscert::name(one))) {
        throw NotValid(
            fmt::format("{}: its kernel is said to be {}, and its subject is {}", name, axiscert::name(kind), what));
      }
    }
  }
}

// A plan without its meshes.
Json without_meshes(Json plan) {
  const auto is_mesh = [](const std::string& family) { return family.starts_with("mesh/"); };
  Json families = Json::array(), files = Json::array();
  for (const Json& family : plan["families"]) {
    if (!is_mesh(family)) families.push_back(family);
    else
      for (const char* member : {"generators", "trials"}) plan[member].erase(family.get<std::string>());
  }
  for (const Json& file : plan["files"]) {
    if (file["kind"] != "mesh") files.push_back(file);
  }
  plan["families"] = families;
  plan["files"] = files;
  return plan;
}

// Throws NotValid for the first of them.
void require_none(std::vector<std::string> differences, const std::string& name) {
  if (differences.empty()) return;
  const std::string others = differences.size() == 1 ? "" : fmt::format("; {} more differ", differences.size() - 1);
  throw NotValid(fmt::format("{}: {}{}", name, differences.front(), others));
}

struct CheckedPlan {
  std::string said;
  bool is_checked = true;              // false: it is another axiscert's
  std::optional<Questions> here = {};  // the same as made here; its meshes are those that were given
};

// Holds the plan to the one that this axiscert makes of kernel, effort and seed, without the kernel.
CheckedPlan check_stated_plan(const CertificatePredicate& predicate, const VerifyOptions& options) {
  const std::string& name = options.certificate;
  const KernelStatement& kernel = predicate.kernel;
  const Json& stated = predicate.materials.plan.plan.json;
  if (kernel.kind == KernelKind::replies) return {"that of the replies, which is what their program was asked"};
  if (!is_made_by_this(predicate))
    return {"NOT CHECKED: made by another axiscert, whose families and numbers may be others", false};
  const Predicate& question = find_predicate(kernel.question);
  const auto entry = std::ranges::find(question.entries, std::string(kernel.entry), &PredicateEntry::name);
  if (entry == question.entries.end())
    throw NotValid(fmt::format("{}: {} has no entry {}", name, question.id, axiscert::shown(kernel.entry)));
  AbsentKernel absent{&question, static_cast<std::size_t>(entry - question.entries.begin()), kernel.precisions,
                      kernel.kind != KernelKind::built_in};
  PlanOfAbsent made = certified_plan_of(
      {kernel.id, predicate.asked.effort, stated["seed"].get<std::uint64_t>(), options.replies.meshes, options.threads},
      absent);
  const bool has_meshes = without_meshes(stated) != stated, is_without = has_meshes && options.replies.meshes.empty();
  const std::string differs =
      difference(Json::parse(canonical_json(portable_plan(made.json))), is_without ? without_meshes(stated) : stated);
  if (!differs.empty()) {
    throw NotValid(fmt::format("{}: its plan is not that of effort {}: here {}{}", name, predicate.asked.effort,
                               differs, has_meshes ? " (its meshes are given by --mesh)" : ""));
  }
  const char* const meshes = is_without ? "; its meshes NOT CHECKED: give them with --mesh" : "";
  return {fmt::format("that of its effort and seed{}", meshes), true, std::move(made.questions)};
}

struct CheckedPromises {
  std::string said;
  bool are_all_compared = true;
};

// Holds what is stated of the built-in kernels to what those of this axiscert declare, where it is of the same version.
CheckedPromises check_stated_promises(const CertificatePredicate& predicate, const std::string& name) {
  if (predicate.materials.axiscert.version != axiscert_version)
    return {"NOT COMPARED: made by another version, whose kernels may declare something else", false};
  const std::vector<std::string> stated_ids = predicate.materials.plan.plan.json["kernels"];
  std::vector<std::string> compared, others, differences;
  for (std::size_t k = 0; k < stated_ids.size(); ++k) {
    const std::string& id = k == 0 ? predicate.kernel.id : stated_ids[k];
    if (!is_built_in(id)) {
      others.push_back(axiscert::shown(id));
      continue;
    }
    const Kernel& kernel = find_kernel(id);
    for (const KernelMaterial& entry : predicate.materials.kernels) {
      if (entry.id != stated_ids[k]) continue;
      for (std::string& differs : declared_differences(entry, {}, kernel, entry.precision))
        differences.push_back(std::move(differs));
    }
    compared.push_back(id);
  }
  require_none(std::move(differences), name);
  std::string text;
  if (!compared.empty()) text = fmt::format("{}: as they declare here", fmt::join(compared, ", "));
  if (!others.empty())
    text += fmt::format("{}{} NOT COMPARED: not built in", text.empty() ? "" : "; ", fmt::join(others, ", "));
  return {text, others.empty()};
}

// A file with the id of a built-in kernel would have what is proved of that.
void require_own_id(const KernelStatement& kernel, const std::string& name) {
  if (kernel.kind != KernelKind::built_in && is_built_in(kernel.id))
    throw NotValid(fmt::format("{}: its kernel is of kind {}, and has the id of a built-in one, {}", name,
                               axiscert::name(kernel.kind), axiscert::shown(kernel.id)));
}

// Whether the kernel that was given is the one. Returns what is to be said; sets the id by which it could be run.
std::string kernel_sentence(const Certificate& certificate, const VerifyOptions& options, std::string& id) {
  const std::vector<SubjectStatement>& stated_subjects = certificate.statement.subject;
  const KernelKind kind = certificate.predicate().kernel.kind;
  const std::string& stated_id = certificate.predicate().kernel.id;
  const std::string& name = options.certificate;
  std::string given = options.kernel;
  if (given.empty() && kind == KernelKind::built_in) given = stated_id;
  if (!options.replies.replies.empty()) {
    // The names of the files are not what counts.
    std::vector<std::string> here, stated;
    for (const std::string& path : options.replies.replies) here.push_back(file_subject(path, "replies").digest.sha256);
    for (const SubjectStatement& subject : stated_subjects) stated.push_back(subject.digest.sha256);
    if (here != stated)
      throw NotValid(
          fmt::format("{}: it is about other replies than {}", name, fmt::join(options.replies.replies, ", ")));
    id = stated_id;
    return "the replies are those";
  }
  if (given.empty())
    return fmt::format("NOT CHECKED: give it with {}", kind == KernelKind::replies ? "--replies" : "--kernel");
  if (kind == KernelKind::built_in && options.kernel.empty() && !is_built_in(given))
    throw NotValid(fmt::format("{}: this axiscert has no kernel {}", name, axiscert::shown(given)));
  require_subjects(stated_subjects, subjects_given(given, id), given, name);
  return fmt::format("{} is the one", given);
}

std::string axiscert_sentence(const CertificatePredicate& predicate) {
  const AxiscertMaterial& made_by = predicate.materials.axiscert;
  if (is_made_by_this(predicate)) return "made by this version";
  return fmt::format("made by {}, sources {:.16}; this is {}, {:.16}", axiscert::shown(made_by.version),
                     made_by.sources, axiscert_version, source_digests().sources);
}

int verify_or_throw(const VerifyOptions& options) {
  if (!options.recheck.empty()) recheck_share(options.recheck);  // refused before anything is said
  std::optional<SigningKey> key;
  if (!options.key.empty()) key = SigningKey::public_from(options.key);
  const std::string& name = options.certificate;
  const Certificate certificate = read_certificate_file(name);
  const CertificatePredicate& predicate = certificate.predicate();
  const std::string signature = signature_said(certificate, key, options);
  require_kind(certificate, name);
  require_plan_digest(certificate, name);
  stretches_of(predicate, name);  // its plan is one
  require_effort(predicate, name);
  const CheckedPlan plan = check_stated_plan(predicate, options);
  require_own_id(predicate.kernel, name);
  // Its levels are said by its counts here, whoever made it.
  const Record record = require_derived(predicate, name);
  const CertificatePredicate derived = derived_predicate(predicate, record);
  if (plan.here) require_none(triangle_differences(predicate, *plan.here), name);
  const CheckedPromises promises = check_stated_promises(predicate, name);

  fmt::print("digest: {}\nsignature: {}\n", predicate.digest, signature);
  const std::string no_answers = no_answers_sentence(derived);
  if (!no_answers.empty()) fmt::print("kernel: {}\n", no_answers);
  fmt::print("certificate: {}\nasked: {}\nanswers: {}\n", made_sentence(predicate), asked_sentence(predicate),
             looked_sentence(predicate));
  std::string id;
  fmt::print("kernel: {}\n", kernel_sentence(certificate, options, id));
  fmt::print("axiscert: {}\nplan: {}\npromises: {}\n", axiscert_sentence(predicate), plan.said, promises.said);
  fmt::print(
      "counts: of all {} stretches of the plan; levels, numbers of queries, comparison and safe margin agree with "
      "them\n",
      thousands(predicate.materials.tallies.size()));
  fmt::print(
      "stated, and in no count: the search, the growths of the safe margin, the diagnosis, the planted faults, the "
      "witnesses{}\n",
      options.recheck.empty()
          ? fmt::format(
                "; and, but for a recheck, the counts of images,{} medians of critical radii{} findings of loading{}",
                plan.here ? "" : " numbers of triangles,", promises.are_all_compared ? " and" : ",",
                promises.are_all_compared ? "" : " and promises NOT COMPARED")
          : "");
  if (!options.recheck.empty()) {
    if (predicate.kernel.kind == KernelKind::replies && options.replies.replies.empty())
      throw Error("--recheck: give the replies that are to be judged again with --replies");
    if (id.empty()) {
      throw Error(fmt::format("--recheck: give the kernel that is to be run, {}, with --kernel",
                              axiscert::shown(predicate.kernel.id)));
    }
    if (!recheck_certificate(certificate, options, id)) return interrupted_code();
  }
  for (const GateLevel* each : badge_levels()) {
    const std::string level(each->name());
    const LevelState state = state_of_level(derived, level);
    fmt::print("{}: {}\n", state == LevelState::met ? claim_of_level(derived, level) + decided_text(derived) : level,
               axiscert::name(state));
  }
  fmt::print("VALID{}\n",
             plan.is_checked ? "" : " as far as it could be checked: its plan, and its words, are another axiscert's");
  return exit_done;
}

}  // namespace

int verify(const VerifyOptions& options) {
  try {
    return verify_or_throw(options);
  } catch (const NotValid& wrong) {
    std::fflush(stdout);
    fmt::print(stderr, "axiscert: NOT VALID: {}\n", wrong.what());
    return exit_requirement_failed;
  }
}

}  // namespace axiscert
