// What a certificate says of a kernel: the parts of its predicate that were found.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/fields/json_form.h"
#include "fuzz/record/plan_record.h"
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

  static constexpr auto fields(auto&& visit) {
    using Of = KernelStatement;
    return visit(field(&Of::id, {"id", {}}), field(&Of::kind, {"kind", {}}),
                 field(&Of::question, {"question", "The predicate that it computes."}),
                 field(&Of::entry, {"entry", "The form in which it takes the numbers of the predicate."}),
                 field(&Of::summary, {"summary", {}}), field(&Of::exposes, {"exposes", {}}),
                 field(&Of::touching, {"touching", {}}),
                 field(&Of::limits, {"limits", "Where it promises to be right; null: everywhere."}),
                 field(&Of::may_decline, {"may_decline", {}}), field(&Of::precisions, {"precisions", {}}));
  }
};

struct EffortRule {
  static constexpr std::size_t longest = 8;
  static constexpr std::string_view pattern = "^(smoke|quick|standard|deep|replies)$";
};

struct LeftOutStatement {
  std::uint64_t no_query = 0, outside_limits = 0, touching = 0, declined = 0, invalid = 0, unanswered = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = LeftOutStatement;
    return visit(field(&Of::no_query, {"no_query", {}}), field(&Of::outside_limits, {"outside_limits", {}}),
                 field(&Of::touching, {"touching", {}}), field(&Of::declined, {"declined", {}}),
                 field(&Of::invalid, {"invalid", {}}), field(&Of::unanswered, {"unanswered", {}}));
  }
};

struct AskedStatement {
  Text<EffortRule> effort;
  WholeNumber seed;
  std::uint64_t stretches = 0, queries = 0, looked_at = 0;
  LeftOutStatement left_out;
  Several<SaidText, 0, 10000> families;

  static constexpr auto fields(auto&& visit) {
    using Of = AskedStatement;
    return visit(field(&Of::effort, {"effort", {}}), field(&Of::seed, {"seed", {}}),
                 field(&Of::stretches, {"stretches", {}}), field(&Of::queries, {"queries", {}}),
                 field(&Of::looked_at, {"looked_at", {}}), field(&Of::left_out, {"left_out", {}}),
                 field(&Of::families, {"families", {}}));
  }
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

  static constexpr auto fields(auto&& visit) {
    return visit(field(&GroundStatement::kind, {"kind", {}}), field(&GroundStatement::text, {"text", {}}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = LevelStatement;
    return visit(field(&Of::level, {"level", {}}),
                 field(&Of::precision, {"precision", "Null of a kernel that could not be loaded."}),
                 field(&Of::state, {"state", {}}),
                 field(&Of::claim, {"claim", "Its name, and how much of its families it is said of."}),
                 field(&Of::looked_at, {"looked_at", "How many queries."}),
                 field(&Of::statement, {"statement", "What it says, in words."}),
                 field(&Of::rests_on, {"rests_on", {}}), field(&Of::leaves_out, {"leaves_out", {}}),
                 field(&Of::failures, {"failures", "The first of failure_count, of one that is not met."}),
                 field(&Of::failure_count, {"failure_count", {}}),
                 field(&Of::reason, {"reason", "Of one that was not checked."}));
  }
};

// The safe margin.

struct ContactsStatement {
  std::uint64_t asked = 0, missed = 0, declined = 0, invalid = 0, unanswered = 0;

  static constexpr std::string_view about =
      "Contacts that the kernel was asked about, and those that it did not call so.";
  static constexpr auto fields(auto&& visit) {
    using Of = ContactsStatement;
    return visit(field(&Of::asked, {"asked", {}}), field(&Of::missed, {"missed", {}}),
                 field(&Of::declined, {"declined", {}}), field(&Of::invalid, {"invalid", {}}),
                 field(&Of::unanswered, {"unanswered", {}}));
  }
};

struct MarginContactsStatement {
  ContactsStatement of_run, of_others;

  static constexpr auto fields(auto&& visit) {
    using Of = MarginContactsStatement;
    return visit(field(&Of::of_run, {"of_run", ContactsStatement::about}),
                 field(&Of::of_others, {"of_others", "At the least radius, and of a search."}));
  }
};

struct MissedStatement {
  TextNumber value, r;
  std::optional<TextNumber> contact_from;
  SaidText family;
  JsonObject query;

  static constexpr auto fields(auto&& visit) {
    using Of = MissedStatement;
    return visit(field(&Of::value, {"value", {}}), field(&Of::r, {"r", {}}),
                 field(&Of::contact_from, {"contact_from", "The least radius for which the kernel says contact."}),
                 field(&Of::family, {"family", {}}), field(&Of::query, {"query", {}}));
  }
};

struct MarginPartStatement {
  std::uint64_t queries = 0, contacts = 0, without_verdict = 0, missed = 0, hopeless = 0, tiny = 0, unmeasured = 0;
  std::optional<TextNumber> factor, amount;
  std::uint64_t phantoms_by_factor = 0, phantoms_by_amount = 0, still_missed_by_factor = 0, still_missed_by_amount = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = MarginPartStatement;
    return visit(field(&Of::queries, {"queries", {}}), field(&Of::contacts, {"contacts", {}}),
                 field(&Of::without_verdict, {"without_verdict", {}}), field(&Of::missed, {"missed", {}}),
                 field(&Of::hopeless, {"hopeless", {}}), field(&Of::tiny, {"tiny", {}}),
                 field(&Of::unmeasured, {"unmeasured", {}}), field(&Of::factor, {"factor", {}}),
                 field(&Of::amount, {"amount", {}}), field(&Of::phantoms_by_factor, {"phantoms_by_factor", {}}),
                 field(&Of::phantoms_by_amount, {"phantoms_by_amount", {}}),
                 field(&Of::still_missed_by_factor, {"still_missed_by_factor", {}}),
                 field(&Of::still_missed_by_amount, {"still_missed_by_amount", {}}));
  }
};

struct MarginDecadeStatement : MarginPartStatement {
  bool degenerate = false;
  int decade = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = MarginDecadeStatement;
    return visit(base<Of, MarginPartStatement>(), field(&Of::degenerate, {"degenerate", {}}),
                 field(&Of::decade, {"decade", "Scenes from this power of ten on."}));
  }
};

