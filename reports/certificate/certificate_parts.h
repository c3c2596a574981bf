// What a certificate says of a kernel: the parts of its predicate that were found.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/plan_record.h"
#include "fuzz/text/json_form.h"
#include "kernel/kernel.h"
#include "kernel/names.h"
#include "reports/gates/requirement.h"

namespace axiscert {

struct SaidRule {
  static constexpr std::size_t longest = 20000;
  static constexpr bool may_be_empty = true;
};
using SaidText = Text<SaidRule>;

// A figure that is no whole number, in decimal digits: a certificate has no fractions.
struct TextNumberRule {
  static constexpr std::size_t longest = 64;
  static constexpr bool may_be_empty = true;
};
using TextNumber = Text<TextNumberRule>;
inline double number_in(const TextNumber& text) { return std::strtod(text.c_str(), nullptr); }

// So many values at least, and at most.
template <class T, std::size_t least, std::size_t most>
struct Several : std::vector<T> {
  using std::vector<T>::vector;
  Several(std::vector<T> values) : std::vector<T>(std::move(values)) {}
};
template <class T, std::size_t least, std::size_t most>
struct JsonForm<Several<T, least, most>> {
  using Values = std::vector<T>;
  static Json write(const Several<T, least, most>& values) { return JsonForm<Values>::write(values); }
  static void read(const JsonPlace& place, Several<T, least, most>& into) {
    if (place.value().is_array() && place.value().size() < least) place.refuse("with too few items");
    if (place.value().is_array() && place.value().size() > most) place.refuse("with too many items");
    JsonForm<Values>::read(place, into);
  }
  static Json schema() {
    Json schema = JsonForm<Values>::schema();
    if (least != 0) schema["minItems"] = least;
    schema["maxItems"] = most;
    return schema;
  }
};

// An object whose members are checked where they are used: a query, a plan, counts.
struct JsonObject {
  Json json = Json::object();
};
template <>
struct JsonForm<JsonObject> {
  static Json write(const JsonObject& object) { return object.json; }
  static void read(const JsonPlace& place, JsonObject& into) {
    place.require_type(place.value().is_object(), "object");
    into.json = place.value();
  }
  static Json schema() { return {{"type", "object"}}; }
};

// How a kernel came.
enum class KernelKind : std::uint8_t { built_in, plugin, program, peer, replies };
template <>
inline constexpr std::size_t enum_count<KernelKind> = 5;
constexpr std::string_view name(KernelKind kind) {
  return EnumArray<KernelKind, std::string_view>{"built-in", "plugin", "program", "peer", "replies"}[kind];
}

struct KernelStatement {
  SaidText id;
  KernelKind kind = KernelKind::built_in;
  SaidText question, entry, summary;
  Several<Exposure, 0, 8> exposes;
  TouchingPolicy touching = TouchingPolicy::contact;
  std::optional<SaidText> limits;
  bool may_decline = false;
  Several<Precision, 1, 2> precisions;

  AXISCERT_FIELDS(KernelStatement, AXISCERT_FIELD(id), AXISCERT_FIELD(kind),
                  AXISCERT_FIELD(question, "The predicate that it computes."),
                  AXISCERT_FIELD(entry, "The form in which it takes the numbers of the predicate."),
                  AXISCERT_FIELD(summary), AXISCERT_FIELD(exposes), AXISCERT_FIELD(touching),
                  AXISCERT_FIELD(limits, "Where it promises to be right; null: everywhere."),
                  AXISCERT_FIELD(may_decline), AXISCERT_FIELD(precisions))
};

struct EffortRule {
  static constexpr std::size_t longest = 8;
  static constexpr std::string_view pattern = "^(smoke|quick|standard|deep|replies)$";
};

struct LeftOutStatement {
  std::uint64_t no_query = 0, outside_limits = 0, touching = 0, declined = 0, declined_contacts = 0, invalid = 0,
                unanswered = 0;

  AXISCERT_FIELDS(LeftOutStatement, AXISCERT_FIELD(no_query), AXISCERT_FIELD(outside_limits), AXISCERT_FIELD(touching),
                  AXISCERT_FIELD(declined), AXISCERT_FIELD(declined_contacts, "Of the declined, those in contact."),
                  AXISCERT_FIELD(invalid), AXISCERT_FIELD(unanswered))
};

struct AskedStatement {
  Text<EffortRule> effort;
  WholeNumber seed;
  std::uint64_t stretches = 0, queries = 0, contacts = 0, separations = 0, looked_at = 0;
  LeftOutStatement left_out;
  Several<SaidText, 0, 10000> families;

