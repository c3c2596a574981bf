#include "kernel/plugin/host/child_process.h"

#include <dirent.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

namespace axiscert::plugin {
namespace {

constexpr std::size_t kept_errors = std::size_t{1} << 14;  // bytes; a stack trace begins with what it is about

}  // namespace

void ErrorOutput::add(std::span<const char> bytes) {
  if (bytes.size() > kept_errors) bytes = bytes.last(kept_errors);
  kept_.append(bytes.data(), bytes.size());
  if (kept_.size() > 2 * kept_errors) kept_.erase(0, kept_.size() - kept_errors);
}

std::string ErrorOutput::last_line() const {
  const auto says_something = [](std::string_view line) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    return !line.empty() && line.front() != ' ' && line.front() != '\t' && line.find_first_of(letters) != line.npos &&
           !line.starts_with("Node.js v");
  };
  std::string_view rest = kept_;
  while (!rest.empty()) {
    const std::size_t end = rest.rfind('\n');
    const std::string_view line = end == rest.npos ? rest : rest.substr(end + 1);
    constexpr std::size_t longest = 300;
    if (says_something(line)) return std::string(line.substr(0, longest));
    rest = end == rest.npos ? std::string_view() : rest.substr(0, end);
  }
  return "";
}

namespace {

struct Process {
  pid_t pid, parent;
  double ticks;  // its own, and those of the children that it has waited for
};

// The process of /proc/PID/stat. Its name there, in parentheses, may hold anything.
std::optional<Process> read_process(const char* name) {
  char path[64], text[1024];
  std::snprintf(path, sizeof path, "/proc/%.20s/stat", name);
  std::FILE* const file = std::fopen(path, "re");
  if (file == nullptr) return std::nullopt;
  const std::size_t size = std::fread(text, 1, sizeof text - 1, file);
  std::fclose(file);
  text[size] = 0;
  const char* const rest = std::strrchr(text, ')');
  int parent = 0;
  unsigned long user = 0, system = 0;
  long waited_user = 0, waited_system = 0;
  if (rest == nullptr || std::sscanf(rest + 1, " %*c %d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu %ld %ld", &parent,
                                     &user, &system, &waited_user, &waited_system) != 5) {
    return std::nullopt;
  }
  return Process{static_cast<pid_t>(std::atoi(name)), parent,
                 static_cast<double>(user + system) + static_cast<double>(waited_user + waited_system)};
}

std::vector<Process> descendants() {
  std::vector<Process> all, found;
  DIR* const folder = opendir("/proc");
  if (folder == nullptr) return found;
  while (const dirent* entry = readdir(folder)) {
    if (entry->d_name[0] < '1' || entry->d_name[0] > '9') continue;
    if (const auto process = read_process(entry->d_name)) all.push_back(*process);
  }
  closedir(folder);
  std::vector<pid_t> parents = {getpid()};
  for (std::size_t next = 0; next < parents.size(); ++next) {
    for (const Process& process : all) {
      if (process.parent != parents[next] || process.pid == getpid()) continue;
      found.push_back(process);
      parents.push_back(process.pid);
    }
  }
  return found;
}

}  // namespace

double tree_seconds() {
  static const auto ticks_a_second = static_cast<double>(sysconf(_SC_CLK_TCK));
  double ticks = 0;
  for (const Process& process : descendants()) ticks += process.ticks;
  rusage ended{};
  getrusage(RUSAGE_CHILDREN, &ended);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return ticks / ticks_a_second + seconds(ended.ru_utime) + seconds(ended.ru_stime);
}

std::optional<int> kill_tree(pid_t first) {
  std::optional<int> of_first;
  // At once all that are in its group, so that one that forks without end cannot get ahead.
  kill(-first, SIGKILL);
  kill(first, SIGKILL);
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(-1, &status, WNOHANG);
    if (ended == first) of_first = status;
    if (ended > 0 || (ended < 0 && errno == EINTR)) continue;
    if (ended < 0) return of_first;  // there are no children, hence no descendants
    for (const Process& process : descendants()) kill(process.pid, SIGKILL);
    usleep(1000);
  }
}

}  // namespace axiscert::plugin