struct MarginStatement {
  Precision precision = Precision::binary32;
  std::uint64_t queries = 0, probed = 0, found = 0, phantoms = 0;
  MarginContactsStatement contacts;
  std::optional<MissedStatement> factor, amount, hopeless;
  MarginPartStatement all;
  Several<MarginDecadeStatement, 0, 2000> decades;

  static constexpr auto fields(auto&& visit) {
    using Of = MarginStatement;
    return visit(
        field(&Of::precision, {"precision", {}}), field(&Of::queries, {"queries", {}}),
        field(&Of::probed, {"probed", {}}), field(&Of::found, {"found", {}}), field(&Of::phantoms, {"phantoms", {}}),
        field(&Of::contacts, {"contacts", {}}), field(&Of::factor, {"factor", {}}), field(&Of::amount, {"amount", {}}),
        field(&Of::hopeless, {"hopeless", {}}), field(&Of::all, {"all", {}}), field(&Of::decades, {"decades", {}}));
  }
};

// What a stage gave in each precision, or the reason why it gave nothing.
template <class Precisions>
struct StageStatement {
  std::optional<SaidText> reason;
  Precisions precisions;

  static constexpr auto fields(auto&& visit) {
    using Of = StageStatement;
    return visit(field(&Of::reason, {"reason", "Why there is none; null where there is."}),
                 field(&Of::precisions, {"precisions", {}}));
  }
};
using SafeMarginStatement = StageStatement<Several<MarginStatement, 0, 2>>;

// Diagnosis, search, planted faults.

struct PropertyStatement {
  SaidText name, value, sentence;
  std::uint64_t queries = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = PropertyStatement;
    return visit(field(&Of::name, {"name", {}}), field(&Of::value, {"value", {}}),
                 field(&Of::sentence, {"sentence", {}}), field(&Of::queries, {"queries", {}}));
  }
};

struct DiagnosedStatement {
  Precision precision = Precision::binary32;
  Several<PropertyStatement, 0, 200> properties;

  static constexpr auto fields(auto&& visit) {
    using Of = DiagnosedStatement;
    return visit(field(&Of::precision, {"precision", {}}), field(&Of::properties, {"properties", {}}));
  }
};
using DiagnosisStatement = StageStatement<Several<DiagnosedStatement, 0, 2>>;

struct FindStatement {
  std::optional<TextNumber> depth, ulps;
  std::optional<Several<SaidText, 0, 8>> links;
  JsonObject query;

  static constexpr auto fields(auto&& visit) {
    using Of = FindStatement;
    return visit(field(&Of::depth,
                       {.name = "depth", .about = "Of a wrong verdict, relative to the scene.", .may_be_absent = true}),
                 field(&Of::ulps, {.name = "ulps", .about = "Of a critical radius.", .may_be_absent = true}),
                 field(&Of::links, {.name = "links", .about = {}, .may_be_absent = true}),
                 field(&Of::query, {"query", {}}));
  }
};

struct SearchedStatement {
  std::uint64_t evaluations = 0, begun_from = 0;
  NamedValues<std::optional<FindStatement>> finds;