  AXISCERT_FIELDS(AskedStatement, AXISCERT_FIELD(effort), AXISCERT_FIELD(seed), AXISCERT_FIELD(stretches),
                  AXISCERT_FIELD(queries), AXISCERT_FIELD(contacts, "Of these, promised ones that are in contact."),
                  AXISCERT_FIELD(separations, "And those that are not."), AXISCERT_FIELD(looked_at),
                  AXISCERT_FIELD(left_out), AXISCERT_FIELD(families))
};

// What it rests on that a level is met.
enum class Ground : std::uint8_t { proved, observed, searched };
template <>
inline constexpr std::size_t enum_count<Ground> = 3;
constexpr std::string_view name(Ground ground) {
  return EnumArray<Ground, std::string_view>{"proved", "observed", "searched"}[ground];
}

struct GroundStatement {
  Ground kind = Ground::observed;
  SaidText text;

  AXISCERT_FIELDS(GroundStatement, AXISCERT_FIELD(kind), AXISCERT_FIELD(text))
};

struct LevelStatement {
  SaidText level;
  std::optional<Precision> precision;
  LevelState state = LevelState::not_checked;
  SaidText claim, looked_at, statement;
  Several<GroundStatement, 0, 8> rests_on;
  std::optional<SaidText> leaves_out;
  Several<SaidText, 0, 8> failures;
  std::uint64_t failure_count = 0;
  std::optional<SaidText> reason;

  bool is_same_question(const LevelStatement& other) const {
    return level == other.level && precision == other.precision;
  }
  AXISCERT_FIELDS(LevelStatement, AXISCERT_FIELD(level),
                  AXISCERT_FIELD(precision, "Null of a kernel that could not be loaded."), AXISCERT_FIELD(state),
                  AXISCERT_FIELD(claim, "Its name, and how much of its families it is said of."),
                  AXISCERT_FIELD(looked_at, "How many queries."), AXISCERT_FIELD(statement, "What it says, in words."),
                  AXISCERT_FIELD(rests_on), AXISCERT_FIELD(leaves_out),
                  AXISCERT_FIELD(failures, "The first of failure_count, of one that is not met."),
                  AXISCERT_FIELD(failure_count), AXISCERT_FIELD(reason, "Of one that was not checked."))
};

// The safe margin.

struct ContactsStatement {
  std::uint64_t asked = 0, missed = 0, declined = 0, invalid = 0, unanswered = 0;

  static constexpr std::string_view about =
      "Contacts that the kernel was asked about, and those that it did not call so.";
  AXISCERT_FIELDS(ContactsStatement, AXISCERT_FIELD(asked), AXISCERT_FIELD(missed), AXISCERT_FIELD(declined),
                  AXISCERT_FIELD(invalid), AXISCERT_FIELD(unanswered))
};

struct MarginContactsStatement {
  ContactsStatement of_run, of_others;

  AXISCERT_FIELDS(MarginContactsStatement, AXISCERT_FIELD(of_run, ContactsStatement::about),
                  AXISCERT_FIELD(of_others, "At the least radius, and of a search."))
};

struct MissedStatement {
  TextNumber value, r;
  std::optional<TextNumber> contact_from;
  SaidText family;
  JsonObject query;

  AXISCERT_FIELDS(MissedStatement, AXISCERT_FIELD(value), AXISCERT_FIELD(r),
                  AXISCERT_FIELD(contact_from, "The least radius for which the kernel says contact."),
                  AXISCERT_FIELD(family), AXISCERT_FIELD(query))
};

struct MarginPartStatement {
  std::uint64_t queries = 0, contacts = 0, without_verdict = 0, missed = 0, hopeless = 0, tiny = 0, unmeasured = 0;
  std::optional<TextNumber> factor, amount;
  std::uint64_t phantoms_by_factor = 0, phantoms_by_amount = 0, still_missed_by_factor = 0, still_missed_by_amount = 0;

