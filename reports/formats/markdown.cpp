// report.md: the short report, for a pull request or a terminal. It stays under 1 MiB and says what it left out.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/wording/summary.h"
#include "reports/formats/format.h"
#include "reports/formats/markdown_sections.h"
#include "reports/wording/markdown_text.h"
#include "reports/wording/everyday.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/evidence.h"
#include "reports/gates/requirement.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

constexpr std::size_t table_witnesses = 10;

std::string depth(double value) { return amount(value, 4); }
// The deepest wrong verdict of a kind; "-" where no decided query could be one.
std::string deepest_of(FlipKind kind, const KernelRecord& kernel, const FamilyRecord& family) {
  const VerdictTally& verdict = family.verdict;
  const double deepest =
      (kind == FlipKind::false_separation ? verdict.deepest_false_separation : verdict.deepest_false_contact).best();
  return deepest == 0 && evidence_of(kernel, family).decided_for(kind) == 0 ? "-" : depth(deepest);
}
std::string optional_amount(std::optional<double> value) { return value ? amount(*value, 4) : "none"; }

// The broken links with their counts, as in "rounding 12, range 3"; "none" where there are none.
std::string links(const LinkCounts& counts) {
  std::vector<std::string> broken;
  for (const Link link : enumerators<Link>) {
    if (counts[link] != 0) broken.push_back(fmt::format("{} {}", name(link), thousands(counts[link])));
  }
  return broken.empty() ? "none" : fmt::format("{}", fmt::join(broken, ", "));
}

// The same of verdicts; "-" where no link could show.
std::string links_of(const VerdictTally& verdict) { return verdict.decided() == 0 ? "-" : links(verdict.links); }

// The number of the first query with each link, counted from 1; 0: none.
LinkCounts first_of(const EnumArray<Link, FirstQuery>& first_by_link) {
  LinkCounts numbers{};
  for (const Link link : enumerators<Link>) {
    if (first_by_link[link].position) numbers[link] = *first_by_link[link].position + 1;
  }
  return numbers;
}

class MarkdownReport {
 public:
  explicit MarkdownReport(const Run& run)
      : run_(run), record_(run.record), plan_(run.record.plan), outcomes_(outcomes_of(run.record)) {
    for (const KernelRecord& kernel : record_.kernels) totals_.push_back(all_families(kernel));
  }

  std::string text() const {
    std::string text = "# axiscert report\n";
    if (!record_.complete) {
      text += fmt::format("\n> **INCOMPLETE**: {}. The figures below cover only the queries that were run.\n",
                          interrupted_text(record_));
    }
    for (const std::string& sentence : unjudged(record_))
      text += fmt::format("\n> **{}**\n", markdown_text(sentence, 2000));
    return text + answer_section(record_) + causes_section(record_) + ratchet() + findings() +
           requirements_section(record_, outcomes_) + summary() + contact_section(record_) + classes_section(record_) +
           depths_section(record_) + families() + outside() + asymmetries() + axes_section(record_, totals_) +
           comparisons_section(record_, totals_) + broken_links() + witnesses() + critical_radius() + words() +
           reproduce();
  }

 private:
  std::string requirement_of(const KernelRecord& kernel) const {
    const LevelOutcome* worst = worst_of(outcomes_, kernel);
    return worst == nullptr || worst->passes() ? state_text(worst) : fmt::format("**{}**", state_text(worst));
  }

  std::string ratchet() const {
    if (!run_.ratchet) return "";
    Section section("Ratchet");
    const RatchetOutcome& held = *run_.ratchet;
    section.add_line(
        fmt::format("Compared with {}: {}", markdown_text(held.file),
                    held.failures.empty() ? "nothing is worse than accepted." : "**the ratchet is not met**."));
    section.add_line("");
    for (const RatchetFailure& failure : held.failures) section.add_line("- " + markdown_text(failure.text, 2000));
    for (const std::string& changed : held.changed)
      section.add_line("- changed since the ratchet was written: " + markdown_text(changed, 2000));
    for (const std::string& better : held.better) section.add_line("- better: " + markdown_text(better, 2000));
    return section.text();
  }

