// JSON Lines by nlohmann's lexer and grammar, but with the characters of each number instead of the library's value,
// which has gone through double.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "fuzz/queries/address.h"
#include "fuzz/text/number_text.h"
#include "fuzz/files/query_line.h"
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
constexpr std::array<std::string_view, 7> kind_names = {"missing",  "null",     "a boolean", "a number",
                                                        "a string", "an array", "an object"};
std::string_view name(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

struct Value {
  Kind kind = Kind::absent;
  std::string text;  // for a number its characters, for a string its content
};
struct Field {
  std::string_view name;
  Value value;
  std::vector<Value> elements;  // elements of an array
};

class LineHandler : public nlohmann::json_sax<nlohmann::json> {
 public:
  LineHandler(std::string_view line, const Place& place) : line_(line), place_(place) {}

  StoredQuery parse() {
    const CountingIterator begin{line_.data(), &consumed_}, end{line_.data() + line_.size(), nullptr};
    nlohmann::json::sax_parse(begin, end, this);
    const Precision precision = precision_of_line();
    const Value& id = field("id").value;
    if (id.kind != Kind::absent && id.kind != Kind::string) wrong_kind("id", id.kind, "a string");
    std::array<NumberText, coordinate_count> numbers;
    for (std::size_t v = 0; v < 4; ++v) take_point(vectors[v], &numbers[3 * v]);
    numbers[12] = {"r", "", number_text("r", "", field("r").value)};
    return stored_query(id.kind == Kind::string ? id.text : place_.default_id(), precision, numbers, place_);
  }

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
    const auto known = std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) { return f.name == text; });
    current_ = known == fields_.end() ? nullptr : &*known;
    if (current_ != nullptr && current_->value.kind != Kind::absent) place_.fail(text, "given twice");
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& what) override {
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
    place_.fail(key_, fmt::format("malformed JSON at column {}: {}", position, line));
  }

 private:
  static constexpr std::array<std::string_view, 4> vectors = {"a", "b", "c", "p"};
  static std::string outside_object() {
    return fmt::format("; a line is one JSON object, or the file is CSV under the header [id,]{}", csv_columns);
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
    if (depth_ == 1) current_->value = std::move(value);
    else if (depth_ == 2 && current_->value.kind == Kind::array) current_->elements.push_back(std::move(value));
    return true;
  }

  Field& field(std::string_view name) {
    return *std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) { return f.name == name; });
  }

  [[noreturn]] void wrong_kind(std::string_view blamed, Kind given, std::string_view expected) const {
    place_.fail(blamed, fmt::format("{}; {} belongs here", name(given), expected));
  }

  Precision precision_of_line() {
    const Value& given = field("precision").value;
    if (given.kind != Kind::string) wrong_kind("precision", given.kind, "\"binary32\" or \"binary64\"");
    try {
      return parse_precision(shown(given.text));
    } catch (const Error& unknown) {
      place_.fail("precision", unknown.what());
    }
  }

  std::string number_text(std::string_view blamed, std::string_view element, const Value& value) const {
    if (value.kind != Kind::number && value.kind != Kind::string) {
      place_.fail(blamed, fmt::format("{}{}; a number belongs here", element, name(value.kind)));
    }
    return value.text;
  }

  void take_point(std::string_view which, NumberText* numbers) {
    const Field& given = field(which);
    if (given.value.kind != Kind::array) wrong_kind(which, given.value.kind, "an array of three numbers");
    if (given.elements.size() != 3) {
      place_.fail(which, fmt::format("an array of {}; an array of three numbers belongs here", given.elements.size()));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string element = fmt::format("element {}: ", i + 1);
      numbers[i] = {std::string(which), element, number_text(which, element, given.elements[i])};
    }
  }

  std::string_view line_;
  const Place& place_;
  std::size_t consumed_ = 0;
  std::size_t depth_ = 0;
  std::string key_;           // the last key read in the outermost object
  Field* current_ = nullptr;  // the field of key_, if it is one of:
  std::array<Field, 7> fields_ = {{{"id", {}, {}},
                                   {"precision", {}, {}},
                                   {"a", {}, {}},
                                   {"b", {}, {}},
                                   {"c", {}, {}},
                                   {"p", {}, {}},
                                   {"r", {}, {}}}};
};

template <class Real>
std::string json_numbers(const Query<Real>& q) {
  const auto v = coordinates(q);
  const auto point = [&](const char* which, std::size_t k) {
    return fmt::format(R"("{}":["{}","{}","{}"],)", which, format_number(v[k]), format_number(v[k + 1]),
                       format_number(v[k + 2]));
  };
  const std::string radius = fmt::format(R"("r":"{}")", format_number(v[12]));
  return point("a", 0) + point("b", 3) + point("c", 6) + point("p", 9) + radius;
}

}  // namespace

StoredQuery query_of_json(std::string_view line, const Place& place) { return LineHandler(line, place).parse(); }

std::string query_line(const StoredQuery& stored) {
  // An id from a CSV file may not be UTF-8.
  const std::string id = nlohmann::json(stored.id).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return fmt::format(R"({{"id":{},"precision":"{}",{}}})", id, name(stored.precision),
                     std::visit([](const auto& q) { return json_numbers(q); }, stored.query));
}

}  // namespace axiscert