  AXISCERT_FIELDS(MarginPartStatement, AXISCERT_FIELD(queries), AXISCERT_FIELD(contacts),
                  AXISCERT_FIELD(without_verdict), AXISCERT_FIELD(missed), AXISCERT_FIELD(hopeless),
                  AXISCERT_FIELD(tiny), AXISCERT_FIELD(unmeasured), AXISCERT_FIELD(factor), AXISCERT_FIELD(amount),
                  AXISCERT_FIELD(phantoms_by_factor), AXISCERT_FIELD(phantoms_by_amount),
                  AXISCERT_FIELD(still_missed_by_factor), AXISCERT_FIELD(still_missed_by_amount))
};

struct MarginDecadeStatement : MarginPartStatement {
  bool degenerate = false;
  int decade = 0;

  AXISCERT_FIELDS(MarginDecadeStatement, base<Of, MarginPartStatement>(), AXISCERT_FIELD(degenerate),
                  AXISCERT_FIELD(decade, "Scenes from this power of ten on."))
};

struct MarginStatement {
  Precision precision = Precision::binary32;
  std::uint64_t queries = 0, probed = 0, found = 0, phantoms = 0;
  MarginContactsStatement contacts;
  std::optional<MissedStatement> factor, amount, hopeless;
  MarginPartStatement all;
  Several<MarginDecadeStatement, 0, 2000> decades;

  AXISCERT_FIELDS(MarginStatement, AXISCERT_FIELD(precision), AXISCERT_FIELD(queries), AXISCERT_FIELD(probed),
                  AXISCERT_FIELD(found), AXISCERT_FIELD(phantoms), AXISCERT_FIELD(contacts), AXISCERT_FIELD(factor),
                  AXISCERT_FIELD(amount), AXISCERT_FIELD(hopeless), AXISCERT_FIELD(all), AXISCERT_FIELD(decades))
};

// What a stage gave in each precision, or the reason why it gave nothing.
template <class Precisions>
struct StageStatement {
  std::optional<SaidText> reason;
  Precisions precisions;

  AXISCERT_FIELDS(StageStatement, AXISCERT_FIELD(reason, "Why there is none; null where there is."),
                  AXISCERT_FIELD(precisions))
};
using SafeMarginStatement = StageStatement<Several<MarginStatement, 0, 2>>;

// Diagnosis, search, planted faults.

struct PropertyStatement {
  SaidText name, value, sentence;
  std::uint64_t queries = 0;

  AXISCERT_FIELDS(PropertyStatement, AXISCERT_FIELD(name), AXISCERT_FIELD(value), AXISCERT_FIELD(sentence),
                  AXISCERT_FIELD(queries))
};

struct DiagnosedStatement {
  Precision precision = Precision::binary32;
  Several<PropertyStatement, 0, 200> properties;

  AXISCERT_FIELDS(DiagnosedStatement, AXISCERT_FIELD(precision), AXISCERT_FIELD(properties))
};
using DiagnosisStatement = StageStatement<Several<DiagnosedStatement, 0, 2>>;

struct FindStatement {
  std::optional<TextNumber> depth, ulps;
  std::optional<Several<SaidText, 0, 8>> links;
  JsonObject query;

  AXISCERT_FIELDS(FindStatement, AXISCERT_OPTIONAL_FIELD(depth, "Of a wrong verdict, relative to the scene."),
                  AXISCERT_OPTIONAL_FIELD(ulps, "Of a critical radius."), AXISCERT_OPTIONAL_FIELD(links),
                  AXISCERT_FIELD(query))
};

struct SearchedStatement {
  std::uint64_t evaluations = 0, begun_from = 0;
  NamedValues<std::optional<FindStatement>> finds;
  NamedValues<std::uint64_t> looked_at;

  const FindStatement* find(std::string_view goal) const {
    const auto* found = finds.find(goal);
    return found && *found ? &**found : nullptr;
  }
  std::uint64_t looked_at_for(std::string_view goal) const {
    const std::uint64_t* found = looked_at.find(goal);
    return found ? *found : 0;
  }
  AXISCERT_FIELDS(SearchedStatement, AXISCERT_FIELD(evaluations), AXISCERT_FIELD(begun_from),
                  AXISCERT_FIELD(finds, "The worst of each goal; null: none was found."),
                  AXISCERT_FIELD(looked_at,
                                 "By goal, the queries evaluated for it that were decided, or had the number that it "
                                 "is about; 0: that none was found says nothing."))
};
using SearchesStatement = StageStatement<NamedValues<SearchedStatement>>;

struct PlantedScore {
  std::uint64_t mutants = 0, judged = 0, noticed = 0, survived = 0, equivalent = 0;