  std::string findings() const {
    if (record_.findings.empty()) return "";
    Section section("Findings");
    section.add_line("Faults of plug-ins other than wrong answers. A kernel with a finding meets no requirement.");
    for (const FindingGroup& group : finding_groups(record_)) {
      const std::string others = group.others.empty() ? "" : "; " + markdown_text(group.others_text(), 2000);
      const std::string command = replay_command(*group.first, plan_);
      const std::string replay = command.empty() ? "" : "\n" + code_block(command);
      section.add(fmt::format("\n- {}{}\n{}", markdown_text(finding_text(*group.first), 2000), others, replay));
    }
    return section.text();
  }

  std::string summary() const {
    Section section("Summary");
    section.add_head(
        {"kernel", "precision", "requirement", "broken links", "trials", "false_separation (missed contacts)",
         "deepest", "false_contact (phantom contacts)", "deepest", "undecided", "invalid answers", "no answer"},
        4);
    for (const std::string& kernel : not_judged(record_)) {
      section.add_row({markdown_text(kernel), "", "**not judged**", "could not be loaded, see Findings", "0", "", "",
                       "", "", "", "", ""});
    }
    for (std::size_t k = 0; k < totals_.size(); ++k) {
      const KernelRecord& kernel = record_.kernels[k];
      std::vector<std::string> cells = {markdown_text(kernel.id), std::string(name(kernel.precision)),
                                        requirement_of(kernel)};
      if (!totals_[k]) {
        cells.insert(cells.end(), {"not checked: no family ran", "0", "", "", "", "", "", "", ""});
      } else {
        const FamilyRecord& total = *totals_[k];
        const VerdictTally& verdict = total.verdict;
        cells.insert(
            cells.end(),
            {links_of(verdict), thousands(total.trials), with_rate(FlipKind::false_separation, kernel, total),
             deepest_of(FlipKind::false_separation, kernel, total), with_rate(FlipKind::false_contact, kernel, total),
             deepest_of(FlipKind::false_contact, kernel, total), thousands(verdict.undecided),
             thousands(verdict.invalid), thousands(verdict.unanswered)});
      }
      section.add_row(cells);
    }
    for (const KernelRecord& kernel : record_.kernels) {
      if (kernel.touching == TouchingPolicy::contact && !has_limits(kernel)) continue;
      section.add_line(fmt::format("\n{} {} declares: {}; limits: {}.", markdown_text(kernel.id),
                                   name(kernel.precision), touching_text(kernel), limits_text(kernel)));
    }
    return section.text();
  }

  std::string words() const {
    Section section("Words");
    section.add_line(
        "Depth, how far a wrong verdict is from being right, is a share of the scene: |d - r| / max(|A-P|, |B-P|, "
        "|C-P|, r); `axiscert explain WORD` says what any word here means. A limit for zero failures holds for "
        "this generator only. What a broken link of a wrong verdict means:\n");
    for (std::size_t i = 0; i < link_count; ++i)
      section.add_line(fmt::format("- {}: {}", link_names[i], link_words[i].meaning));
    return section.text();
  }

  template <class Visit>
  void for_each_family(const Visit& visit) const {
    for (const KernelRecord& kernel : record_.kernels) {
      for (const auto& [family, result] : kernel.families) {
        visit(std::vector<std::string>{markdown_text(kernel.id), std::string(name(kernel.precision)),
                                       markdown_text(family)},
              kernel, result);
      }
    }
  }

  std::string families() const {
    Section section("Kernels and families");
    for (const FamilyGroup group : enumerators<FamilyGroup>) add_families(section, group);
    return section.text();
  }

  void add_families(Section& section, FamilyGroup group) const {
    bool is_first = true;
    for (const KernelRecord& kernel : record_.kernels) {
      for (const auto& [family, result] : kernel.families) {
        if (family_group(family) != group) continue;
        if (is_first) {
          section.add_line(fmt::format("\n### {}\n", family_group_headings[group]));
          section.add_head(
              {"kernel", "precision", "family", "broken links", "trials", "separated", "contact", "touching", "invalid",
               "false_separation", "deepest", "false_contact", "deepest", "touching flips", "undecided", "no answer"},
              4);
        }
        is_first = false;
        section.add_row(family_cells(kernel, family, result));
      }
    }
  }

