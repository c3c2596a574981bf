#include "cli/running/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <random>
#include <span>

#include "cli/commands.h"
#include "cli/options/certified_plan.h"
#include "cli/progress_line.h"
#include "cli/running/run_output.h"
#include "cli/running/stretch_crew.h"
#include "fuzz/campaign/parts/recheck.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/base/version.h"
#include "kernel/plugin/load.h"
#include "kernel/registry/self_check.h"
#include "reports/certificate/certificate.h"
#include "reports/certificate/page.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/certificate/statement/statement.h"

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
Json subjects_given(const std::string& given, std::string& id) {
  id = given;
  if (is_built_in(given)) return Json::array({built_in_subject(given)});
  std::string path = given;
  std::error_code ignored;
  if (const auto known = plugin::plugin_path(given)) path = *known;
  else if (std::filesystem::is_regular_file(given, ignored))
    id = std::string(given.ends_with(".json") ? plugin::by_manifest : plugin::by_path) + given;
  else {
    throw Error(
        fmt::format("--kernel {}: is no file, and no kernel; give the kernel's file, or its id as `axiscert "
                    "kernels` has it",
                    given));
  }
  if (plugin::is_program(id, path)) return subjects_of(plugin::load_program(id, path));  // which starts nothing
  return Json::array({file_subject(path, "plugin")});
}

std::string digest_in(const Json& subject) { return subject["digest"]["sha256"]; }

void require_subjects(const Json& stated, const Json& given, const std::string& kernel, const std::string& name) {
  for (const Json& subject : stated) {
    const auto is_same = [&](const Json& other) {
      return other["annotations"]["what"] == subject["annotations"]["what"];
    };
    const auto found = std::find_if(given.begin(), given.end(), is_same);
    const std::string what = subject["annotations"]["what"];
    if (found == given.end()) {
      throw NotValid(fmt::format("{}: it is about another kernel: {} has no {}, and the certificate's is {}", name,
                                 kernel, what, axiscert::shown(subject["name"].get<std::string>())));
    }
    // Built-in kernels are made of the same sources.
    if (what == "built-in" && (*found)["name"] != subject["name"]) {
      throw NotValid(fmt::format("{}: it is about another kernel: about {}, not {}", name,
                                 axiscert::shown(subject["name"].get<std::string>()), kernel));
    }
    if (digest_in(*found) == digest_in(subject)) continue;
    throw NotValid(fmt::format("{}: it is about another kernel: the {} of {} has the SHA-256 {}, the certificate's {}",
                               name, what, kernel, digest_in(*found), digest_in(subject)));
  }
  if (given.size() > stated.size())
    throw NotValid(fmt::format("{}: it is about another kernel: {} has more files than it", name, kernel));
}

// "1%", "0.5%" or a share from 0 to 1, as a share.
double share_of(const std::string& given) {
  const bool is_percent = given.ends_with('%');
  const char* const end = given.data() + given.size() - (is_percent ? 1 : 0);
  double share = 0;
  const auto [stop, problem] = std::from_chars(given.data(), end, share);
  if (is_percent) share /= 100;
  if (problem != std::errc() || stop != end || !(share > 0 && share <= 1))
    throw Error(fmt::format("--recheck {}: give a share above 0, at most 100%, as in 1%", given));
  return share;
}

// Throws Error where the plan of the certificate is not the one that this axiscert makes.
void require_same_plan(const Certificate& certificate, const VerifyOptions& options, const Json& plan,
                       std::uint64_t units_each) {
  const Json& materials = certificate.predicate()["materials"];
  const std::string differs = difference(Json::parse(canonical_json(portable_plan(plan))), materials["plan"]["plan"]);
  if (differs.empty() && units_each == materials["plan"]["units_per_stretch"].get<std::uint64_t>()) return;
  throw Error(fmt::format(
      "{}: cannot be rechecked here: it was made by axiscert {}, sources {:.16}, and this is {}, {:.16}{}",
      options.certificate, axiscert::shown(materials["axiscert"]["version"].get<std::string>()),
      materials["axiscert"]["sources"].get<std::string>(), axiscert_version, source_digests().sources,
      differs.empty() ? "" : fmt::format("; here {} (files of its plan are given by --mesh and --queries)", differs)));
}

