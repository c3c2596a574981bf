// league.json: what `axiscert league` writes.
#pragma once

#include <map>

#include "fuzz/fields/named.h"
#include "kernel/finding.h"
#include "reports/instrument/data.h"
#include "reports/instrument/figures.h"

namespace axiscert {

struct WorstData {
  Name what, family;
  double depth = 0;
  Name address;
  Json query;
  std::optional<std::string> code;

  static constexpr std::string_view about = "Its deepest wrong verdict.";
  static constexpr auto fields(auto&& visit) {
    using Of = WorstData;
    return visit(field(&Of::what, {"what", "Missed, or invented."}), field(&Of::family, {"family", "The family."}),
                 field(&Of::depth, {"depth", "As a share of the scene."}),
                 field(&Of::address, {"address", "The address of the query."}),
                 field(&Of::query, {"query", "Its numbers as hex-floats."}),
                 field(&Of::code, {"code", "Code that asks it by hand; null: a command does."}));
  }
};

struct TrustData {
  Name answer, words;

  static constexpr std::string_view about = "May it be trusted with inputs of one kind?";
  static constexpr auto fields(auto&& visit) {
    return visit(field(&TrustData::answer,
                       {"answer",
                        "yes, rarely, no, too few or not looked at; yes takes 59 decided queries, and half of the "
                        "contacts and of the separations."}),
                 field(&TrustData::words, {"words", "The counts that it rests on."}));
  }
};

struct LeagueFamilyData {
  std::uint64_t trials = 0, decided = 0;
  std::optional<std::uint64_t> false_separation, false_contact, touching_flips;
  std::optional<double> deepest_false_separation, deepest_false_contact;
  std::uint64_t undecided = 0, invalid = 0, unanswered = 0, outside_limits = 0;
  std::optional<std::uint64_t> caught_after;
  RadiusSummary critical_radius;
  std::map<FindingKind, std::uint64_t> findings;

  static constexpr std::string_view about = "On one family.";
  static constexpr auto fields(auto&& visit) {
    using Of = LeagueFamilyData;
    return visit(
        field(&Of::trials, {"trials", "Queries."}),
        field(&Of::decided, {"decided", "Valid queries within its limits on which it said contact or separated."}),
        field(&Of::false_separation, {"false_separation", "Missed contacts; null: none was decided."}),
        field(&Of::false_contact, {"false_contact", "Phantom contacts; null: none was decided."}),
        field(&Of::touching_flips, {"touching_flips", "Wrong answers to spheres that touch; null: none was decided."}),
        field(&Of::deepest_false_separation,
              {"deepest_false_separation",
               "The depth of the deepest missed contact, as a share of the scene; 0: none; null: none was decided."}),
        field(&Of::deepest_false_contact, {"deepest_false_contact", "The same of phantom contacts."}),
        field(&Of::undecided, {"undecided", "It declined."}),
        field(&Of::invalid, {"invalid", "It called a query invalid."}),
        field(&Of::unanswered, {"unanswered", "It gave no answer."}),
        field(&Of::outside_limits, {"outside_limits", "Valid queries outside its limits, whatever it said."}),
        field(&Of::caught_after,
              {"caught_after",
               "Of a kernel that claims a built-in one's bits: queries until the first that shows another; null: none "
               "does."}),
        field(&Of::critical_radius, {"critical_radius", RadiusSummary::about}),
        field(&Of::findings, {"findings", "Faults other than wrong answers, by kind."}));
  }
};

struct LeagueKernelData {
  Name id;
  Precision precision = Precision::binary32;
  std::string summary;
  TouchingPolicy touching = TouchingPolicy::contact;
  bool may_decline = false, has_planted_fault = false;
  std::optional<double> ns;
  std::optional<WorstData> worst;
  NamedValues<TrustData> trust;
  NamedValues<LeagueFamilyData> families;

  static constexpr std::string_view about = "One kernel in one precision.";
  static constexpr auto fields(auto&& visit) {
    using Of = LeagueKernelData;
    return visit(
        field(&Of::id, {"id", "The kernel or library."}),
        field(&Of::precision, {"precision", "The precision of the queries."}),
        field(&Of::summary, {"summary", "What it computes."}),
        field(&Of::touching, {"touching", "The verdict that it promises where the two touch."}),
        field(&Of::may_decline, {"may_decline", "Whether it declares that it may answer `undecided`."}),
        field(&Of::has_planted_fault,
              {"has_planted_fault", "Whether it is a kernel with a fault, which should be caught."}),
        field(&Of::ns, {"ns", "Nanoseconds a query; null: not timed.", "ns"}),
        field(&Of::worst, {"worst", "Its deepest wrong verdict; null: none, among the decided queries of `families`."}),
        field(&Of::trust,
              {"trust", "May it be trusted? By kind of input: thin, small, far, degenerate, resting, scene."}),
        field(&Of::families, {"families", "By family."}));
  }
};

struct LeagueData : CommandData<LeagueData> {
  static constexpr std::string_view format = "axiscert-league/2", title = "Kernels and libraries on the same queries";
  WholeNumber seed;
  std::vector<LeagueKernelData> kernels;
  std::vector<Name> not_checked;

  static constexpr std::string_view about =
      "league.json, which `axiscert league` writes. Without `ns` it depends on the command alone, and on which "
      "libraries there are.";
  static constexpr auto fields(auto&& visit) {
    using Of = LeagueData;
    return visit(base<Of, CommandData<Of>>(), field(&Of::seed, {"seed", "The seed of every family."}),
                 field(&Of::kernels, {"kernels", "One for each kernel and precision."}),
                 field(&Of::not_checked, {"not_checked", "What was left out, a sentence each."}));
  }
};

}  // namespace axiscert
