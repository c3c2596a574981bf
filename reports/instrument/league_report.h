// The report of `axiscert league`, and league.json, which it writes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "fuzz/record/cause_record.h"
#include "fuzz/text/field.h"
#include "kernel/outcome.h"
#include "reports/instrument/data.h"
#include "reports/instrument/figures.h"
#include "reports/instrument/instrument.h"
#include "reports/wording/evidence.h"

namespace axiscert {
struct WorstData {
  Name what, family;
  double depth = 0;
  Name address;
  Json query;
  std::optional<std::string> code;

  static constexpr std::string_view about = "Its deepest wrong verdict.";
  AXISCERT_FIELDS(WorstData, AXISCERT_FIELD(what, "Missed, or invented."), AXISCERT_FIELD(family, "The family."),
                  AXISCERT_FIELD(depth, "As a share of the scene."),
                  AXISCERT_FIELD(address, "The address of the query."),
                  AXISCERT_FIELD(query, "Its numbers as hex-floats."),
                  AXISCERT_FIELD(code, "Code that asks it by hand; null: a command does."))
};

struct TrustData {
  Name answer, words;

  static constexpr std::string_view about = "May it be trusted with inputs of one kind?";
  AXISCERT_FIELDS(TrustData,
                  AXISCERT_FIELD(answer,
                                 "yes, rarely, no, too few or not looked at; yes takes 59 decided queries, and half of "
                                 "the contacts and of the separations."),
                  AXISCERT_FIELD(words, "The counts that it rests on."))
};

struct LeagueFamilyData {
  std::uint64_t trials = 0, decided = 0;
  std::optional<std::uint64_t> false_separation, false_contact, touching_flips;
  std::optional<double> deepest_false_separation, deepest_false_contact;
  std::uint64_t undecided = 0, invalid = 0, unanswered = 0, outside_limits = 0;
  std::optional<std::uint64_t> caught_after;
  RadiusSummary critical_radius;
  std::map<FindingKind, std::uint64_t> findings;
  std::optional<ContactTally> contacts;

  static constexpr std::string_view about = "On one family.";
  AXISCERT_FIELDS(
      LeagueFamilyData, AXISCERT_FIELD(trials, "Queries."),
      AXISCERT_FIELD(decided, "Valid queries within its limits on which it said contact or separated."),
      AXISCERT_FIELD(false_separation, "Missed contacts; null: no contact was decided."),
      AXISCERT_FIELD(false_contact, "Phantom contacts; null: no separation was decided."),
      AXISCERT_FIELD(touching_flips, "Wrong answers to spheres that touch; null: no such query was decided."),
      AXISCERT_FIELD(
          deepest_false_separation,
          "The depth of the deepest missed contact, as a share of the scene; 0: none; null: no contact was decided."),
      AXISCERT_FIELD(deepest_false_contact, "The same of phantom contacts."), AXISCERT_FIELD(undecided, "It declined."),
      AXISCERT_FIELD(invalid, "It called a query invalid."), AXISCERT_FIELD(unanswered, "It gave no answer."),
      AXISCERT_FIELD(outside_limits, "Valid queries outside its limits, whatever it said."),
      AXISCERT_FIELD(caught_after,
                     "Of a kernel that claims a built-in one's bits: queries until the first that shows another; null: "
                     "none does."),
      AXISCERT_FIELD(critical_radius, RadiusSummary::about),
      AXISCERT_FIELD(findings, "Faults other than wrong answers, by kind."),
      AXISCERT_FIELD(contacts,
                     "What it says beside its verdicts, of the first 4,096 queries; null: it gives no numbers, or the "
                     "predicate has none."))
};

struct LeagueKernelData {
  Name id;
  Precision precision = Precision::binary32;
  std::string summary;
  TouchingPolicy touching = TouchingPolicy::contact;
  bool may_decline = false, has_planted_fault = false;
  std::optional<double> ns;
  std::optional<WorstData> worst;
  std::optional<CauseRecord> cause;
  NamedValues<TrustData> trust;
  NamedValues<LeagueFamilyData> families;