// The claim of the replies, as the certificate has it: reply_plan holds it to what they are.
ReplyOptions with_claim(ReplyOptions options, const Json& predicate) {
  const Json& plan = predicate["materials"]["plan"]["plan"];
  const Json claim = plan.value("replies", Json::object());
  const auto text_of = [&](const char* member) {
    const Json text = claim.is_object() ? claim.value(member, Json()) : Json();
    return text.is_string() ? text.get<std::string>() : "";
  };
  options.id = predicate["kernel"]["id"].get<std::string>();
  options.touching = predicate["kernel"]["touching"].get<std::string>();
  if (std::find(touching_names.begin(), touching_names.end(), options.touching) == touching_names.end())
    throw Error(fmt::format("the certificate says of a touching sphere {}, which is no answer",
                            axiscert::shown(options.touching)));
  options.claim.conforms_to = text_of("conforms_to");
  options.claim.formulae = text_of("formulae");
  return options;
}

void recheck_certificate(const Certificate& certificate, const VerifyOptions& options, const std::string& id) {
  const Json& predicate = certificate.predicate();
  const Json& tallies = predicate["materials"]["tallies"];
  const double share = share_of(options.recheck);
  std::vector<std::uint64_t> numbers;
  for (const Json& tally : tallies) numbers.push_back(tally["stretch"].get<std::uint64_t>());
  if (numbers.empty())
    throw Error(fmt::format("{}: no stretch of its plan was done: there is nothing to recheck", options.certificate));
  // Whoever made the certificate does not know which stretches are taken.
  const std::uint64_t nonce = options.recheck_seed ? *options.recheck_seed : std::random_device()();
  const std::string text = fmt::format("{} {}", certificate.digest(), nonce);
  const auto mixed = sha256(std::as_bytes(std::span(text)));
  std::uint64_t seed = 0;
  for (std::size_t i = 0; i < 8; ++i) seed = seed << 8 | static_cast<std::uint64_t>(mixed[i]);
  const std::vector<std::uint64_t> sample = sample_of(numbers, share, seed);
  const bool is_run = predicate["kernel"]["kind"] != "replies";
  fmt::print("recheck: will {} {} on {} of {} stretches of its plan, on this machine\n",
             is_run ? "run" : "judge the replies of", is_run ? id : axiscert::shown(id), sample.size(), numbers.size());
  std::fflush(stdout);

  ReplyPlan replies;
  Plan plan;
  std::uint64_t units_each = 1;
  if (predicate["kernel"]["kind"] == "replies") {
    replies = reply_plan(with_claim(options.replies, predicate));
    plan = replies.plan;
    units_each = Stretches::default_units_each(plan);
    require_same_plan(certificate, options, plan_json(plan, planned(plan), {}), units_each);
  } else {
    const PlanFile file =
        certified_plan({id, predicate["asked"]["effort"], predicate["asked"]["seed"].get<std::uint64_t>(),
                        options.replies.meshes, options.threads});
    plan = plan_of(file);
    units_each = file.units_each;
    require_same_plan(certificate, options, file.json["plan"], units_each);
  }
  plan.threads = threads_of(options.threads);
  for (const std::string& target : targets_of(plan)) require_uncontracted(target);
  const Stretches stretches(plan, units_each);
  for (const std::uint64_t number : sample) {
    if (number >= stretches.count())
      throw Error(fmt::format("{}: its plan has no stretch {}", options.certificate, number));
  }
  std::vector<std::string> differences;
  std::size_t done = 0;
  ProgressLine progress("verify: recheck");
  const std::atomic<bool>& interrupted = watch_for_interrupts();
  run_stretches(plan, stretches, sample, interrupted, progress.report(), [&](const Entry& entry) {
    const auto at = std::lower_bound(numbers.begin(), numbers.end(), entry.stretch);
    const Json& stated = tallies[static_cast<std::size_t>(at - numbers.begin())]["sha256"];
    const std::vector<std::string> digests = tally_digests(entry);
    for (std::size_t k = 0; k < digests.size(); ++k) {
      if (k < stated.size() && stated[k] == digests[k]) continue;
      differences.push_back(fmt::format("the tally of {} on {} has the digest {:.16} here, and {:.16} in it",
                                        plan.kernels[k]->id, stretches.text(entry.stretch), digests[k],
                                        k < stated.size() ? stated[k].get<std::string>() : "none"));
    }
    ++done;
  });
  progress.clear();
  if (done != sample.size())
    throw Error(fmt::format("--recheck: interrupted after {} of {} stretches", done, sample.size()));
  if (!differences.empty()) {
    std::sort(differences.begin(), differences.end());
    throw NotValid(fmt::format("{}: the recheck comes out otherwise: {}{} (--recheck-seed {} takes the same sample)",
                               options.certificate, differences.front(),
                               differences.size() == 1 ? "" : fmt::format("; {} more differ", differences.size() - 1),
                               nonce));
  }
  fmt::print("recheck: {} stretches judged again, every tally the same (--recheck-seed {})\n", sample.size(), nonce);
}

