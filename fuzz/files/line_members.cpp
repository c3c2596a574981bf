#include "fuzz/files/line_members.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "fuzz/text/number_text.h"
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

class MemberHandler : public nlohmann::json_sax<nlohmann::json> {
 public:
  MemberHandler(std::string_view line, const Place& place, KnownPredicates known,
                const std::function<void(const LineMembers&)>& before_a_fault)
      : line_(line), place_(place), known_(known), before_a_fault_(before_a_fault) {}

  LineMembers read() {
    const CountingIterator begin{line_.data(), &consumed_}, end{line_.data() + line_.size(), nullptr};
    nlohmann::json::sax_parse(begin, end, this);
    return std::move(found_);
  }

  bool null() override { return scalar(JsonKind::null, {}); }
  bool boolean(bool) override { return scalar(JsonKind::boolean, {}); }
  bool number_integer(number_integer_t) override { return scalar(JsonKind::number, number_token()); }
  bool number_unsigned(number_unsigned_t) override { return scalar(JsonKind::number, number_token()); }
  bool number_float(number_float_t, const string_t&) override { return scalar(JsonKind::number, number_token()); }
  bool string(string_t& text) override { return scalar(JsonKind::string, text); }
  bool binary(binary_t&) override { return true; }  // JSON text has no binary values

  bool start_object(std::size_t) override {
    if (depth_ > 0) scalar(JsonKind::object, {});
    enter(JsonKind::object);
    return true;
  }
  bool end_object() override {
    --depth_;
    if (containers_.size() > depth_) containers_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override {
    scalar(JsonKind::array, {});
    enter(JsonKind::array);
    return true;
  }
  bool end_array() override { return end_object(); }
  bool key(string_t& text) override {
    if (depth_ == 1) key_ = text;
    if (depth_ > most_depth) return true;
    const std::string& outer = containers_.back().path;
    const std::string path = outer.empty() ? text : outer + '.' + text;
    // Which members matter is known when the predicate is, and that may be the last member.
    const auto [at, is_new] = found_.members.try_emplace(path);
    if (!is_new) found_.repeated.push_back(path);
    given_ = &*at;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& what) override {
    before_a_fault_(found_);
    constexpr int number_overflow = 406;
    if (what.id == number_overflow) {
      try {
        const std::string token(number_token());
        if (found_.at("precision").value.text == axiscert::name(Precision::binary32)) parse_number<float>(token);
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

  // The lexer has read one character beyond a number, unless the line ended.
  std::string_view number_token() const {
    const auto belongs = [](char c) { return std::string_view("0123456789+-.eE").find(c) != std::string_view::npos; };
    std::size_t end = consumed_;
    if (end > 0 && !belongs(line_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && belongs(line_[begin - 1])) --begin;
    return line_.substr(begin, end - begin);
  }

  // Paths are kept so deep; what is deeper is passed over.
  static constexpr std::size_t most_depth = 4;

  // An object or an array whose end has not come; the outermost has the empty path.
  struct Container {
    JsonKind kind;
    std::string path;
    JsonMember* member;  // null: the outermost
  };

  // The value is the object or array that begins here.
  void enter(JsonKind kind) {
    ++depth_;
    if (depth_ > most_depth) return;
    if (depth_ == 1) containers_.push_back({kind, {}, nullptr});
    else containers_.push_back({kind, given_->first, &given_->second});
  }

  bool scalar(JsonKind kind, std::string_view text) {
    if (depth_ == 0) place_.fail("", fmt::format("{}{}", name(kind), outside_object()));
    if (depth_ > most_depth) return true;
    const Container& in = containers_.back();
    JsonValue value{kind, std::string(text)};
    if (in.kind == JsonKind::object) {
      given_->second = {std::move(value), {}};
      return true;
    }
    in.member->elements.push_back(value);
    if (kind != JsonKind::array && kind != JsonKind::object) return true;
    const std::string path = fmt::format("{}.{}", in.path, in.member->elements.size() - 1);
    given_ = &*found_.members.insert_or_assign(path, JsonMember{std::move(value), {}}).first;
    return true;
  }

  std::string_view line_;
  const Place& place_;
  KnownPredicates known_;
  const std::function<void(const LineMembers&)>& before_a_fault_;
  std::size_t consumed_ = 0;
  std::size_t depth_ = 0;
  std::string key_;  // the last key read in the outermost object
  std::vector<Container> containers_;
  std::pair<const std::string, JsonMember>* given_ = nullptr;  // the member of the last key, or a nested container
  LineMembers found_;
};

}  // namespace

const JsonMember& LineMembers::at(std::string_view name) const {
  static const JsonMember absent;
  const auto found = members.find(name);
  return found == members.end() ? absent : found->second;
}

LineMembers read_members(std::string_view line, const Place& place, KnownPredicates known,
                         const std::function<void(const LineMembers&)>& before_a_fault) {
  return MemberHandler(line, place, known, before_a_fault).read();
}

}  // namespace axiscert
