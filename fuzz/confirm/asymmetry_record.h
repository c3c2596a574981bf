// Asymmetries and invariance in the form in which the record lists them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/confirm/asymmetry.h"
#include "fuzz/queries/address.h"
#include "fuzz/text/json.h"

namespace axiscert {

Json asymmetry_json(const Asymmetry& asymmetry, const AddressOf& address);
// `sizes` estimates the numbers that explain flips (absolute_sizes).
Json invariance_json(const Invariance& invariance, const ImageGroup& group, Precision precision,
                     const AddressOf& address,
                     const std::function<std::vector<AbsoluteSize>(std::span<const UnitFlip>)>& sizes);

}  // namespace axiscert
