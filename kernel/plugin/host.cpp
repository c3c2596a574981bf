// axiscert-plugin-host PATH COLUMNS COMPARISONS MEASURES: loads a plug-in and calls it as asked, in a process that it
// may ruin. Started by axiscert with a socket and a memory file of that shape (shared_memory.h); of no use by hand.
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
#include <cstdlib>

#include "kernel/base/address_sanitizer.h"
#include "kernel/plugin/floating_state.h"
#include "kernel/plugin/offered.h"

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

Control& map_memory(const Shape& shape, Arrays& arrays) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t area = area_size(page), slot = area + guard;
  auto* const control = map(nullptr, area_in_file(0, page), PROT_READ | PROT_WRITE, MAP_SHARED, memory_fd, 0);
  auto* const reserved = static_cast<std::byte*>(
      map(nullptr, shape.arrays() * slot + guard, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
  arrays = {shape, reserved, area, {}};
  for (std::size_t k = 0; k < shape.arrays(); ++k) {
    const int protection = k < shape.columns ? PROT_READ : PROT_READ | PROT_WRITE;
    map(arrays.area(k), area, protection, MAP_SHARED | MAP_FIXED, memory_fd, area_in_file(k, page));
  }
  return *static_cast<Control*>(control);
}

void set_error(Control& control, const char* text) {
  std::snprintf(control.load_error, sizeof control.load_error, "%s", text);
}

void load(const char* path, Control& control, Offered (&kernels)[most_kernels]) {
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    set_error(control, dlerror());
    return;
  }
  using Entry = decltype(&axiscert_plugin);
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "axiscert_plugin"));
  if (entry == nullptr) {
    set_error(control, "it exports no function axiscert_plugin");
    return;
  }
  for (std::uint32_t i = 0; i <= most_kernels; ++i) {
    const axiscert_kernel* const kernel = entry(i);
    if (kernel == nullptr) return;
    control.kernel_count = i + 1;
    if (i == most_kernels) return;
    kernels[i] = offered(kernel);
    describe(kernels[i], control.kernels[i]);
  }
}

bool receive(Request& request) {
  ssize_t got;
  do got = read(socket_fd, &request, sizeof request);
  while (got < 0 && errno == EINTR);
  return got == sizeof request;
}

bool send(const Reply& reply) { return write(socket_fd, &reply, sizeof reply) == sizeof reply; }

Reply answer(const Offered& kernel, const Request& request, Arrays& arrays) {
  arrays.placed = {request.placement, request.size, {kernel.says.precision / 8, bits_bytes(kernel.abi)}};
  const Call call(kernel, request, arrays);
  std::fesetenv(FE_DFL_ENV);
  const FloatingState before = floating_state();
  const auto start = std::chrono::steady_clock::now();
  call.run();
  const auto taken = std::chrono::steady_clock::now() - start;
  const FloatingState after = floating_state();
  std::fesetenv(FE_DFL_ENV);
  return {changes(before, after),
          static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(taken).count())};
}

int serve(const char* path, const Shape& shape) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_IGN);  // axiscert finishes what is under way
  const rlimit no_core{0, 0}, memory{memory_limit, memory_limit};
  setrlimit(RLIMIT_CORE, &no_core);
  if (limits_memory) setrlimit(RLIMIT_DATA, &memory);
  Arrays arrays;
  Control& control = map_memory(shape, arrays);
  watch_for_faults(arrays, control.fault);
  Offered kernels[most_kernels] = {};
  const FloatingState before = floating_state();
  load(path, control, kernels);
  control.changed = changes(before, floating_state());
  if (!send({})) return exit_gone;
  for (Request request; receive(request);) {
    if (request.kernel >= most_kernels || request.kernel >= control.kernel_count) return exit_broken;
    if (!send(answer(kernels[request.kernel], request, arrays))) return exit_gone;
  }
  return exit_gone;
}

}  // namespace
}  // namespace axiscert::plugin

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("axiscert-plugin-host is started by axiscert\n", stderr);
    return axiscert::plugin::exit_broken;
  }
  // Without the plug-in's exit handlers.
  const auto count = [&](int argument) { return std::strtoul(argv[argument], nullptr, 10); };
  _exit(axiscert::plugin::serve(argv[1], {.columns = count(2), .comparisons = count(3), .measures = count(4)}));
}
