// Values by name, in the order in which they were put.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axiscert {

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

}  // namespace axiscert
