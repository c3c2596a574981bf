// JSON Lines by nlohmann's lexer and grammar, but with the characters of each number instead of the library's value,
// which has gone through double.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "fuzz/queries/address.h"
#include "fuzz/text/number_text.h"
#include "fuzz/files/query_line.h"
#include "kernel/base/alike.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// An iterator that counts how far the parser has read.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  std::size_t* consumed;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    ++*consumed;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& i, const CountingIterator& j) { return i.at == j.at; }
};

// The kinds of a value, as messages name them.
enum class Kind { absent, null, boolean, number, string, array, object };
constexpr EnumArray<Kind, std::string_view, 7> kind_names = {"missing",  "null",     "a boolean", "a number",
                                                             "a string", "an array", "an object"};
std::string_view name(Kind kind) { return kind_names[kind]; }

struct Value {
  Kind kind = Kind::absent;
  std::string text;  // for a number its characters, for a string its content
};
struct Field {
  Value value;
  std::vector<Value> elements;  // elements of an array
};

// A count as messages say it.
std::string in_words(std::size_t count) {
  constexpr std::array<const char*, 10> words = {"no",   "one", "two",   "three", "four",
                                                 "five", "six", "seven", "eight", "nine"};
  return count < words.size() ? words[count] : std::to_string(count);
}

// Members that axiscert writes on a line beside the query: in witnesses, in the output of `check`, `shrink` and
// `search`, in the corpus.
constexpr std::string_view written_beside_queries[] = {
    "kernel", "family",      "address",       "truth",      "computed", "touching", "depth", "exact_comparisons",
    "shows",  "flips",       "sides",         "provenance", "note",     "expected", "exact", "computed_comparisons",
    "errors", "findings",    "within_limits", "severity",   "bits",     "nonzero",  "kept",  "before",
    "steps",  "evaluations", "complete"};
bool is_written_beside_queries(std::string_view field) {
  return std::find(std::begin(written_beside_queries), std::end(written_beside_queries), field) !=
         std::end(written_beside_queries);
}

class LineHandler : public nlohmann::json_sax<nlohmann::json> {
 public:
  LineHandler(std::string_view line, const Place& place, KnownTests known)
      : line_(line), place_(place), known_(known) {}

  StoredQuery parse() {
    const CountingIterator begin{line_.data(), &consumed_}, end{line_.data() + line_.size(), nullptr};
    nlohmann::json::sax_parse(begin, end, this);
    const EntryOfTest of = entry_given_once();
    const Precision precision = precision_of_line(of);
    const Value& id = field("id").value;
    if (id.kind != Kind::absent && id.kind != Kind::string) wrong_kind("id", id.kind, "a string");
    std::vector<NumberText> numbers;
    for (const ColumnGroup& group : groups_of(of.columns())) take_group(group, of, numbers);
    unread_ = unread_fields(of);
    StoredQuery stored =
        stored_query(id.kind == Kind::string ? id.text : place_.default_id(), precision, of, numbers, place_);
    if (const Value& address = field("address").value; address.kind == Kind::string) stored.address = address.text;
    return stored;
  }

  const std::vector<UnreadField>& unread() const { return unread_; }

  bool null() override { return scalar(Kind::null, {}); }
  bool boolean(bool) override { return scalar(Kind::boolean, {}); }
  bool number_integer(number_integer_t) override { return scalar(Kind::number, number_token()); }
  bool number_unsigned(number_unsigned_t) override { return scalar(Kind::number, number_token()); }
  bool number_float(number_float_t, const string_t&) override { return scalar(Kind::number, number_token()); }
  bool string(string_t& text) override { return scalar(Kind::string, text); }
  bool binary(binary_t&) override { return true; }  // JSON text has no binary values

  bool start_object(std::size_t) override {
    if (depth_ > 0) scalar(Kind::object, {});
    ++depth_;
    return true;
  }
  bool end_object() override {
    --depth_;
    return true;
  }
  bool start_array(std::size_t) override {
    scalar(Kind::array, {});
    ++depth_;
    return true;
  }
  bool end_array() override { return end_object(); }
  bool key(string_t& text) override {
    if (depth_ != 1) return true;
    key_ = text;
    // Which members matter is known when the test is, and that may be the last member.
    const auto [at, is_new] = fields_.try_emplace(text);
    if (!is_new) repeated_.push_back(text);
    current_ = &at->second;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& what) override {
    if (!repeated_.empty()) entry_given_once();
    constexpr int number_overflow = 406;
    if (what.id == number_overflow) {
      try {
        const std::string token(number_token());
        if (field("precision").value.text == axiscert::name(Precision::binary32)) parse_number<float>(token);
        else parse_number<double>(token);
      } catch (const Error& overflow) {
        place_.fail(key_, overflow.what());
      }
    }
    // "[json.exception.parse_error.101] parse error at line 1, column 17: WHAT": only WHAT is shown.
    std::string_view reason = what.what();
    if (const std::size_t column = reason.find("column "); column != reason.npos) {
      const std::size_t colon = reason.find(": ", column);
      if (colon != reason.npos) reason.remove_prefix(colon + 2);
    }
    std::string line(reason.substr(0, 300));
    if (depth_ == 0) line += outside_object();
    else if (trimmed_end() <= position) line += "; a query is one whole line";
    place_.fail(key_, fmt::format("malformed JSON at column {}: {}", position, line));
  }

