#include "fuzz/queries/source.h"

#include "fuzz/queries/image_groups.h"

namespace axiscert {
namespace {

template <class Real>
void fill_one_by_one(const Source& source, std::uint64_t seed, std::uint64_t first, std::size_t count,
                     QueryBatch<Real>& out) {
  out.clear();
  for (std::size_t i = 0; i < count; ++i) {
    Query<Real> q;
    source.make(seed, first + i, q);
    out.push_back(q);
  }
}

class FamilySource final : public Source {
 public:
  explicit FamilySource(const Family& family) : family_(family) {}
  std::string name() const override { return std::string(family_.name); }
  std::string address_name() const override { return std::string(family_.name); }
  std::string purpose() const override { return std::string(family_.purpose); }
  int version() const override { return family_.version; }
  bool exact_arithmetic() const override { return family_.exact_arithmetic; }
  int trial_divisor() const override { return family_.trial_divisor; }
  std::uint64_t base_triangles(Precision, std::uint64_t trials) const override {
    const ImageGroup* group = image_group(family_.name);
    return group ? (trials + group->size - 1) / group->size : trials;
  }
  void make(std::uint64_t seed, std::uint64_t position, Query<float>& out) const override {
    out = family_.make<float>(seed, position);
  }
  void make(std::uint64_t seed, std::uint64_t position, Query<double>& out) const override {
    out = family_.make<double>(seed, position);
  }
  void fill(std::uint64_t seed, std::uint64_t first, std::size_t count, QueryBatch<float>& out) const override {
    out.resize(count);
    family_.fill(seed, first, out.mutable_columns());
  }
  void fill(std::uint64_t seed, std::uint64_t first, std::size_t count, QueryBatch<double>& out) const override {
    out.resize(count);
    family_.fill(seed, first, out.mutable_columns());
  }

 private:
  const Family& family_;
};

}  // namespace

void Source::fill(std::uint64_t seed, std::uint64_t first, std::size_t count, QueryBatch<float>& out) const {
  fill_one_by_one(*this, seed, first, count, out);
}
void Source::fill(std::uint64_t seed, std::uint64_t first, std::size_t count, QueryBatch<double>& out) const {
  fill_one_by_one(*this, seed, first, count, out);
}

SourcePtr family_source(const Family& family) { return std::make_shared<FamilySource>(family); }

}  // namespace axiscert
