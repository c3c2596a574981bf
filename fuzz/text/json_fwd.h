// Json, declared: enough for what takes, returns or names it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace axiscert {
using Json = nlohmann::ordered_json;  // members keep their order
}  // namespace axiscert
