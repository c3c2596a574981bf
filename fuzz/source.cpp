#include "fuzz/source.h"

namespace axiscert {
namespace {

class FamilySource final : public Source {
 public:
  explicit FamilySource(const Family& family) : family_(family) {}
  std::string name() const override { return std::string(family_.name); }
  std::string address_name() const override { return std::string(family_.name); }
  std::string purpose() const override { return std::string(family_.purpose); }
  int version() const override { return family_.version; }
  bool exact_arithmetic() const override { return family_.exact_arithmetic; }
  void make(std::uint64_t seed, std::uint64_t position, Query<float>& out) const override {
    out = family_.make<float>(seed, position);
  }
  void make(std::uint64_t seed, std::uint64_t position, Query<double>& out) const override {
    out = family_.make<double>(seed, position);
  }

 private:
  const Family& family_;
};

}  // namespace

SourcePtr family_source(const Family& family) { return std::make_shared<FamilySource>(family); }

}  // namespace axiscert
