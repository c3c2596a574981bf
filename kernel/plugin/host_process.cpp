#include "kernel/plugin/host_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>

#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/plugin/pipe_format.h"

extern char** environ;

namespace axiscert::plugin {
namespace {

constexpr int patience_ms = 10;         // between two looks at a call that takes long
constexpr double farewell_seconds = 5;  // for the host of a program, which kills all that this has started

Error cannot(const std::string& path, const char* what) {
  return Error(fmt::format("plug-in {}: cannot {}: {}", path, what, std::strerror(errno)));
}

// Out of the way of the numbers that the host is to find its files under.
int out_of_the_way(int fd) {
  const int moved = fcntl(fd, F_DUPFD_CLOEXEC, 16);
  close(fd);
  return moved;
}

double processor_seconds(pid_t process) {
  clockid_t clock;
  std::timespec t{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &t) != 0) return 0;
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// The text about a fault at one of the arrays.
Stop out_of_bounds(const Fault& fault, const Subject& subject) {
  const auto count = static_cast<std::int64_t>(fault.element_count);
  const char* did = fault.access == Access::write ? "wrote" : fault.access == Access::read ? "read" : "touched";
  const std::int64_t last = std::max<std::int64_t>(count - 1, 0);
  const auto query = static_cast<std::size_t>(std::clamp<std::int64_t>(fault.element, 0, last));
  const bool is_inside = fault.element >= 0 && fault.element < count;
  return {FindingKind::out_of_bounds,
          is_inside ? fmt::format("{} to {}, which is read-only", did, subject.array_name(fault.array))
                    : fmt::format("{} {}[{}], which has {} {}", did, subject.array_name(fault.array), fault.element,
                                  count, count == 1 ? "entry" : "entries"),
          query};
}

}  // namespace

Shape Subject::shape() const {
  if (predicate == nullptr) return {};
  return {predicate->entries[entry].columns.size(), predicate->comparisons.size(), predicate->measures.size()};
}

std::string Subject::array_name(std::size_t array) const {
  const Shape shape = this->shape();
  if (array < shape.verdict()) return std::string(predicate->entries[entry].columns[array].name);
  if (array == shape.verdict()) return "verdict";
  if (array == shape.bits()) return "comparisons";
  if (array < shape.rhs()) return fmt::format("lhs[{}]", array - shape.lhs());
  if (array < shape.measure()) return fmt::format("rhs[{}]", array - shape.rhs());
  return fmt::format("measure[{}]", array - shape.measure());
}

HostProcess::HostProcess(HostedPlugin hosted, const Subject& subject)
    : hosted_(std::move(hosted)),
      subject_(subject),
      shape_(subject.shape()),
      page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
  memory_ = memfd_create("axiscert-plugin", MFD_CLOEXEC);
  if (memory_ >= 0) memory_ = out_of_the_way(memory_);
  const std::size_t size = file_size(shape_, page_);
  if (memory_ < 0 || ftruncate(memory_, static_cast<off_t>(size)) != 0) throw cannot(hosted_.path, "share memory");
  void* const mapped = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, memory_, 0);
  if (mapped == MAP_FAILED) throw cannot(hosted_.path, "share memory");
  mapped_ = static_cast<std::byte*>(mapped);
  control_ = reinterpret_cast<Control*>(mapped_);
}

HostProcess::~HostProcess() {
  end();
  if (mapped_ != nullptr) munmap(mapped_, file_size(shape_, page_));
  if (memory_ >= 0) close(memory_);
}

std::byte* HostProcess::area(std::size_t array) const { return mapped_ + area_in_file(array, page_); }

void HostProcess::end() {
  if (socket_ >= 0) close(socket_);
  socket_ = -1;
  if (child_ < 0) return;
  for (int look = 0; hosted_.is_program() && look * 1e-3 < farewell_seconds; ++look) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid != 0) break;
    usleep(1000);
  }
  kill(-child_, SIGKILL);  // and what it has started, which is in its process group
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
}

