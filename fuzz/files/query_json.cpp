// A query of the members of a line, and the line of a query.
#include "fuzz/files/query_object.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fuzz/files/line_members.h"
#include "fuzz/files/nested_members.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// Members that axiscert writes on a line beside the query: in witnesses, in the output of `check`, `shrink` and
// `search`, in the corpus.
constexpr std::string_view written_beside_queries[] = {"kernel",
                                                       "family",
                                                       "address",
                                                       "truth",
                                                       "computed",
                                                       "touching",
                                                       "depth",
                                                       "exact_comparisons",
                                                       "length",
                                                       "shows",
                                                       "flips",
                                                       "sides",
                                                       "provenance",
                                                       "note",
                                                       "expected",
                                                       "exact",
                                                       "computed_comparisons",
                                                       "errors",
                                                       "findings",
                                                       "within_limits",
                                                       "severity",
                                                       "bits",
                                                       "nonzero",
                                                       "kept",
                                                       "before",
                                                       "steps",
                                                       "evaluations",
                                                       "complete",
                                                       "measures",
                                                       "exact_contact",
                                                       "schema",
                                                       "axiscert",
                                                       "revision"};
bool is_written_beside_queries(std::string_view field) {
  return std::find(std::begin(written_beside_queries), std::end(written_beside_queries), field) !=
         std::end(written_beside_queries);
}

// The members of one line as a query.
class QueryOfMembers {
 public:
  QueryOfMembers(const LineMembers& given, const Place& place, KnownPredicates known)
      : given_(given), place_(place), known_(known) {}

  StoredQuery query(std::vector<UnreadField>* unread) const {
    const EntryOfPredicate of = entry_given_once();
    const Precision precision = precision_of_line(of);
    const JsonValue& id = given_.at("id").value;
    if (id.kind != JsonKind::absent && id.kind != JsonKind::string) throw_wrong_kind("id", id.kind, "a string");
    std::vector<NumberText> numbers;
    for (const ColumnGroup& group : groups_of(of.columns())) take_group(group, of, numbers);
    const std::vector<UnreadField> unread_here = unread_fields(of);
    for (const UnreadField& field : unread_here) {
      if (field.name.find('.') != field.name.npos) fail(nested(of).unread_inside(field.name, of.columns()), of);
    }
    StoredQuery stored =
        stored_query(id.kind == JsonKind::string ? id.text : place_.default_id(), precision, of, numbers, place_);
    if (const JsonValue& address = given_.at("address").value; address.kind == JsonKind::string) {
      stored.address = printable_line(address.text);
    }
    if (unread != nullptr) unread->insert(unread->end(), unread_here.begin(), unread_here.end());
    return stored;
  }

