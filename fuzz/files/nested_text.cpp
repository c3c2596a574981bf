#include "fuzz/files/nested_text.h"

#include <algorithm>

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

}  // namespace axiscert