void HostProcess::spawn() {
  std::memset(static_cast<void*>(control_), 0, sizeof(Control));
  write_headers();
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) throw cannot(hosted_.path, "make a socket");
  socket_ = ends[0];
  const int host_end = out_of_the_way(ends[1]);
  if (host_end < 0) throw cannot(hosted_.path, "make a socket");
  const timeval patience{0, patience_ms * 1000};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, output, "/dev/null", O_WRONLY, 0);
  }
  posix_spawn_file_actions_adddup2(&files, host_end, socket_fd);
  posix_spawn_file_actions_adddup2(&files, memory_, memory_fd);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  const std::string program = host_program();
  std::vector<std::string> words = {program, hosted_.path, std::to_string(shape_.columns),
                                    std::to_string(shape_.comparisons), std::to_string(shape_.measures)};
  words.insert(words.end(), hosted_.command.begin(), hosted_.command.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int failed = posix_spawn(&child_, program.c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  close(host_end);
  if (failed == 0) return;
  child_ = -1;
  errno = failed;
  throw cannot(hosted_.path, "start axiscert-plugin-host");
}

std::optional<Stop> HostProcess::start(double seconds) {
  if (child_ >= 0) return std::nullopt;
  spawn();
  Reply loaded;
  return receive(seconds, loaded);
}

std::optional<Stop> HostProcess::call(const Request& request, double seconds, Reply& reply) {
  // Loading is what it did before without trouble; where it does not now, that is a stop like another.
  constexpr double loading_seconds = 10;
  if (auto stop = start(loading_seconds)) return stop;
  if (hosted_.is_program()) return call_program(request, reply);
  if (send(socket_, &request, sizeof request, MSG_NOSIGNAL) != sizeof request) return how_it_died();
  return receive(seconds, reply);
}

std::optional<Stop> HostProcess::call_program(const Request& request, Reply& reply) {
  if (send(socket_, &request, sizeof request, MSG_NOSIGNAL) != sizeof request) return how_it_died();
  // The host itself looks at the time; this is for a host that is stopped, or a process that cannot be killed.
  constexpr double reserve_seconds = 60;
  if (auto stop = receive(request.seconds + request.start_seconds + reserve_seconds, reply)) return stop;
  if (!reply.stopped) return std::nullopt;
  const ProgramStop& why = control_->stop;
  return Stop{static_cast<FindingKind>(why.kind), printable_line(why.detail), why.replies};
}

void HostProcess::write_headers() {
  if (!hosted_.is_program() || subject_.predicate == nullptr) return;
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const std::string bytes = program_header(*subject_.predicate, subject_.entry, precision, subject_.measures);
    ProgramHeader& header = control_->headers[index_of(precision)];
    header.measures = static_cast<std::uint32_t>(subject_.measures);
    if (bytes.size() > sizeof header.bytes) throw HarnessFault("the header of a batch for a program is too long");
    header.size = static_cast<std::uint32_t>(bytes.size());
    std::memcpy(header.bytes, bytes.data(), bytes.size());
  }
}

std::optional<Stop> HostProcess::receive(double seconds, Reply& reply) {
  using Clock = std::chrono::steady_clock;
  std::optional<double> processor_start;
  Clock::time_point clock_start;
  for (;;) {
    const ssize_t got = recv(socket_, &reply, sizeof reply, 0);
    if (got == sizeof reply) return std::nullopt;
    if (got >= 0 || (errno != EAGAIN && errno != EINTR)) return how_it_died();
    // A process that the plug-in has started may hold the socket open after the plug-in has died.
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid != 0) {
      return how_it_died();
    }
    const double processor = processor_seconds(child_);
    if (!processor_start) {
      processor_start = processor;
      clock_start = Clock::now();
    }
    const double waited = std::chrono::duration<double>(Clock::now() - clock_start).count();
    if (processor - *processor_start < seconds && waited < clock_to_processor * seconds) continue;
    end();
    return Stop{FindingKind::hang, fmt::format("no answer within {} s", seconds), std::nullopt};
  }
}

Stop HostProcess::how_it_died() {
  // Its end of the socket is closed, so it is dying, unless the plug-in closed it.
  int status = 0;
  pid_t ended = 0;
  for (int look = 0; look < 200 && ended == 0; ++look) {
    ended = waitpid(child_, &status, WNOHANG);
    if (ended == 0) usleep(1000 * patience_ms);
  }
  if (ended == child_) {
    kill(-child_, SIGKILL);
    child_ = -1;
  }
  end();
  const Fault fault = control_->fault;
  if (ended <= 0) return {FindingKind::crash, "it closed the socket that it is asked through", std::nullopt};
  if (WIFEXITED(status)) {
    return {FindingKind::crash, fmt::format("it left the process with exit code {}", WEXITSTATUS(status)),
            std::nullopt};
  }
  const int signal = WTERMSIG(status);
  if (signal == fault.signal && fault.in_arrays) return out_of_bounds(fault, subject_);
  const char* const abbreviation = sigabbrev_np(signal);  // none for real-time signals
  std::string detail = abbreviation ? fmt::format("SIG{} ({})", abbreviation, strsignal(signal))
                                    : fmt::format("signal {} ({})", signal, strsignal(signal));
  // Nothing that a plug-in does to memory sends it.
  if (signal == SIGKILL) detail += ", which the system sends where memory runs out";
  if (signal == fault.signal && fault.at_null) detail += " at a null pointer";
  if (signal == fault.signal && fault.out_of_stack) detail += ", out of stack";
  return {FindingKind::crash, detail, std::nullopt};
}

std::string changed_modes_text(std::uint32_t changed) {
  std::string modes;
  const auto add = [&](std::uint32_t bit, const char* mode) {
    if (changed & bit) modes += (modes.empty() ? "" : ", ") + std::string(mode);
  };
  add(changed_rounding, "the rounding mode");
  add(changed_flushing, "flushing of subnormal numbers to zero");
  add(changed_traps, "which exceptions trap");
  add(changed_other, "another control bit");
  return modes;
}

std::string host_program() {
  const auto here = own_folder();
  for (const auto& program : {here / "axiscert-plugin-host", here / "../libexec/axiscert/axiscert-plugin-host"}) {
    if (access(program.c_str(), X_OK) == 0) return program.string();
  }
  throw Error(fmt::format("a plug-in needs the program axiscert-plugin-host beside {} or in ../libexec/axiscert",
                          (here / "axiscert").string()));
}

std::optional<std::string> shipped_folder(std::string_view name) {
  const auto here = own_folder();
  for (const auto& folder : {here / name, here / "../lib/axiscert" / name}) {
    if (std::filesystem::is_directory(folder)) return folder.string();
  }
  return std::nullopt;
}

}  // namespace axiscert::plugin