  static constexpr std::string_view about = "One kernel in one precision.";
  AXISCERT_FIELDS(
      LeagueKernelData, AXISCERT_FIELD(id, "The kernel or library."),
      AXISCERT_FIELD(precision, "The precision of the queries."), AXISCERT_FIELD(summary, "What it computes."),
      AXISCERT_FIELD(touching, "The verdict that it promises where the two touch."),
      AXISCERT_FIELD(may_decline, "Whether it declares that it may answer `undecided`."),
      AXISCERT_FIELD(has_planted_fault, "Whether it is a kernel with a fault, which should be caught."),
      AXISCERT_FIELD(ns, "Nanoseconds a query; null: not timed.", "ns"),
      AXISCERT_FIELD(worst, "Its deepest wrong verdict; null: none, among the decided queries of `families`."),
      AXISCERT_FIELD(cause, CauseRecord::about),
      AXISCERT_FIELD(trust, "May it be trusted? By kind of input: thin, small, far, degenerate, resting, scene."),
      AXISCERT_FIELD(families, "By family."))
};

struct WorstContactData {
  Name kind, kernel;
  Precision precision = Precision::binary32;
  Name family;
  double size = 0;
  Name address;
  Json query;

  static constexpr std::string_view about = "One of the five worst numbers of a kind beside a verdict.";
  AXISCERT_FIELDS(
      WorstContactData, AXISCERT_FIELD(kind, "separation, contradiction, left, normal or point."),
      AXISCERT_FIELD(kernel, "The kernel or library; of each its worst in a precision."),
      AXISCERT_FIELD(precision, "The precision of the query."), AXISCERT_FIELD(family, "The family."),
      AXISCERT_FIELD(size,
                     "How far it is off: a share of the scene of a separation or point, radians of a normal, and of "
                     "`left` what a push along the normal leaves of the depth; 1 of a contradiction."),
      AXISCERT_FIELD(address, "The address of the query."),
      AXISCERT_FIELD(query, "Its numbers as hex-floats, and `measures` as a witness has them."))
};

struct LeagueData : CommandData<LeagueData> {
  static constexpr std::string_view format = "axiscert-league/4", title = "Kernels and libraries on the same queries";
  WholeNumber seed;
  std::vector<LeagueKernelData> kernels;
  std::vector<WorstContactData> worst_contacts;
  std::vector<Name> not_checked;