  // The predicate and the entry of the line. Fails if a member that matters to these was given twice.
  EntryOfPredicate entry_given_once() const {
    const auto fail_if_repeated = [&](const auto& matters) {
      const auto twice = std::find_if(given_.repeated.begin(), given_.repeated.end(), matters);
      if (twice != given_.repeated.end()) place_.fail(*twice, "given twice");
    };
    fail_if_repeated([](const std::string& name) { return name == "predicate" || name == "entry"; });
    const EntryOfPredicate of = entry_of_line();
    const std::vector<ColumnGroup> groups = groups_of(of.columns());
    fail_if_repeated([&](const std::string& name) {
      return name == "id" || name == "precision" || std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
               return group.name == name || is_within(group.name, name);
             });
    });
    return of;
  }

 private:
  // The names of the members that a query of this entry has.
  std::vector<std::string_view> member_names(const EntryOfPredicate& of) const {
    std::vector<std::string_view> names = {"id", "precision", "predicate", "entry"};
    for (const ColumnGroup& group : groups_of(of.columns())) names.push_back(group.name);
    return names;
  }

  // "; it has what is not read: 'radius' (did you mean 'r'?)", for a line that lacks a member.
  std::string unknown_fields(const EntryOfPredicate& of) const {
    std::vector<std::string> texts;
    for (const UnreadField& field : unread_fields(of)) {
      if (texts.size() == 4) break;
      texts.push_back(fmt::format("'{}'{}", shown(field.name),
                                  field.meant.empty() ? "" : fmt::format(" (did you mean '{}'?)", field.meant)));
    }
    return texts.empty() ? "" : fmt::format("; it has what is not read: {}", fmt::join(texts, ", "));
  }

  std::vector<UnreadField> unread_fields(const EntryOfPredicate& of) const {
    const std::vector<std::string_view> names = member_names(of);
    std::vector<UnreadField> unread;
    for (const auto& [given, ignored] : given_.members) {
      if (std::find(names.begin(), names.end(), given) != names.end() || is_written_beside_queries(given)) continue;
      const auto holds_some = [&](std::string_view outer) {
        return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return is_within(name, outer); });
      };
      // A member that is not read stands for all that is nested in it.
      const std::size_t nested = given.find('.');
      if (holds_some(given) || (nested != given.npos && !holds_some(given.substr(0, nested)))) continue;
      if (std::any_of(unread.begin(), unread.end(), [&](const auto& outer) { return is_within(given, outer.name); }))
        continue;
      unread.push_back({given, meant_member(given, names)});
    }
    return unread;
  }

  // The absent member of the same object whose name is near, or empty.
  std::string meant_member(std::string_view given, const std::vector<std::string_view>& names) const {
    const std::size_t begin = given.rfind('.') + 1;  // 0 without a dot
    const std::string_view object = given.substr(0, begin), own = given.substr(begin);
    std::vector<std::string_view> absent;
    for (const std::string_view name : names) {
      if (!name.starts_with(object)) continue;
      const std::string_view path = name.substr(0, name.find('.', begin));
      const auto is_there = [&](const auto& member) { return member.first == path || is_within(member.first, path); };
      if (std::none_of(given_.members.begin(), given_.members.end(), is_there)) absent.push_back(path.substr(begin));
    }
    // The names of these members in other programs.
    for (const auto& [other, member] : {std::pair<std::string_view, std::string_view>{"radius", "r"},
                                        {"center", "p"},
                                        {"centre", "p"},
                                        {"center", "m"},
                                        {"centre", "m"},
                                        {"half", "s"},
                                        {"low", "min"},
                                        {"high", "max"},
                                        {"quaternion", "q"},
                                        {"name", "id"}}) {
      if (own == other && std::find(absent.begin(), absent.end(), member) != absent.end())
        return fmt::format("{}{}", object, member);
    }
    const std::string_view name = meant(own, absent);
    return name.empty() ? "" : fmt::format("{}{}", object, name);
  }

  // `of` is the line's, where a member of it may be missing.
  [[noreturn]] void throw_wrong_kind(std::string_view blamed, JsonKind given, std::string_view expected,
                                     const EntryOfPredicate* of = nullptr) const {
    place_.fail(blamed, fmt::format("{}; {} belongs here{}", name(given), expected,
                                    given == JsonKind::absent && of != nullptr ? unknown_fields(*of) : ""));
  }

  bool states_entry() const { return given_.at("entry").value.kind == JsonKind::string; }

  NestedMembers nested(const EntryOfPredicate& of) const {
    const std::span<const PredicateEntry> entries = of.predicate->entries;
    return {given_, states_entry() ? entries.subspan(of.entry, 1) : entries};
  }

  [[noreturn]] void fail(const MemberFault& fault, const EntryOfPredicate& of) const {
    place_.fail(fault.field, fault.says + (fault.is_missing ? unknown_fields(of) : ""));
  }

  EntryOfPredicate entry_of_line() const {
    const JsonValue &predicate = given_.at("predicate").value, &entry = given_.at("entry").value;
    if (predicate.kind != JsonKind::absent && predicate.kind != JsonKind::string)
      throw_wrong_kind("predicate", predicate.kind, "the id of a predicate");
    if (entry.kind != JsonKind::absent && entry.kind != JsonKind::string)
      throw_wrong_kind("entry", entry.kind, "an entry's name");
    EntryOfPredicate of{nullptr, 0};
    try {
      of.predicate = predicate.kind == JsonKind::string ? &find_predicate(shown(predicate.text), known_)
                                                        : &predicate_named("", known_);
    } catch (const Error& unknown) {
      place_.fail("predicate", unknown.what());
    }
    if (entry.kind == JsonKind::absent) {
      of.entry = entry_of_most_members(*of.predicate, given_);
      return of;
    }
    try {
      of.entry = find_entry(*of.predicate, shown(entry.text));
    } catch (const Error& unknown) {
      place_.fail("entry", unknown.what());
    }
    return of;
  }

  Precision precision_of_line(const EntryOfPredicate& of) const {
    const JsonValue& given = given_.at("precision").value;
    if (given.kind != JsonKind::string) throw_wrong_kind("precision", given.kind, "\"binary32\" or \"binary64\"", &of);
    try {
      return parse_precision(shown(given.text));
    } catch (const Error& unknown) {
      place_.fail("precision", unknown.what());
    }
  }

  std::string number_text(std::string_view blamed, std::string_view element, const JsonValue& value,
                          const EntryOfPredicate& of) const {
    if (value.kind != JsonKind::number && value.kind != JsonKind::string) {
      place_.fail(blamed, fmt::format("{}{}; a number belongs here{}", element, name(value.kind),
                                      value.kind == JsonKind::absent ? unknown_fields(of) : ""));
    }
    return value.text;
  }

  void take_group(const ColumnGroup& group, const EntryOfPredicate& of, std::vector<NumberText>& numbers) const {
    const JsonMember& given = given_.at(group.name);
    if (given.value.kind == JsonKind::absent) {
      if (const auto fault = nested(of).mixed_entries()) fail(*fault, of);
    }
    // Around a member that is there only an array can be wrong: its length, or an object in its place.
    if (given.value.kind == JsonKind::absent || group.name.ends_with(".0")) {
      if (const auto fault = nested(of).fault_around(group.name, of.columns())) fail(*fault, of);
    }
    if (group.size == 1) {
      numbers.push_back({std::string(group.name), "", number_text(group.name, "", given.value, of)});
      return;
    }
    const std::string due = fmt::format("an array of {} numbers", count_in_words(group.size));
    if (given.value.kind != JsonKind::array) throw_wrong_kind(group.name, given.value.kind, due, &of);
    if (given.elements.size() != group.size) {
      place_.fail(group.name, fmt::format("an array of {}; {} belongs here", given.elements.size(), due));
    }
    for (std::size_t i = 0; i < group.size; ++i) {
      const std::string element = fmt::format("element {}: ", i + 1);
      numbers.push_back({std::string(group.name), element, number_text(group.name, element, given.elements[i], of)});
    }
  }

  const LineMembers& given_;
  const Place& place_;
  KnownPredicates known_;
};