 private:
  std::string outside_object() const {
    return fmt::format("; a line is one JSON object, or the file is CSV under the header [id,]{}", csv_columns(known_));
  }

  // The length of the line without white space at its end.
  std::size_t trimmed_end() const { return line_.find_last_not_of(" \t") + 1; }

  // The names of the members that a query of this entry has.
  std::vector<std::string_view> member_names(const EntryOfTest& of) const {
    std::vector<std::string_view> names = {"id", "precision", "test", "entry"};
    for (const ColumnGroup& group : groups_of(of.columns())) names.push_back(group.name);
    return names;
  }

  // "; it has what is not read: 'radius' (did you mean 'r'?)", for a line that lacks a member.
  std::string unknown_fields(const EntryOfTest& of) const {
    std::vector<std::string> texts;
    for (const UnreadField& field : unread_fields(of)) {
      if (texts.size() == 4) break;
      texts.push_back(fmt::format("'{}'{}", shown(field.name),
                                  field.meant.empty() ? "" : fmt::format(" (did you mean '{}'?)", field.meant)));
    }
    return texts.empty() ? "" : fmt::format("; it has what is not read: {}", fmt::join(texts, ", "));
  }

  std::vector<UnreadField> unread_fields(const EntryOfTest& of) const {
    const std::vector<std::string_view> names = member_names(of);
    std::vector<UnreadField> unread;
    for (const auto& [given, ignored] : fields_) {
      if (std::find(names.begin(), names.end(), given) != names.end() || is_written_beside_queries(given)) continue;
      unread.push_back({given, std::string(meant_member(given, names))});
    }
    return unread;
  }

  // A member whose name is near, one that is absent before others.
  std::string_view meant_member(std::string_view given, const std::vector<std::string_view>& names) const {
    std::vector<std::string_view> absent;
    for (const std::string_view name : names) {
      if (!fields_.contains(name)) absent.push_back(name);
    }
    // The names of these members in other programs.
    for (const auto& [other, member] : {std::pair<std::string_view, std::string_view>{"radius", "r"},
                                        {"center", "p"},
                                        {"centre", "p"},
                                        {"name", "id"}}) {
      const auto found = std::find(absent.begin(), absent.end(), member);
      if (given == other && found != absent.end()) return *found;
    }
    const std::string_view name = meant(given, absent);
    return name.empty() ? meant(given, names) : name;
  }

