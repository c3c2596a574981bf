// What a struct says of its members, once:
//
//   struct TruthCounts {
//     std::uint64_t separated = 0, contact = 0;
//     static constexpr std::string_view about = "The geometric truth of the queries.";
//     AXISCERT_FIELDS(TruthCounts,
//                     AXISCERT_FIELD(separated, "Queries whose exact distance is greater than r."),
//                     AXISCERT_FIELD(contact, "The other valid ones."))
//   };
//
// `about` may be left out; where there is `is_open`, readers ignore members of JSON that no field has. The fields are
// all members in their order, or for_each_field() does not compile. A const member function without parameters is a
// field as well: it is written, and compared where it is read, but not stored.
#pragma once

#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace axiscert {
// Values by name, in the order in which they were put.

template <class T>
class NamedValues {
 public:
  // The value of that name, which is made if there is none.
  T& put(std::string_view name) {
    if (T* found = find(name)) return *found;
    return all_.emplace_back(std::string(name), T()).second;
  }
  T* find(std::string_view name) {
    for (auto& [key, value] : all_) {
      if (key == name) return &value;
    }
    return nullptr;
  }
  const T* find(std::string_view name) const { return const_cast<NamedValues*>(this)->find(name); }
  bool contains(std::string_view name) const { return find(name) != nullptr; }
  // Throws std::out_of_range if there is none.
  T& at(std::string_view name) {
    if (T* found = find(name)) return *found;
    throw std::out_of_range("no value is named " + std::string(name));
  }
  const T& at(std::string_view name) const { return const_cast<NamedValues*>(this)->at(name); }

  // By number, in their order.
  T& operator[](std::size_t i) { return all_[i].second; }
  const T& operator[](std::size_t i) const { return all_[i].second; }
  const std::string& name(std::size_t i) const { return all_[i].first; }

  std::size_t size() const { return all_.size(); }
  bool empty() const { return all_.empty(); }
  auto begin() { return all_.begin(); }  // pairs of a name and a value
  auto end() { return all_.end(); }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  bool operator==(const NamedValues&) const = default;

 private:
  std::vector<std::pair<std::string, T>> all_;
};

// How two values of a field become one, where the type does not say it, as of a number that is not a count: one of
// these, or a type with merge(into, from). By type, counts add up, leaders compete, and structs merge by their fields.
namespace by {

struct Type {};
struct AddedUp {};
struct Greatest {};
struct Least {};  // of a bool: true where both are
struct First {};  // of two in their order, where it has a value
struct Same {};   // in all that are merged
inline constexpr AddedUp added;
inline constexpr Greatest greatest;
inline constexpr Least least;
inline constexpr First first;
inline constexpr Same same;

}  // namespace by

struct Field {
  std::string_view name;            // in JSON, and in the path of a column
  std::string_view about = {};      // one sentence: what is counted, and what null means
  std::string_view unit = {};       // empty: queries, of a count; of another number, none
  bool is_inlined = false;          // JSON has the fields of this struct in its place
  bool may_be_absent = false;       // an empty optional is left out of JSON, and not null
  bool is_rest = false;             // a Named: its values are members of the struct's object, whatever their names
  std::string_view looked_at = {};  // the count beside it of what it was seen on; where that is 0, JSON has null here
};

template <class Of, class Member, class How = by::Type>
struct FieldOf : Field {
  Member Of::*member;
  using Merge = How;
  static constexpr bool is_stored = !std::is_function_v<Member>, is_written = true;
};