template <class Real>
std::string group_text(const ColumnGroup& group, const Numbers<Real>& numbers) {
  std::string text;
  for (std::size_t k = group.first; k < group.first + group.size; ++k) {
    text += fmt::format("{}\"{}\"", text.empty() ? "" : ",", format_number(numbers[k]));
  }
  return group.size == 1 ? text : fmt::format("[{}]", text);
}

template <class Real>
std::string json_numbers(const PredicateEntry& entry, const Numbers<Real>& numbers) {
  NestedText text;
  for (const ColumnGroup& group : groups_of(entry)) text.add(group.name, group_text(group, numbers));
  return std::move(text).take();
}

}  // namespace

StoredQuery query_of_json(std::string_view line, const Place& place, KnownPredicates known,
                          std::vector<UnreadField>* unread) {
  // A member that is given twice is told before a fault behind it.
  const auto require_once = [&](const LineMembers& so_far) {
    if (!so_far.repeated.empty()) QueryOfMembers(so_far, place, known).entry_given_once();
  };
  return QueryOfMembers(read_members(line, place, known, require_once), place, known).query(unread);
}

std::string query_line(const StoredQuery& stored) {
  // An id from a CSV file may not be UTF-8.
  const std::string id = nlohmann::json(stored.id).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string of;
  if (const std::string_view predicate = written_name(*stored.predicate); !predicate.empty())
    of += fmt::format(R"(,"predicate":"{}")", predicate);
  if (stored.entry != 0) of += fmt::format(R"(,"entry":"{}")", stored.columns().name);
  return fmt::format(
      R"({{"id":{},"precision":"{}"{}{}}})", id, name(stored.precision), of,
      std::visit([&](const auto& numbers) { return json_numbers(stored.columns(), numbers); }, stored.numbers));
}

Json detail_json(const Detail& detail) {
  if (const double* number = std::get_if<double>(&detail.value)) return format_number(*number);
  if (const auto* word = std::get_if<std::string_view>(&detail.value)) return *word;
  if (const auto* names = std::get_if<std::vector<std::string_view>>(&detail.value)) return *names;
  return nullptr;
}

}  // namespace axiscert