  // The lexer has read one character beyond a number, unless the line ended.
  std::string_view number_token() const {
    const auto belongs = [](char c) { return std::string_view("0123456789+-.eE").find(c) != std::string_view::npos; };
    std::size_t end = consumed_;
    if (end > 0 && !belongs(line_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && belongs(line_[begin - 1])) --begin;
    return line_.substr(begin, end - begin);
  }

  bool scalar(Kind kind, std::string_view text) {
    if (depth_ == 0) place_.fail("", fmt::format("{}{}", name(kind), outside_object()));
    if (current_ == nullptr) return true;
    Value value{kind, std::string(text)};
    if (depth_ == 1) *current_ = {std::move(value), {}};
    else if (depth_ == 2 && current_->value.kind == Kind::array) current_->elements.push_back(std::move(value));
    return true;
  }

  // A field without a value if it was not given.
  const Field& field(std::string_view name) const {
    static const Field absent;
    const auto found = fields_.find(name);
    return found == fields_.end() ? absent : found->second;
  }

  // `of` is the line's, where a member of it may be missing.
  [[noreturn]] void wrong_kind(std::string_view blamed, Kind given, std::string_view expected,
                               const EntryOfTest* of = nullptr) const {
    place_.fail(blamed, fmt::format("{}; {} belongs here{}", name(given), expected,
                                    given == Kind::absent && of != nullptr ? unknown_fields(*of) : ""));
  }

  // The test and the entry of the line. Fails if a member that matters to these was given twice.
  EntryOfTest entry_given_once() const {
    const auto fail_if_repeated = [&](const auto& matters) {
      const auto twice = std::find_if(repeated_.begin(), repeated_.end(), matters);
      if (twice != repeated_.end()) place_.fail(*twice, "given twice");
    };
    fail_if_repeated([](const std::string& name) { return name == "test" || name == "entry"; });
    const EntryOfTest of = entry_of_line();
    const std::vector<ColumnGroup> groups = groups_of(of.columns());
    fail_if_repeated([&](const std::string& name) {
      return name == "id" || name == "precision" ||
             std::any_of(groups.begin(), groups.end(), [&](const ColumnGroup& group) { return group.name == name; });
    });
    return of;
  }

  EntryOfTest entry_of_line() const {
    const Value &test = field("test").value, &entry = field("entry").value;
    if (test.kind != Kind::absent && test.kind != Kind::string) wrong_kind("test", test.kind, "the id of a test");
    if (entry.kind != Kind::absent && entry.kind != Kind::string) wrong_kind("entry", entry.kind, "an entry's name");
    EntryOfTest of{known_.front(), 0};
    try {
      if (test.kind == Kind::string) of.test = &find_test(shown(test.text), known_);
    } catch (const Error& unknown) {
      place_.fail("test", unknown.what());
    }
    try {
      of.entry = find_entry(*of.test, shown(entry.text));
    } catch (const Error& unknown) {
      place_.fail("entry", unknown.what());
    }
    return of;
  }

  Precision precision_of_line(const EntryOfTest& of) const {
    const Value& given = field("precision").value;
    if (given.kind != Kind::string) wrong_kind("precision", given.kind, "\"binary32\" or \"binary64\"", &of);
    try {
      return parse_precision(shown(given.text));
    } catch (const Error& unknown) {
      place_.fail("precision", unknown.what());
    }
  }

  std::string number_text(std::string_view blamed, std::string_view element, const Value& value,
                          const EntryOfTest& of) const {
    if (value.kind != Kind::number && value.kind != Kind::string) {
      place_.fail(blamed, fmt::format("{}{}; a number belongs here{}", element, name(value.kind),
                                      value.kind == Kind::absent ? unknown_fields(of) : ""));
    }
    return value.text;
  }

  void take_group(const ColumnGroup& group, const EntryOfTest& of, std::vector<NumberText>& numbers) const {
    const Field& given = field(group.name);
    if (group.size == 1) {
      numbers.push_back({std::string(group.name), "", number_text(group.name, "", given.value, of)});
      return;
    }
    const std::string due = fmt::format("an array of {} numbers", in_words(group.size));
    if (given.value.kind != Kind::array) wrong_kind(group.name, given.value.kind, due, &of);
    if (given.elements.size() != group.size) {
      place_.fail(group.name, fmt::format("an array of {}; {} belongs here", given.elements.size(), due));
    }
    for (std::size_t i = 0; i < group.size; ++i) {
      const std::string element = fmt::format("element {}: ", i + 1);
      numbers.push_back({std::string(group.name), element, number_text(group.name, element, given.elements[i], of)});
    }
  }

  std::string_view line_;
  const Place& place_;
  std::size_t consumed_ = 0;
  std::size_t depth_ = 0;
  std::string key_;           // the last key read in the outermost object
  Field* current_ = nullptr;  // the field of key_
  std::map<std::string, Field, std::less<>> fields_;
  std::vector<std::string> repeated_;  // names that were given again, in their order
  std::vector<UnreadField> unread_;
  KnownTests known_;
};

// A whole group's text as a member of the object.
template <class Real>
std::string group_text(const ColumnGroup& group, const Numbers<Real>& numbers) {
  std::string text;
  for (std::size_t k = group.first; k < group.first + group.size; ++k) {
    text += fmt::format("{}\"{}\"", text.empty() ? "" : ",", format_number(numbers[k]));
  }
  return group.size == 1 ? fmt::format(R"("{}":{})", group.name, text) : fmt::format(R"("{}":[{}])", group.name, text);
}

template <class Real>
std::string json_numbers(const TestEntry& entry, const Numbers<Real>& numbers) {
  std::string text;
  for (const ColumnGroup& group : groups_of(entry)) text += "," + group_text(group, numbers);
  return text;
}

}  // namespace

StoredQuery query_of_json(std::string_view line, const Place& place, KnownTests known,
                          std::vector<UnreadField>* unread) {
  LineHandler handler(line, place, known);
  StoredQuery stored = handler.parse();
  if (unread != nullptr) unread->insert(unread->end(), handler.unread().begin(), handler.unread().end());
  return stored;
}

std::string query_line(const StoredQuery& stored) {
  // An id from a CSV file may not be UTF-8.
  const std::string id = nlohmann::json(stored.id).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string of;
  if (stored.test != &first_test()) of += fmt::format(R"(,"test":"{}")", stored.test->id);
  if (stored.entry != 0) of += fmt::format(R"(,"entry":"{}")", stored.columns().name);
  return fmt::format(
      R"({{"id":{},"precision":"{}"{}{}}})", id, name(stored.precision), of,
      std::visit([&](const auto& numbers) { return json_numbers(stored.columns(), numbers); }, stored.numbers));
}

}  // namespace axiscert