// Stretches in rising order, each once: what the recheck looks up by.
void require_order(const Certificate& certificate, const std::string& name) {
  std::int64_t before = -1;
  for (const Json& tally : certificate.predicate()["materials"]["tallies"]) {
    const auto stretch = tally["stretch"].get<std::uint64_t>();
    if (stretch > INT64_MAX || static_cast<std::int64_t>(stretch) <= before)
      throw Error(fmt::format("{}: its stretches are not in rising order, each once", name));
    before = static_cast<std::int64_t>(stretch);
  }
}

void require_plan_digest(const Certificate& certificate, const std::string& name) {
  const Json& plan = certificate.predicate()["materials"]["plan"];
  const std::string digest = digest_of_json(plan["plan"]);
  if (plan["digest"] == digest) return;
  throw NotValid(fmt::format("{}: the digest of its plan is {}, but it states {}", name, digest,
                             plan["digest"].get<std::string>()));
}

int verify_or_throw(const VerifyOptions& options) {
  if (!options.recheck.empty()) share_of(options.recheck);  // refused before anything is said
  std::optional<SigningKey> key;
  if (!options.key.empty()) key = SigningKey::public_from(options.key);
  const std::string& name = options.certificate;
  const Certificate certificate = read_certificate_file(name);
  const Json& predicate = certificate.predicate();
  require_order(certificate, name);
  require_plan_digest(certificate, name);
  fmt::print("digest: {}\n", certificate.digest());

  if (key) {
    if (!certificate.envelope)
      throw NotValid(fmt::format("{}: it is not signed, and --key {} asks for a signature", name, options.key));
    require_signature(*certificate.envelope, *key, name);
    fmt::print("signature: by the key {}, at {}\n", key->id(),
               predicate["signed_at"].is_null() ? "no stated time" : predicate["signed_at"].get<std::string>());
  } else {
    fmt::print("signature: {}\n", certificate.envelope ? "NOT CHECKED: give the public key with --key"
                                                       : "none: anybody may have written it");
  }

  const std::string kind = predicate["kernel"]["kind"], stated_id = predicate["kernel"]["id"];
  std::string given = options.kernel, id;
  if (given.empty() && kind == "built-in") given = stated_id;
  if (!options.replies.replies.empty()) {
    Json subjects = Json::array();
    for (const std::string& path : options.replies.replies) subjects.push_back(file_subject(path, "replies"));
    if (subjects != certificate.statement["subject"]) {
      // The names of the files are not what counts.
      std::vector<std::string> here, stated;
      for (const Json& subject : subjects) here.push_back(digest_in(subject));
      for (const Json& subject : certificate.statement["subject"]) stated.push_back(digest_in(subject));
      if (here != stated)
        throw NotValid(
            fmt::format("{}: it is about other replies than {}", name, fmt::join(options.replies.replies, ", ")));
    }
    id = stated_id;
    fmt::print("kernel: the replies are those\n");
  } else if (given.empty()) {
    fmt::print("kernel: NOT CHECKED: give it with {}\n", kind == "replies" ? "--replies" : "--kernel");
  } else {
    if (kind == "built-in" && options.kernel.empty() && !is_built_in(given))
      throw NotValid(fmt::format("{}: this axiscert has no kernel {}", name, axiscert::shown(given)));
    const Json subjects = subjects_given(given, id);
    require_subjects(certificate.statement["subject"], subjects, given, name);
    fmt::print("kernel: {} is the one\n", given);
  }
  const Json& axiscert = predicate["materials"]["axiscert"];
  const std::string version = axiscert["version"];
  fmt::print("axiscert: {}\n",
             axiscert["sources"] == source_digests().sources
                 ? "made by this version"
                 : fmt::format("made by {}, sources {:.16}; this is {}, {:.16}", axiscert::shown(version),
                               axiscert["sources"].get<std::string>(), axiscert_version, source_digests().sources));
  if (!options.recheck.empty()) {
    if (kind == "replies" && options.replies.replies.empty())
      throw Error("--recheck: give the replies that are to be judged again with --replies");
    if (id.empty())
      throw Error(
          fmt::format("--recheck: give the kernel that is to be run, {}, with --kernel", axiscert::shown(stated_id)));
    recheck_certificate(certificate, options, id);
  }
  for (const char* level : {"exact", "conservative", "logic"})
    fmt::print("{}: {}\n", level, state_of_level(certificate.statement, level));
  fmt::print("VALID\n");
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
