#include "fuzz/campaign/ranks.h"

#include <cstdlib>

namespace axiscert {

int launched_ranks() {
  for (const char* set_by_launcher : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
    if (const char* ranks = std::getenv(set_by_launcher)) return std::atoi(ranks);
  }
  return 0;
}

}  // namespace axiscert