template <class Of, class Member, class How = by::Type>
constexpr FieldOf<Of, Member, How> field(Member Of::*member, const Field& said, How = {}) {
  return {said, member};
}
// A base class, or a member that is a struct, whose fields JSON has in its place.
template <class Of, class Base>
struct BaseOf : Field {
  using Merge = by::Type;
  static constexpr bool is_stored = true, is_written = true;
};
template <class Of, class Base>
constexpr BaseOf<Of, Base> base() {
  return {{.name = {}, .about = {}, .is_inlined = true}};
}
template <class Of, class Member>
constexpr FieldOf<Of, Member> inlined(Member Of::*member) {
  return {{.name = {}, .about = {}, .is_inlined = true}, member};
}
template <class Of, class Member>
constexpr FieldOf<Of, Member> rest(Member Of::*member) {
  return {{.name = {}, .about = {}, .is_rest = true}, member};
}
// What journals have and JSON has not: places of queries, from which others make something again.
template <class Of, class Member, class How>
struct UnwrittenOf : FieldOf<Of, Member, How> {
  static constexpr bool is_written = false;
};
template <class Of, class Member, class How = by::Type>
constexpr UnwrittenOf<Of, Member, How> journalled(Member Of::*member, How = {}) {
  return {{{.name = {}, .about = {}}, member}};
}
// Members of which nothing is said but how they are merged.
template <class... Fields>
constexpr auto merged(auto&& visit, Fields... members) {
  const auto field_of = [](auto member) {
    if constexpr (std::is_member_object_pointer_v<decltype(member)>) return journalled(member);
    else return member;
  };
  return visit(field_of(members)...);
}

// An optional of which an empty one is left out of JSON.
constexpr Field optional_field(std::string_view name, std::string_view about = {}, std::string_view unit = {}) {
  return {.name = name, .about = about, .unit = unit, .may_be_absent = true};
}

// A figure of what `count` counts: null where that is 0.
constexpr Field figure_of(std::string_view count, std::string_view name, std::string_view about,
                          std::string_view unit = {}) {
  return {.name = name, .about = about, .unit = unit, .looked_at = count};
}

// The fields of a struct, which is `Of` among them; a member by its own name, and what is said of it: what it is about,
// and its unit.
#define AXISCERT_FIELDS(Struct, ...)           \
  static constexpr auto fields(auto&& visit) { \
    using Of [[maybe_unused]] = Struct;        \
    return visit(__VA_ARGS__);                 \
  }
#define AXISCERT_FIELD(member, ...) field(&Of::member, {#member __VA_OPT__(, ) __VA_ARGS__})
#define AXISCERT_OPTIONAL_FIELD(member, ...) field(&Of::member, optional_field(#member __VA_OPT__(, ) __VA_ARGS__))

template <class Of>
concept Fielded = requires { Of::fields([](const auto&...) {}); };

namespace fields_of {

template <class... Members>
struct StoredMembers {
  template <class Of>
  static constexpr bool make() {
    return requires { Of{std::declval<Members>()...}; } && !requires { Of{std::declval<Members>()..., {}}; };
  }
  template <class Of, class Member, class How>
  friend constexpr auto operator+(StoredMembers, const FieldOf<Of, Member, How>&) {
    if constexpr (std::is_function_v<Member>) return StoredMembers();
    else return StoredMembers<Members..., Member>();
  }
  template <class Of, class Base>
  friend constexpr auto operator+(StoredMembers, const BaseOf<Of, Base>&) {
    return StoredMembers<Members..., Base>();
  }
};

template <Fielded Of>
constexpr bool are_whole() {
  return Of::fields(
      [](const auto&... each) { return decltype((StoredMembers<>() + ... + each))::template make<Of>(); });
}

}  // namespace fields_of

// Calls visit(field) with the FieldOf of each field.
template <Fielded Of, class Visit>
constexpr void for_each_field(Visit&& visit) {
  static_assert(fields_of::are_whole<Of>(), "fields() leaves out a member, or has another order than the members");
  Of::fields([&](const auto&... each) { (visit(each), ...); });
}

// The same of those that JSON has.
template <Fielded Of, class Visit>
constexpr void for_each_written(Visit&& visit) {
  for_each_field<Of>([&](const auto& field) {
    if constexpr (std::remove_cvref_t<decltype(field)>::is_written) visit(field);
  });
}

// The value of a field: a member, or what a function of it says.
template <class Of, std::derived_from<Of> Holder, class Member, class How>
constexpr decltype(auto) value_of(Holder& of, const FieldOf<Of, Member, How>& field) {
  if constexpr (std::is_function_v<Member>) return (of.*field.member)();
  else return (of.*field.member);
}
template <class Of, class Base>
constexpr auto& value_of(Of& of, const BaseOf<std::remove_const_t<Of>, Base>&) {
  return static_cast<std::conditional_t<std::is_const_v<Of>, const Base, Base>&>(of);
}

}  // namespace axiscert
