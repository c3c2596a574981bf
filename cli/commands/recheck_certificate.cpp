#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <random>
#include <set>
#include <span>

#include "fuzz/text/json_form.h"
#include "plans/plan_file.h"
#include "cli/ending.h"
#include "cli/progress_line.h"
#include "cli/commands/planned_run.h"
#include "cli/commands/run_output.h"
#include "cli/commands/verify.h"
#include "fuzz/campaign/gathered.h"
#include "fuzz/campaign/stretch.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/merge.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/base/version.h"
#include "kernel/registry/self_check.h"
#include "reports/certificate/derived.h"
#include "reports/certificate/materials.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/statement.h"

namespace axiscert {
std::vector<std::string> declared_differences(const KernelMaterial& stated, const std::vector<FileInfo>& plugins,
                                              const Kernel& kernel, Precision precision) {
  std::vector<std::string> differences;
  const Json entry = without_fractions(json_of(kernel_record(plugins, kernel, precision)));
  for (const auto& [member, here] : entry.items()) {
    const bool is_elsewhere = member == "id" || member == "precision" || member == "families" ||
                              member == "critical_radius" || member == "cause";
    const Json* found = stated.declared.find(member);
    const Json said = found ? *found : Json();
    if (is_elsewhere || canonical_json(said) == canonical_json(here)) continue;
    differences.push_back(fmt::format("{} in {} is stated with another {}: here {}, in it {}", kernel.id,
                                      name(precision), member, here.dump(), axiscert::shown(said.dump())));
  }
  return differences;
}

std::vector<std::string> triangle_differences(const CertificatePredicate& predicate, const Questions& questions) {
  std::vector<std::string> differences;
  const CampaignResult all = planned(questions);
  for (const CellResult& cell : all.cells) {
    const Source& source = *questions.sources[cell.source];
    const std::uint64_t triangles = source.base_triangles(cell.precision, cell.queries);
    for (const KernelMaterial& entry : predicate.materials.kernels) {
      const FamilyMaterial* family = entry.families.find(source.name());
      if (entry.precision != cell.precision || family == nullptr || family->base_triangles == triangles) continue;
      const std::string& id = entry.id == portable_id ? predicate.kernel.id : entry.id;
      differences.push_back(fmt::format("{} in {} on {} is stated with another base_triangles: here {}",
                                        axiscert::shown(id), name(cell.precision), source.name(), triangles));
    }
  }
  return differences;
}

namespace {

// The claim of the replies, as the certificate has it: reply_plan holds it to what they are.
ReplyOptions with_claim(ReplyOptions options, const CertificatePredicate& predicate) {
  const Json& plan = predicate.materials.plan.plan.json;
  const Json claim = plan.value("replies", Json::object());
  const auto text_of = [&](const char* member) {
    const Json text = claim.is_object() ? claim.value(member, Json()) : Json();
    return text.is_string() ? text.get<std::string>() : "";
  };
  options.id = predicate.kernel.id;
  options.touching = name(predicate.kernel.touching);
  options.claim.conforms_to = text_of("conforms_to");
  options.claim.formulae = text_of("formulae");
  options.may_decline = predicate.kernel.may_decline;
  if (const std::string sides = text_of("sides"); !sides.empty()) options.sides = sides;
  if (claim.is_object() && claim.value("margin", Json()).is_number()) options.margin = claim["margin"].get<double>();
  return options;
}

// The plan that is run again, and what of it has to outlive it.
struct PlanHere {
  ReplyPlan replies;
  Plan plan;
  std::uint64_t units_each = 1;
};

PlanHere plan_here(const Certificate& certificate, const VerifyOptions& options, const std::string& id) {
  const CertificatePredicate& predicate = certificate.predicate();
  const MaterialsStatement& materials = predicate.materials;
  PlanHere here;
  Json json;
  if (predicate.kernel.kind == KernelKind::replies) {
    here.replies = reply_plan(with_claim(options.replies, predicate));
    here.plan = here.replies.plan;
    here.units_each = Stretches::default_units_each(here.plan.questions);
    json = json_of(plan_record(here.plan));
  } else {
    const PlanFile file = certified_plan(
        {id, predicate.asked.effort, predicate.asked.seed.value, options.replies.meshes, options.threads});
    here.plan = plan_of(file);
    here.units_each = file.units_each;
    json = file.json["plan"];
  }
  const std::string differs = difference(Json::parse(canonical_json(portable_plan(json))), materials.plan.plan.json);
  if (!differs.empty() || here.units_each != materials.plan.units_per_stretch.value) {
    throw Error(fmt::format(
        "{}: cannot be rechecked here: it was made by axiscert {}, sources {:.16}, and this is {}, {:.16}{}",
        options.certificate, axiscert::shown(materials.axiscert.version), materials.axiscert.sources, axiscert_version,
        source_digests().sources,
        differs.empty() ? ""
                        : fmt::format("; here {} (files of its plan are given by --mesh and --queries)", differs)));
  }
  here.plan.running.threads = threads_of(options.threads);
  for (const std::string& target : targets_of(here.plan.answerers.kernels, here.plan.running.target))
    require_uncontracted(target);
  return here;
}

// The stretches that are taken: whoever made the certificate does not know which.
std::vector<std::uint64_t> sample_taken(const Certificate& certificate, double share, std::uint64_t nonce) {
  std::vector<std::uint64_t> numbers(certificate.predicate().materials.tallies.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  const std::string text = fmt::format("{} {}", certificate.predicate().digest, nonce);
  const auto mixed = sha256(std::as_bytes(std::span(text)));
  std::uint64_t seed = 0;
  for (std::size_t i = 0; i < 8; ++i) seed = seed << 8 | static_cast<std::uint64_t>(mixed[i]);
  return sample_of(numbers, share, seed);
}

// How a stretch that was done again differs from what is stated of it; empty where it does not.
std::string difference_of_tally(const TallyMaterial& stated, const TallyMaterial& again,
                                const std::vector<const Kernel*>& kernels) {
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    const std::string who = fmt::format("the tally of {} on {}", kernels[k]->id, again.of);
    const Json &said = stated.counts[k].json, &here = again.counts[k].json;
    if (canonical_json(said) != canonical_json(here)) {
      const std::string differs = difference(Json::parse(canonical_json(here)), said);
      return fmt::format("{} has other counts: here {}", who, differs);
    }
    if (stated.sha256[k] != again.sha256[k]) {
      return fmt::format("{} has the digest {:.16} here, and {:.16} in it", who, again.sha256[k], stated.sha256[k]);
    }
  }
  return "";
}

// A kernel's entry in the certificate; the first kernel has another id there.
const KernelMaterial& stated_entry(const CertificatePredicate& predicate, const std::vector<const Kernel*>& kernels,
                                   std::size_t k, Precision precision) {
  const std::string id = predicate.materials.plan.plan.json["kernels"][k];
  for (const KernelMaterial& entry : predicate.materials.kernels) {
    if (entry.id == id && entry.precision == precision) return entry;
  }
  throw NotValid(fmt::format("it has no counts of {} in {}", kernels[k]->id, name(precision)));
}

// Compares what each kernel says of itself, as it was loaded here, and how many triangles its queries share: levels
// rest on both.
void recheck_entries(const CertificatePredicate& predicate, const Questions& questions, const Answerers& answerers,
                     std::vector<std::string>& differences) {
  const auto add = [&](const std::vector<std::string>& found) {
    differences.insert(differences.end(), found.begin(), found.end());
  };
  const std::vector<const Kernel*>& kernels = answerers.kernels;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    std::vector<FindingRecord> found;
    Json stated_findings = Json::array();
    put_loading_findings(found, *kernels[k]);
    const std::string id = predicate.materials.plan.plan.json["kernels"][k];
    for (const FindingMaterial& finding : predicate.materials.findings) {
      const bool is_its = finding.kernel == id || (k == 0 && finding.kernel == predicate.kernel.id);
      if (is_its && !finding.family) stated_findings.push_back(json_of(finding.detail));
    }
    Json details = Json::array();
    for (const FindingRecord& finding : found) details.push_back(finding.detail);
    if (canonical_json(details) != canonical_json(stated_findings)) {
      differences.push_back(fmt::format("{} has other findings of loading: here {}, in it {}", kernels[k]->id,
                                        details.dump(), axiscert::shown(stated_findings.dump())));
    }
    for (const Precision precision : questions.precisions) {
      if (kernels[k]->has(precision))
        add(declared_differences(stated_entry(predicate, kernels, k, precision), answerers.plugins, *kernels[k],
                                 precision));
    }
  }
  add(triangle_differences(predicate, questions));
}

// Asks about the images of each family of the sample again. Returns how many families those are.
std::size_t recheck_images(const CertificatePredicate& predicate, const Plan& plan, const Stretches& stretches,
                           const std::vector<std::uint64_t>& sample, std::vector<std::string>& differences) {
  const auto& [questions, answerers, judging, running] = plan;
  const std::vector<const Kernel*>& kernels = answerers.kernels;
  std::set<std::size_t> cells;
  for (const std::uint64_t number : sample) {
    const Stretch stretch = stretches.at(number);
    if (image_group(questions.sources[stretch.source]->name()) != nullptr) cells.insert(stretch.cell);
  }
  const CampaignResult all = planned(questions);
  for (const std::size_t c : cells) {
    const CellResult& cell = all.cells[c];
    const SeededSource of{*questions.sources[cell.source], questions.seed, cell.precision};
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      const auto asymmetry = asymmetry_of(of, cell.queries, *kernels[k], answerers.replies.get(), running);
      if (!asymmetry) continue;
      const Json here = without_fractions(json_of(invariance_of(of, *asymmetry)));
      const FamilyMaterial* family =
          stated_entry(predicate, kernels, k, cell.precision).families.find(of.source.name());
      const Json stated = family && family->invariance ? family->invariance->json : Json();
      if (canonical_json(here) == canonical_json(stated)) continue;
      differences.push_back(fmt::format("the images of {} in {}, asked of {}, come to something else: here {}",
                                        of.source.name(), name(cell.precision), kernels[k]->id,
                                        difference(Json::parse(canonical_json(here)), stated)));
    }
  }
  return cells.size();
}

