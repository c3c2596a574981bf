// One call to a plug-in: its inputs placed between the guard pages, its outputs read back and their surroundings
// checked.
#pragma once

#include <span>
#include <string>

#include "kernel/kernel.h"
#include "kernel/plugin/host_process.h"

namespace axiscert::plugin {

// What a call wrote, as it stands: a verdict is any byte.
template <class Real>
struct Outputs {
  std::vector<std::uint8_t> verdicts;
  Answers<Real> answers;  // the bits and sides that were asked for; the others empty
};

// Where and how a call is made.
struct Arrangement {
  Placement placement = {};
  Exposure asked = Exposure::verdict;
  std::uint8_t filling = 0xa5;  // what the outputs hold before: an entry that still holds it was not written
};

template <class Real>
class Caller {
 public:
  // Nothing is started before the first call, which, like the first after a stop, may take `first_seconds`.
  Caller(const std::string& path, std::uint32_t kernel, double first_seconds)
      : path_(path), kernel_(kernel), first_seconds_(first_seconds) {}

  struct Result {
    std::optional<Stop> stop;   // then nothing else holds
    std::optional<Stop> stray;  // it wrote beside an output, where no guard page was
    Reply reply = {};
  };
  // Queries `first` to `first + size` of the batch, at most batch_capacity.
  Result call(const QueryColumns<Real>& batch, std::size_t first, std::size_t size, const Arrangement& arrangement,
              double seconds, Outputs<Real>& out);

 private:
  std::span<std::byte> array(std::size_t which, std::size_t size, Placement placement) const;
  template <class Visit>
  void for_each_output(Exposure asked, const Visit& visit) const;

  std::string path_;
  std::uint32_t kernel_;
  double first_seconds_;
  std::optional<HostProcess> process_;
};

}  // namespace axiscert::plugin
