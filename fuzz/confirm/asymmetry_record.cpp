#include "fuzz/confirm/asymmetry_record.h"

namespace axiscert {
namespace {

std::optional<AddressPair> addresses_of(const std::optional<ImagePair>& pair, const AddressOf& address) {
  if (!pair) return std::nullopt;
  return AddressPair{address(pair->base), address(pair->image)};
}

AbsoluteSizeRecord size_record(const std::vector<UnitFlip>& flips, const std::vector<AbsoluteSize>& sizes) {
  AbsoluteSizeRecord record{flips.size(), {}};
  for (const AbsoluteSize& size : sizes)
    record.compared.push_back({size.quantity.text, size.quantity.degree, size.least, size.greatest, size.explains});
  return record;
}

}  // namespace

AsymmetryRecord asymmetry_record(const Asymmetry& asymmetry, const AddressOf& address) {
  return {asymmetry.images, asymmetry.verdicts, asymmetry.comparisons, addresses_of(asymmetry.first_verdict, address),
          addresses_of(asymmetry.first_comparison, address)};
}

std::map<ImageKind, ImageChangesRecord> invariance_record(
    const Invariance& invariance, const ImageGroup& group, Precision precision, const AddressOf& address,
    const std::function<std::vector<AbsoluteSize>(std::span<const UnitFlip>)>& sizes) {
  std::map<ImageKind, ImageChangesRecord> record;
  for (std::size_t i = 1; i < group.size; ++i) {
    const ImageKind kind = group.kind(i);
    const ImageChanges& changes = invariance.kinds[kind];
    record[kind] = {
        changes.images, changes.changed, changes.undecided, changes.by_size, addresses_of(changes.first, address),
        std::nullopt,   std::nullopt};
  }
  const auto scale = record.find(ImageKind::scale);
  if (scale == record.end()) return record;
  scale->second.range.emplace();
  if (group.range == nullptr) return record;
  const PowerRange range = group.range(precision);
  const UnitFaults& units = invariance.units;
  scale->second.range.emplace(PowerRangeRecord{range.least, range.greatest});
  scale->second.wrong = {units.wrong.changed, units.wrong.by_size, addresses_of(units.wrong.first, address),
                         size_record(units.small, sizes(units.small)), size_record(units.large, sizes(units.large))};
  return record;
}

}  // namespace axiscert
