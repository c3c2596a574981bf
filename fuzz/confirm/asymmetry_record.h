// Asymmetries and invariance in the form in which the record lists them.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "fuzz/confirm/asymmetry.h"
#include "fuzz/queries/address.h"
#include "fuzz/record/family_record.h"

namespace axiscert {

AsymmetryRecord asymmetry_record(const Asymmetry& asymmetry, const AddressOf& address);
// `sizes` estimates the numbers that explain flips (absolute_sizes).
std::map<ImageKind, ImageChangesRecord> invariance_record(
    const Invariance& invariance, const ImageGroup& group, Precision precision, const AddressOf& address,
    const std::function<std::vector<AbsoluteSize>(std::span<const UnitFlip>)>& sizes);

}  // namespace axiscert
