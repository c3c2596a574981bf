// The processes of a run that `mpirun` or Slurm started together: messages between rank 0 and the others, and nothing
// else.
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

  // Leaves the others; all ranks come to this.
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual void send(int to, std::string_view bytes) = 0;
  // One that has arrived, if any: does not wait. Of one sender in the order they were sent.
  virtual std::optional<Message> receive() = 0;
  // Ends all ranks at once, with this exit code.
  virtual void abort(int exit_code) = 0;
};

// Null where this process was started alone. Throws Error where it was not, and this build has no MPI (ranks_mpi.cpp,
// ranks_none.cpp: one of them is linked).
std::unique_ptr<Ranks> join_ranks();

// How many processes a launcher said that it started: Open MPI's, one that speaks PMI, or Slurm's. 0: none did.
int launched_ranks();

}  // namespace axiscert
