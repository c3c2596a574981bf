// The findings of `logic`, for the levels that require it too.
#pragma once

#include "reports/gates/levels/level.h"

namespace axiscert {

LevelFindings logic_findings(const Subject& subject);

}  // namespace axiscert
