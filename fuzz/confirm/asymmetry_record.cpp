#include "fuzz/confirm/asymmetry_record.h"

namespace axiscert {
namespace {

Json pair_json(const std::optional<ImagePair>& pair, const AddressOf& address) {
  if (!pair) return nullptr;
  return {{"base", address(pair->base)}, {"image", address(pair->image)}};
}

Json by_size_json(const ImageChanges& changes) {
  Json json = Json::object();
  for (const auto& [size, count] : changes.by_size) json[std::to_string(size)] = count;
  return json;
}

Json changes_json(const ImageChanges& changes, const AddressOf& address) {
  return {{"images", changes.images},
          {"changed", changes.changed},
          {"undecided", changes.undecided},
          {"by_size", by_size_json(changes)},
          {"first", pair_json(changes.first, address)}};
}

Json sizes_json(const std::vector<UnitFlip>& flips, const std::vector<AbsoluteSize>& sizes) {
  Json json = {{"bases", flips.size()}, {"compared", Json::array()}};
  for (const AbsoluteSize& size : sizes) {
    json["compared"].push_back({{"quantity", size.quantity.text},
                                {"degree", size.quantity.degree},
                                {"least", size.least},
                                {"greatest", size.greatest},
                                {"explains", size.explains}});
  }
  return json;
}

}  // namespace

Json asymmetry_json(const Asymmetry& asymmetry, const AddressOf& address) {
  return {{"images", asymmetry.images},
          {"verdicts", asymmetry.verdicts},
          {"comparisons", asymmetry.comparisons},
          {"first_verdict", pair_json(asymmetry.first_verdict, address)},
          {"first_comparison", pair_json(asymmetry.first_comparison, address)}};
}

Json invariance_json(const Invariance& invariance, const ImageGroup& group, Precision precision,
                     const AddressOf& address,
                     const std::function<std::vector<AbsoluteSize>(std::span<const UnitFlip>)>& sizes) {
  Json json = Json::object();
  EnumArray<ImageKind, bool> is_made{};
  for (std::size_t i = 1; i < group.size; ++i) is_made[group.kind(i)] = true;
  for (const ImageKind kind : enumerators<ImageKind>) {
    if (is_made[kind]) json[std::string(image_kind_names[kind])] = changes_json(invariance.kinds[kind], address);
  }
  if (!is_made[ImageKind::scale]) return json;
  Json& scale = json[std::string(image_kind_names[ImageKind::scale])];
  if (group.range == nullptr) {
    scale["range"] = nullptr;
    return json;
  }
  const PowerRange range = group.range(precision);
  const UnitFaults& units = invariance.units;
  scale["range"] = {{"least", range.least}, {"greatest", range.greatest}};
  scale["wrong"] = {{"count", units.wrong.changed},
                    {"by_size", by_size_json(units.wrong)},
                    {"first", pair_json(units.wrong.first, address)},
                    {"where_small", sizes_json(units.small, sizes(units.small))},
                    {"where_large", sizes_json(units.large, sizes(units.large))}};
  return json;
}

}  // namespace axiscert
