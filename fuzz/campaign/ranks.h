// The processes of a run that `mpirun` or Slurm started together: only messages between rank 0 and the others.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace axiscert {

class Ranks {
 public:
  struct Message {
    int from;
    std::string bytes;
  };

  // Leaves the group; all ranks have to reach this.
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual void send(int to, std::string_view bytes) = 0;
  // A message that has arrived, if any: does not wait. Messages of one sender arrive in the order in which they were
  // sent.
  virtual std::optional<Message> receive() = 0;
  // Ends all ranks at once, with this exit code.
  virtual void abort(int exit_code) = 0;
};

// Null if this process was started alone. Throws Error if it was started with others but this build has no MPI
// (ranks_mpi.cpp, ranks_none.cpp: one of them is linked).
std::unique_ptr<Ranks> join_ranks();

// The number of processes that a launcher says it started: Open MPI's, one that speaks PMI, or Slurm's. 0: no launcher.
int launched_ranks();

}  // namespace axiscert