// Compares what of a critical radius does not add up by stretch; the result is of all stretches.
void recheck_radii(const CertificatePredicate& predicate, const std::vector<Precision>& precisions,
                   const std::vector<const Kernel*>& kernels, const CampaignResult& result,
                   std::vector<std::string>& differences) {
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    for (const Precision precision : precisions) {
      if (!kernels[k]->has(precision)) continue;
      CriticalRadiusTally radii;
      for (const CellResult& cell : result.cells) {
        if (cell.precision == precision) merge_fields(radii, cell.tallies[k].critical_radius);
      }
      const Json here = without_fractions(json_of(summary_of(std::move(radii))));
      const Json& stated = stated_entry(predicate, kernels, k, precision).declared.at("critical_radius");
      if (canonical_json(here) == canonical_json(stated)) continue;
      differences.push_back(fmt::format("the critical radius of {} in {}: here {}", kernels[k]->id, name(precision),
                                        difference(Json::parse(canonical_json(here)), stated)));
    }
  }
}

}  // namespace

double recheck_share(const std::string& given) {
  const bool is_percent = given.ends_with('%');
  const char* const end = given.data() + given.size() - (is_percent ? 1 : 0);
  double share = 0;
  const auto [stop, problem] = std::from_chars(given.data(), end, share);
  if (is_percent) share /= 100;
  if (problem != std::errc() || stop != end || !(share > 0 && share <= 1))
    throw Error(fmt::format("--recheck {}: give a share above 0, at most 100%, as in 1%", given));
  return share;
}

