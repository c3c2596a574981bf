// JSON in the form in which reports read and write it: members keep their order.
#pragma once

#include <nlohmann/json.hpp>

namespace axiscert {

using Json = nlohmann::ordered_json;

}  // namespace axiscert
