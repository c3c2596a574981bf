// axiscert-plugin-host PATH: loads a plug-in and calls it as asked, in a process that it may ruin. Started by axiscert
// with a socket and a memory file (shared_memory.h); of no use by hand.
#include <dlfcn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cfenv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "kernel/base/address_sanitizer.h"
#include "kernel/include/axiscert/plugin.h"
#include "kernel/plugin/fault_handler.h"
#include "kernel/plugin/floating_state.h"
#include "kernel/plugin/shared_memory.h"

namespace axiscert::plugin {
namespace {

constexpr int exit_gone = 0, exit_broken = 90;  // axiscert went away; what it handed over is unusable

// A sanitizer has reserved terabytes.
#ifdef AXISCERT_ADDRESS_SANITIZER
constexpr bool limits_memory = false;
#else
constexpr bool limits_memory = true;
#endif
constexpr rlim_t memory_limit = rlim_t{16} << 30;  // writable memory of its own, bytes

void* map(void* at, std::size_t size, int protection, int flags, int fd, std::size_t offset) {
  void* const mapped = mmap(at, size, protection, flags, fd, static_cast<off_t>(offset));
  if (mapped == MAP_FAILED) _exit(exit_broken);
  return mapped;
}

Control& map_memory(Arrays& arrays) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t area = area_size(page), slot = area + guard;
  auto* const control = map(nullptr, area_in_file(0, page), PROT_READ | PROT_WRITE, MAP_SHARED, memory_fd, 0);
  auto* const reserved = static_cast<std::byte*>(
      map(nullptr, array_count * slot + guard, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
  arrays = {reserved, area, {}};
  for (std::size_t k = 0; k < array_count; ++k) {
    const int protection = k < coordinate_count ? PROT_READ : PROT_READ | PROT_WRITE;
    map(arrays.area(k), area, protection, MAP_SHARED | MAP_FIXED, memory_fd, area_in_file(k, page));
  }
  return *static_cast<Control*>(control);
}

template <std::size_t size>
bool copy_text(char (&to)[size], const char* from) {
  std::snprintf(to, size, "%s", from ? from : "");
  return from == nullptr || std::strlen(from) < size;
}

void describe(const axiscert_kernel& kernel, Description& out) {
  out.abi = kernel.abi;
  if (kernel.abi != AXISCERT_PLUGIN_ABI) return;  // nothing else can be read
  out.precision = kernel.precision;
  out.exposes = kernel.exposes;
  out.touching = kernel.touching;
  const axiscert_limits& l = kernel.limits;
  const double limits[] = {l.least_coordinate, l.greatest_coordinate, l.least_area, l.least_radius, l.greatest_radius};
  std::memcpy(out.limits, limits, sizeof limits);
  out.has_run = kernel.run != nullptr;
  out.has_conforms_to = kernel.conforms_to != nullptr;
  out.has_formulae = kernel.formulae != nullptr;
  const bool fits[] = {copy_text(out.name, kernel.name), copy_text(out.summary, kernel.summary),
                       copy_text(out.conforms_to, kernel.conforms_to), copy_text(out.formulae, kernel.formulae)};
  for (const bool fit : fits) out.is_truncated |= !fit;
}

void load(const char* path, Control& control, const axiscert_kernel* (&kernels)[most_kernels]) {
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    copy_text(control.load_error, dlerror());
    return;
  }
  using Entry = decltype(&axiscert_plugin);
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "axiscert_plugin"));
  if (entry == nullptr) {
    copy_text(control.load_error, "it exports no function axiscert_plugin");
    return;
  }
  for (std::uint32_t i = 0; i <= most_kernels; ++i) {
    const axiscert_kernel* const kernel = entry(i);
    if (kernel == nullptr) return;
    control.kernel_count = i + 1;
    if (i == most_kernels) return;
    kernels[i] = kernel;
    describe(*kernel, control.kernels[i]);
  }
}

bool receive(Request& request) {
  ssize_t got;
  do got = read(socket_fd, &request, sizeof request);
  while (got < 0 && errno == EINTR);
  return got == sizeof request;
}

bool send(const Reply& reply) { return write(socket_fd, &reply, sizeof reply) == sizeof reply; }

Reply answer(const axiscert_kernel& kernel, const Request& request, Arrays& arrays) {
  const std::size_t real_size = kernel.precision / 8;
  arrays.placed = {request.placement, request.size, real_size};
  const auto at = [&](std::size_t array) -> void* { return arrays.first(array); };
  axiscert_batch batch{};
  batch.size = request.size;
  for (std::size_t k = 0; k < coordinate_count; ++k) batch.coordinate[k] = at(k);
  axiscert_answers answers{};
  answers.verdict = static_cast<std::uint8_t*>(at(verdict_array));
  if (request.exposes >= AXISCERT_COMPARISONS) {
    answers.comparisons = static_cast<std::uint16_t*>(at(comparisons_array));
  }
  if (request.exposes >= AXISCERT_SIDES) {
    for (std::size_t k = 0; k < comparison_count; ++k) {
      answers.lhs[k] = at(lhs_array + k);
      answers.rhs[k] = at(rhs_array + k);
    }
  }
  std::fesetenv(FE_DFL_ENV);
  const FloatingState before = floating_state();
  const auto start = std::chrono::steady_clock::now();
  kernel.run(&batch, &answers);
  const auto taken = std::chrono::steady_clock::now() - start;
  const FloatingState after = floating_state();
  std::fesetenv(FE_DFL_ENV);
  return {changes(before, after),
          static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(taken).count())};
}

int serve(const char* path) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // axiscert finishes what is under way
  const rlimit no_core{0, 0}, memory{memory_limit, memory_limit};
  setrlimit(RLIMIT_CORE, &no_core);
  if (limits_memory) setrlimit(RLIMIT_DATA, &memory);
  Arrays arrays;
  Control& control = map_memory(arrays);
  watch_for_faults(arrays, control.fault);
  const axiscert_kernel* kernels[most_kernels] = {};
  const FloatingState before = floating_state();
  load(path, control, kernels);
  control.changed = changes(before, floating_state());
  if (!send({})) return exit_gone;
  for (Request request; receive(request);) {
    if (request.kernel >= most_kernels || kernels[request.kernel] == nullptr) return exit_broken;
    if (!send(answer(*kernels[request.kernel], request, arrays))) return exit_gone;
  }
  return exit_gone;
}

}  // namespace
}  // namespace axiscert::plugin

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("axiscert-plugin-host is started by axiscert\n", stderr);
    return axiscert::plugin::exit_broken;
  }
  // Without the plug-in's exit handlers.
  _exit(axiscert::plugin::serve(argv[1]));
}