bool recheck_certificate(const Certificate& certificate, const VerifyOptions& options, const std::string& id) {
  const CertificatePredicate& predicate = certificate.predicate();
  const std::vector<TallyMaterial>& tallies = predicate.materials.tallies;
  const std::uint64_t nonce = options.recheck_seed ? *options.recheck_seed : std::random_device()();
  const std::vector<std::uint64_t> sample = sample_taken(certificate, recheck_share(options.recheck), nonce);
  fmt::print("recheck: will {} {} on {} of {} stretches of its plan, on this machine\n",
             predicate.kernel.kind != KernelKind::replies ? "run" : "judge the replies of",
             predicate.kernel.kind != KernelKind::replies ? id : axiscert::shown(id), sample.size(), tallies.size());
  std::fflush(stdout);

  const PlanHere here = plan_here(certificate, options, id);
  const Stretches stretches(here.plan.questions, here.units_each);
  if (stretches.count() != tallies.size())
    throw Error(fmt::format("{}: its plan has {} stretches here, and {} in it", options.certificate, stretches.count(),
                            tallies.size()));
  const bool is_whole = sample.size() == tallies.size();
  const std::vector<const Kernel*>& kernels = here.plan.answerers.kernels;
  GatheredStretches gathered(here.plan.questions, kernels.size(), stretches);
  std::vector<std::string> differences;
  recheck_entries(predicate, here.plan.questions, here.plan.answerers, differences);
  std::size_t done = 0, images = 0;
  {
    ProgressLine progress("verify: recheck");
    const std::atomic<bool>& interrupted = watch_for_interrupts();
    run_stretches(here.plan, stretches, sample, interrupted, progress.report(), [&](const Entry& entry) {
      std::string differs =
          difference_of_tally(tallies[entry.stretch], tally_of_stretch(kernels, stretches, entry), kernels);
      if (!differs.empty()) differences.push_back(std::move(differs));
      if (is_whole) gathered.add(entry);
      ++done;
    });
  }
  if (done != sample.size()) {
    fmt::print(stderr, "axiscert: --recheck: interrupted after {} of {} stretches\n", done, sample.size());
    return false;
  }
  std::sort(differences.begin(), differences.end());
  if (differences.empty()) images = recheck_images(predicate, here.plan, stretches, sample, differences);
  if (is_whole && differences.empty())
    recheck_radii(predicate, here.plan.questions.precisions, kernels, std::move(gathered).take(), differences);
  if (!differences.empty()) {
    throw NotValid(fmt::format("{}: the recheck comes out otherwise: {}{} (--recheck-seed {} takes the same sample)",
                               options.certificate, differences.front(),
                               differences.size() == 1 ? "" : fmt::format("; {} more differ", differences.size() - 1),
                               nonce));
  }
  fmt::print("recheck: {} stretches judged again, every tally the same{} (--recheck-seed {})\n", sample.size(),
             images == 0 ? "" : fmt::format(", and the images of {} families in a precision", images), nonce);
  return true;
}

}  // namespace axiscert