  const FindStatement* find(std::string_view goal) const {
    const auto* found = finds.find(goal);
    return found && *found ? &**found : nullptr;
  }
  static constexpr auto fields(auto&& visit) {
    using Of = SearchedStatement;
    return visit(field(&Of::evaluations, {"evaluations", {}}), field(&Of::begun_from, {"begun_from", {}}),
                 field(&Of::finds, {"finds", "The worst of each goal; null: none was found."}));
  }
};
using SearchesStatement = StageStatement<NamedValues<SearchedStatement>>;

struct PlantedScore {
  std::uint64_t mutants = 0, noticed = 0, survived = 0, equivalent = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = PlantedScore;
    return visit(field(&Of::mutants, {"mutants", {}}), field(&Of::noticed, {"noticed", {}}),
                 field(&Of::survived, {"survived", {}}), field(&Of::equivalent, {"equivalent", {}}));
  }
};

struct HarnessStatement {
  std::optional<SaidText> reason, judged_by, made_of;
  std::uint64_t planted = 0, exist = 0, queries = 0;
  NamedValues<PlantedScore> score;

  static constexpr std::string_view about = "Faults planted in a right kernel that shows as much as this one.";
  static constexpr auto fields(auto&& visit) {
    using Of = HarnessStatement;
    return visit(field(&Of::reason, {"reason", "Why it was not asked; null where it was."}),
                 field(&Of::judged_by, {"judged_by", {}}), field(&Of::made_of, {"made_of", {}}),
                 field(&Of::planted, {"planted", {}}), field(&Of::exist, {"exist", {}}),
                 field(&Of::queries, {"queries", {}}), field(&Of::score, {"score", "By precision."}));
  }
};

// Wrong verdicts.

struct ComparisonStatement {
  SaidText kernel;
  Precision precision = Precision::binary32;
  std::uint64_t looked_at = 0, missed = 0;
  TextNumber deepest_missed;
  std::uint64_t phantom = 0;
  TextNumber deepest_phantom;
  std::uint64_t undecided = 0, invalid = 0, unanswered = 0;
  std::optional<TextNumber> median_ulps, largest_ulps;

  static constexpr auto fields(auto&& visit) {
    using Of = ComparisonStatement;
    return visit(field(&Of::kernel, {"kernel", {}}), field(&Of::precision, {"precision", {}}),
                 field(&Of::looked_at, {"looked_at", {}}), field(&Of::missed, {"missed", {}}),
                 field(&Of::deepest_missed, {"deepest_missed", {}}), field(&Of::phantom, {"phantom", {}}),
                 field(&Of::deepest_phantom, {"deepest_phantom", {}}), field(&Of::undecided, {"undecided", {}}),
                 field(&Of::invalid, {"invalid", {}}), field(&Of::unanswered, {"unanswered", {}}),
                 field(&Of::median_ulps, {"median_ulps", {}}), field(&Of::largest_ulps, {"largest_ulps", {}}));
  }
};

struct BreakStatement {
  std::optional<Precision> precision;
  SaidText what, cause, meaning;
  std::uint64_t count = 0;
  TextNumber deepest;
  SaidText advice, section;

  static constexpr auto fields(auto&& visit) {
    using Of = BreakStatement;
    return visit(field(&Of::precision, {"precision", {}}), field(&Of::what, {"what", {}}),
                 field(&Of::cause, {"cause", {}}), field(&Of::meaning, {"meaning", {}}),
                 field(&Of::count, {"count", {}}), field(&Of::deepest, {"deepest", {}}),
                 field(&Of::advice, {"advice", {}}),
                 field(&Of::section, {"section", "The part of the documents that says more."}));
  }
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

  static constexpr auto fields(auto&& visit) {
    using Of = SituationStatement;
    return visit(field(&Of::precision, {"precision", {}}), field(&Of::situation, {"situation", {}}),
                 field(&Of::meaning, {"meaning", {}}),
                 field(&Of::families, {"families", "Those with a wrong verdict, the deepest first."}),
                 field(&Of::missed, {"missed", {}}), field(&Of::deepest_missed, {"deepest_missed", {}}),
                 field(&Of::phantom, {"phantom", {}}), field(&Of::deepest_phantom, {"deepest_phantom", {}}),
                 field(&Of::advice, {"advice", {}}), field(&Of::section, {"section", {}}));
  }
};

struct CertificateWitness {
  SaidText title, sentence, address, command;
  JsonObject query;

  static constexpr auto fields(auto&& visit) {
    using Of = CertificateWitness;
    return visit(field(&Of::title, {"title", {}}), field(&Of::sentence, {"sentence", {}}),
                 field(&Of::address, {"address", {}}), field(&Of::command, {"command", {}}),
                 field(&Of::query, {"query", {}}));
  }
};

}  // namespace axiscert
