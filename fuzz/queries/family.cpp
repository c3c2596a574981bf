#include "fuzz/queries/family.h"

#include <fmt/format.h>

#include <vector>

#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "kernel/predicate_list.h"

namespace axiscert {
#define AXISCERT_DECLARE(name) std::span<const Family* const> name##_families();
AXISCERT_PREDICATES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

std::span<const Family* const> families() {
  static const std::vector<const Family*> all = [] {
    std::vector<const Family*> families;
    const auto append = [&](std::span<const Family* const> more) {
      families.insert(families.end(), more.begin(), more.end());
    };
#define AXISCERT_APPEND(name) append(name##_families());
    AXISCERT_PREDICATES(AXISCERT_APPEND)
#undef AXISCERT_APPEND
    return families;
  }();
  return all;
}

std::vector<const Family*> families_of(const Predicate& predicate) {
  std::vector<const Family*> all = all_families_of(predicate);
  std::erase_if(all, [](const Family* family) { return family->is_by_name; });
  return all;
}

std::vector<const Family*> all_families_of(const Predicate& predicate) {
  std::vector<const Family*> all;
  for (const Family* family : families()) {
    if (&family->predicate() == &predicate) all.push_back(family);
  }
  return all;
}

std::vector<const Family*> families_of(const Predicate& predicate, std::size_t entry) {
  std::vector<const Family*> all = families_of(predicate);
  std::erase_if(all, [&](const Family* family) { return family->entry != entry; });
  return all;
}

const Family& find_family(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Family* family : families()) {
    if (family->name == name) return *family;
    known.push_back(family->name);
  }
  throw Error(unknown_name("family", "families", name, known, "axiscert families --predicate ID"));
}

namespace {

class FamilySource final : public Source {
 public:
  explicit FamilySource(const Family& family) : family_(family) {
    if (const ImageGroup* group = image_group(family.name)) group_size_ = group->size;
  }
  std::string name() const override { return std::string(family_.name); }
  std::string address_name() const override { return std::string(family_.name); }
  std::string purpose() const override { return std::string(family_.purpose); }
  int version() const override { return family_.version; }
  bool exact_arithmetic() const override { return family_.exact_arithmetic; }
  int trial_divisor() const override { return family_.trial_divisor; }
  std::uint64_t base_triangles(Precision, std::uint64_t trials) const override {
    return (trials + group_size_ - 1) / group_size_;
  }
  std::uint64_t cluster(Precision, std::uint64_t position) const override { return position / group_size_; }
  std::size_t cluster_run() const override { return group_size_; }
  const Predicate& predicate() const override { return family_.predicate(); }
  std::size_t entry() const override { return family_.entry; }
  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<float>& out) const override {
    family_.fill(seed, first, out);
  }
  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<double>& out) const override {
    family_.fill(seed, first, out);
  }

 private:
  const Family& family_;
  std::size_t group_size_ = 1;  // of images
};

}  // namespace

SourcePtr family_source(const Family& family) { return std::make_shared<FamilySource>(family); }

#define AXISCERT_DECLARE(name)         \
  const Predicate& name##_predicate(); \
  const Capabilities& name##_capabilities();
AXISCERT_PREDICATES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

const Capabilities& capabilities_of(const Predicate& predicate) {
#define AXISCERT_FIND(name) \
  if (&predicate == &name##_predicate()) return name##_capabilities();
  AXISCERT_PREDICATES(AXISCERT_FIND)
#undef AXISCERT_FIND
  throw HarnessFault(fmt::format("the predicate '{}' is not on the list of kernel/predicate_list.h", predicate.id));
}

}  // namespace axiscert
