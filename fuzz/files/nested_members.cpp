#include "fuzz/files/nested_members.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "fuzz/text/json.h"

namespace axiscert {
namespace {

std::vector<std::string> names_of(std::string_view path) {
  std::vector<std::string> names;
  for (;;) {
    const std::size_t dot = path.find('.');
    names.emplace_back(path.substr(0, dot));
    if (dot == path.npos) return names;
    path.remove_prefix(dot + 1);
  }
}

bool is_index(const std::string& name) { return name.find_first_not_of("0123456789") == name.npos; }

}  // namespace

void NestedText::add(std::string_view path, std::string_view value) {
  const std::vector<std::string> names = names_of(path);
  std::size_t shared = 0;
  while (shared < open_.size() && shared + 1 < names.size() && open_[shared] == names[shared]) ++shared;
  leave(shared);
  for (std::size_t i = shared; i < names.size(); ++i) {
    const bool is_first = !text_.empty() && (text_.back() == '{' || text_.back() == '[');
    if (!is_first) text_ += ',';
    if (!is_index(names[i])) text_ += '"' + names[i] + "\":";
    if (i + 1 == names.size()) break;
    const bool holds_elements = is_index(names[i + 1]);
    text_ += holds_elements ? '[' : '{';
    ends_ += holds_elements ? ']' : '}';
    open_.push_back(names[i]);
  }
  text_ += value;
}

void NestedText::leave(std::size_t depth) {
  while (open_.size() > depth) {
    text_ += ends_.back();
    ends_.pop_back();
    open_.pop_back();
  }
}

std::string NestedText::take() && {
  leave(0);
  return std::move(text_);
}

Json& member_at(Json& object, std::string_view path) {
  std::string pointer = "/" + std::string(path);
  std::replace(pointer.begin(), pointer.end(), '.', '/');
  return object[Json::json_pointer(pointer)];
}

namespace {

// "m, s and b".
std::string enumerated(const std::vector<std::string_view>& names) {
  if (names.size() < 2) return names.empty() ? "" : std::string(names.front());
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

template <class Value>
void add_once(std::vector<Value>& values, const Value& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

// The names of the members right inside this one, in the order of the entry: m, s and b in "a".
std::vector<std::string_view> names_inside(std::string_view outer, const PredicateEntry& entry) {
  std::vector<std::string_view> names;
  for (const ColumnGroup& group : groups_of(entry)) {
    if (!is_within(group.name, outer)) continue;
    const std::string_view rest = group.name.substr(outer.size() + 1);
    add_once(names, rest.substr(0, rest.find('.')));
  }
  return names;
}

// Elements of arrays are named by their position.
bool is_array(const std::vector<std::string_view>& names) { return !names.empty() && names.front() == "0"; }

std::vector<std::string_view> those_not_in(const std::vector<std::string_view>& others,
                                           const std::vector<std::string_view>& names) {
  std::vector<std::string_view> rest;
  std::copy_if(names.begin(), names.end(), std::back_inserter(rest),
               [&](std::string_view name) { return std::find(others.begin(), others.end(), name) == others.end(); });
  return rest;
}

}  // namespace

std::string count_in_words(std::size_t count) {
  constexpr std::array<const char*, 10> words = {"no",   "one", "two",   "three", "four",
                                                 "five", "six", "seven", "eight", "nine"};
  return count < words.size() ? words[count] : std::to_string(count);
}

bool is_within(std::string_view path, std::string_view outer) {
  return path.size() > outer.size() && path.starts_with(outer) && path[outer.size()] == '.';
}

std::size_t entry_of_most_members(const Predicate& predicate, const LineMembers& given) {
  std::size_t found = 0;
  std::pair<std::size_t, bool> most{0, false};
  for (std::size_t e = 0; e < predicate.entries.size(); ++e) {
    const std::vector<ColumnGroup> groups = groups_of(predicate.entries[e]);
    const auto is_read = [&](const auto& member) {
      return std::any_of(groups.begin(), groups.end(), [&](const ColumnGroup& group) {
        return group.name == member.first || is_within(group.name, member.first);
      });
    };
    const auto is_given = [&](const ColumnGroup& group) { return given.members.contains(group.name); };
    const auto count = std::count_if(given.members.begin(), given.members.end(), is_read);
    const std::pair<std::size_t, bool> now{static_cast<std::size_t>(count),
                                           std::all_of(groups.begin(), groups.end(), is_given)};
    if (now <= most) continue;
    found = e;
    most = now;
  }
  return found;
}

bool NestedMembers::has(std::string_view path) const {
  return std::any_of(given_.members.begin(), given_.members.end(),
                     [&](const auto& member) { return member.first == path || is_within(member.first, path); });
}

// "with m, s and b or with m, s and q": the members of the object in each of the entries.
std::string NestedMembers::object_forms(std::string_view outer) const {
  std::vector<std::string> forms;
  for (const PredicateEntry& entry : entries_) {
    const std::vector<std::string_view> names = names_inside(outer, entry);
    if (!names.empty()) add_once(forms, "with " + enumerated(names));
  }
  if (forms.size() < 2) return forms.empty() ? "" : forms.front();
  return fmt::format("{} or {}", fmt::join(forms.begin(), forms.end() - 1, ", "), forms.back());
}

std::string NestedMembers::due(std::string_view path, const PredicateEntry& entry) const {
  for (const ColumnGroup& group : groups_of(entry)) {
    if (group.name == path) {
      return group.size == 1 ? "a number" : fmt::format("an array of {} numbers", count_in_words(group.size));
    }
  }
  const std::vector<std::string_view> names = names_inside(path, entry);
  if (!is_array(names)) return "an object " + object_forms(path);
  return fmt::format("an array of {}, each {},", count_in_words(names.size()),
                     due(fmt::format("{}.{}", path, names.front()), entry));
}

std::optional<MemberFault> NestedMembers::fault_around(std::string_view group, const PredicateEntry& entry) const {
  for (std::size_t dot = group.find('.'); dot != group.npos; dot = group.find('.', dot + 1)) {
    const std::string outer(group.substr(0, dot));
    const JsonMember& given = given_.at(outer);
    const auto fault = [&](const std::string& found) {
      return MemberFault{outer, fmt::format("{}; {} belongs here", found, due(outer, entry)),
                         given.value.kind == JsonKind::absent};
    };
    if (given.value.kind == JsonKind::absent) {
      if (!has(outer)) {
        MemberFault missing = fault("missing");
        const std::string object = outer.substr(0, outer.find('.'));
        if (object != outer) missing.says += fmt::format("; '{}' is an object {}", object, object_forms(object));
        return missing;
      }
      continue;  // what it holds is given by paths
    }
    const std::vector<std::string_view> names = names_inside(outer, entry);
    if (given.value.kind != (is_array(names) ? JsonKind::array : JsonKind::object)) {
      return fault(std::string(name(given.value.kind)));
    }
    if (!is_array(names)) continue;
    if (given.elements.size() != names.size()) return fault(fmt::format("an array of {}", given.elements.size()));
    const std::string_view rest = group.substr(dot + 1);
    const auto at = std::find(names.begin(), names.end(), rest.substr(0, rest.find('.')));
    const auto element = static_cast<std::size_t>(at - names.begin());
    const JsonKind kind = given.elements[element].kind;
    if (kind == JsonKind::array || kind == JsonKind::object) continue;  // a member of its own
    return MemberFault{outer, fmt::format("element {}: {}; {} belongs here", element + 1, name(kind),
                                          due(fmt::format("{}.{}", outer, *at), entry))};
  }
  return std::nullopt;
}

// The names inside this object in that entry of which the line has them all, the most of them; empty where none is
// complete.
std::vector<std::string_view> NestedMembers::given_form(std::string_view outer) const {
  std::vector<std::string_view> found;
  std::size_t most = 0;
  for (const PredicateEntry& entry : entries_) {
    const std::vector<ColumnGroup> groups = groups_of(entry);
    const auto is_inside = [&](const ColumnGroup& group) { return is_within(group.name, outer); };
    const auto is_there = [&](const ColumnGroup& group) {
      return !is_inside(group) || given_.members.contains(group.name);
    };
    const auto count = static_cast<std::size_t>(std::count_if(groups.begin(), groups.end(), is_inside));
    if (count <= most || !std::all_of(groups.begin(), groups.end(), is_there)) continue;
    found = names_inside(outer, entry);
    most = count;
  }
  return found;
}

std::optional<MemberFault> NestedMembers::mixed_entries() const {
  std::vector<std::string_view> objects;
  for (const PredicateEntry& entry : entries_) {
    for (const ColumnGroup& group : groups_of(entry)) {
      if (const std::size_t dot = group.name.find('.'); dot != group.name.npos) {
        add_once(objects, group.name.substr(0, dot));
      }
    }
  }
  if (objects.empty()) return std::nullopt;
  const std::vector<std::string_view> first = given_form(objects.front());
  for (const std::string_view object : objects) {
    const std::vector<std::string_view> form = given_form(object);
    if (first.empty() || form.empty() || form == first) continue;
    return MemberFault{std::string(objects.front()),
                       fmt::format("{} is given by {} and {} by {}; both are given in one way, {}", objects.front(),
                                   enumerated(those_not_in(form, first)), object, enumerated(those_not_in(first, form)),
                                   object_forms(objects.front()))};
  }
  return std::nullopt;
}

MemberFault NestedMembers::unread_inside(std::string_view path, const PredicateEntry& entry) const {
  const std::string_view outer = path.substr(0, path.find('.'));
  return {std::string(path), fmt::format("not read beside {}; '{}' is an object {}",
                                         enumerated(names_inside(outer, entry)), outer, object_forms(outer))};
}

}  // namespace axiscert