  std::vector<std::string> family_cells(const KernelRecord& kernel, const std::string& family,
                                        const FamilyRecord& result) const {
    const TruthCounts& truth = result.truth;
    const VerdictTally& verdict = result.verdict;
    const auto deepest = [&](FlipKind kind, const Leaders<double>& by_length) {
      const std::string length = length_words(family, by_length.best(), plan_);
      return deepest_of(kind, kernel, result) + (length.empty() ? "" : ", " + length);
    };
    return {markdown_text(kernel.id),
            std::string(name(kernel.precision)),
            markdown_text(family) + (result.exact_arithmetic ? " (exact arithmetic)" : ""),
            links_of(verdict),
            thousands(result.trials),
            thousands(truth.separated),
            thousands(truth.contact),
            thousands(truth.touching),
            thousands(truth.invalid),
            with_rate(FlipKind::false_separation, kernel, result),
            deepest(FlipKind::false_separation, verdict.farthest_false_separation),
            with_rate(FlipKind::false_contact, kernel, result),
            deepest(FlipKind::false_contact, verdict.farthest_false_contact),
            verdict.decided_touching == 0 ? "-" : thousands(verdict.touching_flips),
            thousands(verdict.undecided),
            thousands(verdict.unanswered)};
  }

  std::string outside() const {
    Section section("Outside the limits");
    section.add_line(
        "Valid queries outside the limits that a kernel declares: counted here and nowhere else; no requirement covers "
        "them.\n");
    bool any = false;
    section.add_head(
        {"kernel", "precision", "family", "queries", "false_separation", "false_contact", "deepest", "no answer"}, 3);
    for_each_family([&](std::vector<std::string> cells, const KernelRecord&, const FamilyRecord& result) {
      const std::optional<OutsideTally>& apart = result.verdict.outside_limits;
      if (!apart) return;
      any = true;
      const auto told = [](std::uint64_t decided, std::string shown) { return decided == 0 ? "-" : std::move(shown); };
      cells.insert(cells.end(),
                   {thousands(apart->trials), told(apart->decided_contacts, thousands(apart->false_separation)),
                    told(apart->decided_separations, thousands(apart->false_contact)),
                    told(apart->decided(), depth(apart->deepest)), thousands(apart->unanswered)});
      section.add_row(cells);
    });
    return any ? section.text() : "";
  }

  std::string asymmetries() const {
    Section section("Asymmetry");
    section.add_line(
        "An image of a query has the same exact answer: it is the query with its vertices reordered, its axes "
        "exchanged, its "
        "unit of length changed or the like. Counted are the images that the kernel answered otherwise than the "
        "query.\n");
    bool any = false;
    section.add_head({"kernel", "precision", "family", "first image with another verdict", "images", "other verdicts",
                      "other comparisons"},
                     4);
    for_each_family([&](std::vector<std::string> cells, const KernelRecord&, const FamilyRecord& result) {
      if (!result.asymmetry) return;
      any = true;
      const AsymmetryRecord& found = *result.asymmetry;
      const char* const none = found.images == 0 ? "-" : "none";
      cells.insert(cells.end(), {found.first_verdict ? markdown_text(found.first_verdict->image) : none,
                                 thousands(found.images), found.images == 0 ? "-" : thousands(found.verdicts),
                                 found.images_with_comparisons == 0 || !found.comparisons
                                     ? "-"
                                     : fmt::format("{} of {}", thousands(*found.comparisons),
                                                   thousands(found.images_with_comparisons))});
      section.add_row(cells);
    });
    return any ? section.text() : "";
  }

