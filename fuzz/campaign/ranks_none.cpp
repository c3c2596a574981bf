#include "fuzz/campaign/ranks.h"
#include "kernel/base/error.h"

namespace axiscert {

std::unique_ptr<Ranks> join_ranks() {
  if (launched_ranks() <= 1) return nullptr;
  throw Error(
      "started as a rank of an MPI job, but this axiscert was built without MPI: install libopenmpi-dev and build "
      "again, "
      "or give each job of an array its own --shard");
}

}  // namespace axiscert