  AXISCERT_FIELDS(PlantedScore, AXISCERT_FIELD(mutants), AXISCERT_FIELD(judged, "Those that were asked a valid query."),
                  field(&Of::noticed, figure_of("judged", "noticed", {})),
                  field(&Of::survived, figure_of("judged", "survived", {})), AXISCERT_FIELD(equivalent))
};

struct HarnessStatement {
  std::optional<SaidText> reason, judged_by, made_of;
  std::uint64_t planted = 0, exist = 0, queries = 0;
  NamedValues<PlantedScore> score;

  static constexpr std::string_view about = "Faults planted in a right kernel that shows as much as this one.";
  AXISCERT_FIELDS(HarnessStatement, AXISCERT_FIELD(reason, "Why it was not asked; null where it was."),
                  AXISCERT_FIELD(judged_by), AXISCERT_FIELD(made_of), AXISCERT_FIELD(planted), AXISCERT_FIELD(exist),
                  AXISCERT_FIELD(queries), AXISCERT_FIELD(score, "By precision."))
};

// Wrong verdicts.

struct ComparisonStatement {
  SaidText kernel;
  Precision precision = Precision::binary32;
  std::uint64_t looked_at = 0, undecided = 0, invalid = 0, unanswered = 0;
  std::optional<std::uint64_t> missed, phantom;
  std::optional<TextNumber> deepest_missed, deepest_phantom, median_ulps, largest_ulps;

  AXISCERT_FIELDS(ComparisonStatement, AXISCERT_FIELD(kernel), AXISCERT_FIELD(precision), AXISCERT_FIELD(looked_at),
                  AXISCERT_FIELD(undecided), AXISCERT_FIELD(invalid), AXISCERT_FIELD(unanswered),
                  AXISCERT_FIELD(missed, "Null, like deepest_missed, where no contact was decided."),
                  AXISCERT_FIELD(phantom, "Null, like deepest_phantom, where no separation was."),
                  AXISCERT_FIELD(deepest_missed), AXISCERT_FIELD(deepest_phantom), AXISCERT_FIELD(median_ulps),
                  AXISCERT_FIELD(largest_ulps))
};

struct BreakStatement {
  std::optional<Precision> precision;
  SaidText what, cause, meaning;
  std::uint64_t count = 0;
  TextNumber deepest;
  SaidText advice, section;

  AXISCERT_FIELDS(BreakStatement, AXISCERT_FIELD(precision), AXISCERT_FIELD(what), AXISCERT_FIELD(cause),
                  AXISCERT_FIELD(meaning), AXISCERT_FIELD(count), AXISCERT_FIELD(deepest), AXISCERT_FIELD(advice),
                  AXISCERT_FIELD(section, "The part of the documents that says more."))
};

struct SituationStatement {
  Precision precision = Precision::binary32;
  TextNumber situation;
  SaidText meaning;
  Several<SaidText, 1, 1000> families;
  std::uint64_t missed = 0;
  TextNumber deepest_missed;
  std::uint64_t phantom = 0;
  TextNumber deepest_phantom;
  SaidText advice, section;

  AXISCERT_FIELDS(SituationStatement, AXISCERT_FIELD(precision), AXISCERT_FIELD(situation), AXISCERT_FIELD(meaning),
                  AXISCERT_FIELD(families, "Those with a wrong verdict, the deepest first."), AXISCERT_FIELD(missed),
                  AXISCERT_FIELD(deepest_missed), AXISCERT_FIELD(phantom), AXISCERT_FIELD(deepest_phantom),
                  AXISCERT_FIELD(advice), AXISCERT_FIELD(section))
};

struct CertificateWitness {
  SaidText title, sentence, address, command;
  JsonObject query;

  AXISCERT_FIELDS(CertificateWitness, AXISCERT_FIELD(title), AXISCERT_FIELD(sentence), AXISCERT_FIELD(address),
                  AXISCERT_FIELD(command), AXISCERT_FIELD(query))
};

}  // namespace axiscert