  std::string broken_links() const {
    Section section("Broken links by family");
    bool any = false;
    std::uint64_t decided = 0;
    for_each_family([&](std::vector<std::string> cells, const KernelRecord&, const FamilyRecord& result) {
      const std::string wrong = links(result.verdict.links), masked = links(result.verdict.masked_links);
      decided += result.verdict.decided();
      if (wrong == "none" && masked == "none") return;
      if (!any)
        section.add_head(
            {"kernel", "precision", "family", "of wrong verdicts", "first query with it", "cancelled, verdict right"},
            6);
      any = true;
      cells.insert(cells.end(), {wrong, links(first_of(result.verdict.first_by_link)), masked});
      section.add_row(cells);
    });
    if (!any)
      section.add_line(decided == 0 ? "No query was decided: no link could break."
                                    : fmt::format("None on {} decided queries.", thousands(decided)));
    return section.text();
  }

  std::string witnesses() const {
    Section section("Worst witnesses");
    const auto worst = worst_witnesses(record_, table_witnesses);
    section.add_line(fmt::format("{} of {}, the deepest of each kernel, family and kind; witnesses.jsonl has all.",
                                 worst.size(), record_.witnesses.size()));
    for (std::size_t i = 0; i < worst.size(); ++i) {
      const WitnessRecord& w = *worst[i];
      std::string depth_text = w.depth ? fmt::format(", depth {}", depth(*w.depth)) : "";
      if (const std::string length = length_words(w.family, w.length.value_or(0), plan_); !length.empty())
        depth_text += ", " + length;
      section.add(fmt::format("\n{}. {}: {} {} on {}: {} computed, {}{} exact{}\n\n{}", i + 1, markdown_text(w.id),
                              markdown_text(w.kernel), name(w.precision), markdown_text(w.family), name(w.computed),
                              name(w.truth), w.touching ? " (touching)" : "", depth_text,
                              code_block(replay_command(w, plan_))));
    }
    return section.text();
  }

  std::string critical_radius() const {
    Section section("Critical radius error");
    section.add_line(
        "Error of the smallest radius for which the kernel says contact, in ulps of the exact distance; unbounded: "
        "contact "
        "for no finite radius. Where the kernel declined some radius, called it invalid or gave no answer to it, "
        "nothing "
        "was sampled.\n");
    section.add_head({"kernel", "precision", "family", "sampled", "median", "largest", "unbounded", "no answer",
                      "declined", "called invalid"},
                     3);
    const auto row = [&](std::vector<std::string> cells, const CriticalRadiusRecord& radius) {
      const auto told = [&](std::string shown) { return radius.sampled == 0 ? "-" : std::move(shown); };
      cells.insert(cells.end(), {thousands(radius.sampled), told(optional_amount(radius.median_ulps)),
                                 told(optional_amount(radius.largest_ulps)), told(thousands(radius.unbounded)),
                                 thousands(radius.unanswered), thousands(radius.undecided), thousands(radius.invalid)});
      section.add_row(cells);
    };
    for (const KernelRecord& kernel : record_.kernels) {
      row({markdown_text(kernel.id), std::string(name(kernel.precision)), "all"}, kernel.critical_radius);
    }
    for_each_family([&](const std::vector<std::string>& cells, const KernelRecord&, const FamilyRecord& result) {
      row(cells, result.critical_radius);
    });
    return section.text();
  }

  std::string reproduce() const {
    Section section("How to reproduce");
    const std::string command = run_command(plan_);
    section.add(command.empty()
                    ? "The number of trials depended on the time available; record.json lists the units done.\n"
                    : code_block(command));
    section.add_line("");
    for (const auto& [label, value] : plan_facts(run_))
      section.add_line(fmt::format("- {}: {}", markdown_text(label), markdown_text(value, 2000)));
    section.add_line("\nNOT CHECKED:\n");
    for (const std::string& sentence : not_checked(record_)) section.add_line("- " + markdown_text(sentence, 2000));
    return section.text();
  }

  const Run& run_;
  const Record& record_;
  const PlanRecord& plan_;
  std::vector<std::optional<FamilyRecord>> totals_;
  std::vector<LevelOutcome> outcomes_;
};

std::string render_markdown(const Run& run) { return MarkdownReport(run).text(); }

}  // namespace

extern const Format markdown_format = {"report.md", "a short version of this page", render_markdown};

}  // namespace axiscert
