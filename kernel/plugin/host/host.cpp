// axiscert-plugin-host PATH COLUMNS COMPARISONS MEASURES [COMMAND WORD...]: loads a plug-in and calls it as asked, in a
// process that it may ruin; with a command, starts that in the folder PATH and speaks to it. Started by axiscert with a
// socket and a memory file of that shape (shared_memory.h); of no use by hand.
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
#include <cstring>
#include <utility>
#include <vector>

#include "kernel/base/address_sanitizer.h"
#include "kernel/plugin/host/floating_state.h"
#include "kernel/plugin/host/offered.h"
#include "kernel/plugin/host/program.h"
#include "kernel/plugin/pipe_format.h"

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

void load(const char* path, Control& control, OfferedKernel (&kernels)[most_kernels]) {
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

std::uint64_t nanoseconds(std::chrono::steady_clock::duration taken) {
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(taken).count());
}

Reply answer(const OfferedKernel& kernel, const Request& request, Arrays& arrays) {
  arrays.placed = {request.placement, request.size, kernel.says.precision / 8};
  const Call call(kernel, request, arrays);
  std::fesetenv(FE_DFL_ENV);
  const FloatingState before = floating_state();
  const auto start = std::chrono::steady_clock::now();
  call.run();
  const auto taken = std::chrono::steady_clock::now() - start;
  const FloatingState after = floating_state();
  std::fesetenv(FE_DFL_ENV);
  return {changes(before, after), nanoseconds(taken), false};
}

void set_limits() {
  std::signal(SIGINT, SIG_IGN);  // axiscert finishes what is under way
  const rlimit no_core{0, 0}, memory{memory_limit, memory_limit};
  setrlimit(RLIMIT_CORE, &no_core);
  // The limit is on memory that can be written, and not on addresses: engines of JavaScript and WebAssembly reserve
  // terabytes of those.
  if (limits_memory) setrlimit(RLIMIT_DATA, &memory);
}

int serve(const char* path, const Shape& shape) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  set_limits();
  Arrays arrays;
  Control& control = map_memory(shape, arrays);
  watch_for_faults(arrays, control.fault);
  OfferedKernel kernels[most_kernels] = {};
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

// The header of a batch and its queries: the numbers of the columns, query by query.
std::vector<std::byte> stream_of(const ProgramHeader& header, const Request& request, const Arrays& arrays) {
  const std::size_t number = arrays.placed.real, record = number * arrays.shape.columns;
  std::vector<std::byte> stream(header.size + request.size * record);
  std::memcpy(stream.data(), header.bytes, header.size);
  const std::uint64_t count = request.size;
  std::memcpy(stream.data() + offsetof(pipe::Head, count), &count, sizeof count);
  for (std::size_t k = 0; k < arrays.shape.columns && count != 0; ++k) {
    const std::byte* const column = arrays.first(k);
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(stream.data() + header.size + i * record + k * number, column + i * number, number);
    }
  }
  return stream;
}

Reply answer(Program& program, const Request& request, Arrays& arrays, Control& control) {
  const ProgramHeader& header = control.headers[request.kernel];
  const bool wants_bits = request.exposes >= AXISCERT_COMPARISONS;
  arrays.placed = {request.placement, request.size, request.kernel == 0 ? sizeof(float) : sizeof(double)};
  const std::vector<std::byte> stream = stream_of(header, request, arrays);
  const auto whole = std::span(stream);
  const std::size_t number = arrays.placed.real;
  ReplyReader replies(whole.first(header.size), request.size, wants_bits, header.measures * number);
  const auto start = std::chrono::steady_clock::now();
  const auto stop = request.size == 0 ? program.try_out(whole, replies, request.start_seconds)
                                      : program.ask(whole, replies, {request.seconds, request.start_seconds});
  const auto taken = std::chrono::steady_clock::now() - start;
  if (stop) {
    control.stop.kind = static_cast<std::uint8_t>(stop->kind);
    control.stop.replies = static_cast<std::uint32_t>(replies.count());
    std::snprintf(control.stop.detail, sizeof control.stop.detail, "%s", stop->detail.c_str());
    return {0, nanoseconds(taken), true};
  }
  const Shape& shape = arrays.shape;
  if (request.size == 0) return {0, nanoseconds(taken), false};
  std::memcpy(arrays.first(shape.verdict()), replies.verdicts().data(), request.size);
  if (wants_bits) {
    std::memcpy(arrays.first(shape.bits()), replies.bits().data(), request.size * sizeof(std::uint64_t));
  }
  for (std::size_t k = 0; k < request.measures; ++k) {
    for (std::size_t i = 0; i < request.size; ++i) {
      std::memcpy(arrays.first(shape.measure() + k) + i * number,
                  replies.measures().data() + (i * header.measures + k) * number, number);
    }
  }
  return {0, nanoseconds(taken), false};
}

// The host of a program runs no code but its own, and outlives whoever asks it: it sees the socket close, and leaves no
// process behind.
int serve_program(const char* folder, std::vector<std::string> command, const Shape& shape) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // what the program starts and leaves becomes a child of this process
  set_limits();
  std::signal(SIGPIPE, SIG_IGN);
  Arrays arrays;
  Control& control = map_memory(shape, arrays);
  Program program(folder, std::move(command), socket_fd);
  if (!send({})) return exit_gone;
  for (Request request; receive(request);) {
    if (request.kernel >= most_kernels || control.headers[request.kernel].size == 0) return exit_broken;
    if (!send(answer(program, request, arrays, control))) break;
  }
  program.end();
  return exit_gone;
}

}  // namespace
}  // namespace axiscert::plugin

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fputs("axiscert-plugin-host is started by axiscert\n", stderr);
    return axiscert::plugin::exit_broken;
  }
  const auto count = [&](int argument) { return std::strtoul(argv[argument], nullptr, 10); };
  const axiscert::plugin::Shape shape{.columns = count(2), .comparisons = count(3), .measures = count(4)};
  // Without the plug-in's exit handlers.
  if (argc == 5) _exit(axiscert::plugin::serve(argv[1], shape));
  _exit(axiscert::plugin::serve_program(argv[1], {argv + 5, argv + argc}, shape));
}
