#include "fuzz/queries/source.h"

#include "fuzz/queries/image_groups.h"

namespace axiscert {
namespace {

class FamilySource final : public ColumnSource<FamilySource> {
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
  const Predicate& predicate() const override { return family_.predicate(); }
  std::size_t entry() const override { return family_.entry; }
  template <class Real>
  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<Real>& out) const {
    family_.fill(seed, first, out);
  }

 private:
  const Family& family_;
};

}  // namespace

SourcePtr family_source(const Family& family) { return std::make_shared<FamilySource>(family); }

}  // namespace axiscert