  static constexpr std::string_view about =
      "league.json, which `axiscert league` writes. Without `ns` it depends on the command alone, and on which "
      "libraries there are.";
  AXISCERT_FIELDS(LeagueData, base<Of, CommandData<Of>>(), AXISCERT_FIELD(seed, "The seed of every family."),
                  AXISCERT_FIELD(kernels, "One for each kernel and precision."),
                  AXISCERT_FIELD(worst_contacts, "With --contacts, the five worst of each kind; else empty."),
                  AXISCERT_FIELD(not_checked, "What was left out, a sentence each."))
};

// Kernels and libraries side by side on the same queries, and kernels with a fault.

struct League {
  Questions questions;
  std::vector<const Kernel*> kernels;
  std::size_t contenders = 0;  // the first so many of the kernels compete; the others have a planted fault
  // Nanoseconds for each query, by precision and number of the kernel; absent where no time was taken.
  std::map<std::pair<Precision, std::size_t>, double> nanoseconds;
  std::vector<std::string> not_checked;  // one sentence each
  // Why they are wrong, in the same way; absent where nothing is, or nobody looked.
  std::map<std::pair<Precision, std::size_t>, CauseRecord> causes = {};
};

// Each contender and precision with no decided query, with its counts: of these nothing was looked at.
std::vector<std::string> undecided_contenders(const League& league, const CampaignResult& result);

InstrumentReport league_report(const League& league, const CampaignResult& result, const std::string& command);

// "May I trust it?": what a contender of the league got wrong on each kind of input, in words and counts.

// Number of queries within the kernel's limits on which it said contact or separated.
std::uint64_t decided(const Tally& tally);
// Those among them that could be wrong in this way by what the kernel promises.
std::uint64_t decided_for(FlipKind kind, const Kernel& kernel, const Tally& tally);

// The answer to "may I trust it?", and the counts that it rests on.
struct Trust {
  // "yes", "rarely", "no", "too few" or "not looked at"
  std::string answer;
  std::string words;
  std::string text() const { return answer + ": " + words; }
};

// "yes: 0 of 4,096 wrong", "rarely: 3 of 4,096 missed", "no: 812 of 4,096 missed, 3 invented", "too few: 12 of 4,096
// decided", "not looked at: 0 of 4,096 decided"; then "; declines 120", "; calls 4 invalid", "; no answer to 14", "; 9
// outside its limits", where there are such. Less than one wrong in a thousand is rare. An answer `invalid`, none, or a
// decline that the kernel does not declare, is no trust, one being enough. Trust takes least_looked_at decided queries,
// and least_decided_share of the promised contacts and of the separations.
Trust trust_in(const Kernel& kernel, const Tally& tally);

// The groups of which a family was asked.
std::vector<TrustGroup> groups_asked(const std::vector<SourcePtr>& sources);
// All families of a group together; every family where there is none.
Tally tally_of_group(const League& league, const CampaignResult& result, std::size_t k, Precision precision,
                     std::optional<TrustGroup> group);

// A row for each contender that exists in the precision, a column for each kind of which a family was asked.
InstrumentTable trust_table(const League& league, const CampaignResult& result, Precision precision);

// Whether each contender may be trusted with scenes, and with all families, as a page begins: the table, the worst
// scene and, for each precision, who is right.
InstrumentFirst league_first(const League& league, const CampaignResult& result);

// "0.25"; "none of 4,096" contacts where none was missed; "not measured" where none was decided.
std::string depth_text(std::uint64_t missed, std::uint64_t contacts, double deepest);

// The worst query of a contender of the league: where it is, how wrong, and code to ask the engine by hand.

struct WorstQuery {
  const Kernel* kernel;
  const Source* source;
  Precision precision;
  std::uint64_t position;
  bool is_missed;            // its deepest missed contact; else, where it misses none, its deepest invented one
  double depth;              // a share of the scene, as everywhere
  bool is_everyday() const;  // of a family of scenes, which are in metres

  std::string address(std::uint64_t seed) const;
};

// The worst of kernel `k` of the league in this precision; none where no verdict was wrong.
std::optional<WorstQuery> worst_of(const League& league, const CampaignResult& result, std::size_t k,
                                   Precision precision);

// The worst of all contenders: the farthest off in length on a scene, else the deepest.
std::optional<WorstQuery> worst_scene_of(const League& league, const CampaignResult& result);

// "misses a contact 0.43 deep, where r is 0.98: 0.36 of the scene": the lengths in the query's own units, rounded; on
// scenes "16.6 cm".
std::string worst_sentence(const WorstQuery& worst, std::uint64_t seed);

// The query as a picture, the sentence, and the code with its numbers: that of a program's manifest, or the commands
// that make the query again and judge it. The code's numbers are decimals of which a double has every bit.
InstrumentScene worst_scene(const WorstQuery& worst, std::uint64_t seed);

// A row for each contender and precision, with a scene where a verdict was wrong; else it says among how many.
InstrumentTable worst_table(const League& league, const CampaignResult& result);
// One row's figures, its query and its code; none where no verdict was wrong.
std::optional<WorstData> worst_data(const League& league, const CampaignResult& result, std::size_t k,
                                    Precision precision);

}  // namespace axiscert
