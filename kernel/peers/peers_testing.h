// Shared parts of the tests of peers: asking one in its own process. Two builds of a library in different number types
// export the same symbols, some of them unique in a process; and some libraries never return from certain queries.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "kernel/include/axiscert/plugin.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::peer {

// The text that `body` returned, and how its process ended: 0, or the signal that ended it.
struct Reply {
  std::string bytes;
  int signal = 0;
};

// Runs body(plugin) with the plug-in's function axiscert_plugin, loaded from the folder peers/ of the build. A body
// that takes 2 s of processor time is ended by SIGXCPU.
using AxiscertPlugin = const axiscert_kernel*(std::uint32_t);
inline Reply in_peer(const std::string& name, const std::function<std::string(AxiscertPlugin*)>& body) {
  const std::string path = BUILD_FOLDER "/peers/" + name + ".so";
  int ends[2];
  if (::pipe(ends) != 0) return {"pipe failed", -1};
  const pid_t child = fork();
  if (child == 0) {
    const rlimit seconds{2, 3}, none{0, 0};
    setrlimit(RLIMIT_CPU, &seconds);
    setrlimit(RLIMIT_CORE, &none);
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      fprintf(stderr, "%s\n", dlerror());
      _exit(1);
    }
    const std::string bytes = body(reinterpret_cast<AxiscertPlugin*>(dlsym(library, "axiscert_plugin")));
    const bool is_written = write(ends[1], bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    _exit(is_written ? 0 : 1);
  }
  close(ends[1]);
  Reply reply;
  char buffer[4096];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    reply.bytes.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) reply.signal = WTERMSIG(status);
  else EXPECT_EQ(WEXITSTATUS(status), 0) << name << " (" << path << ")";
  return reply;
}

// A verdict as a letter: 'c'ontact, 's'eparated, 'u'ndecided, 'i'nvalid; 'U' where it is undecided and the kernel does
// not declare that it may decline.
inline char letter_of(const axiscert_kernel& kernel, std::uint8_t verdict) {
  if (verdict == AXISCERT_UNDECIDED && kernel.may_decline == 0) return 'U';
  return verdict < 4 ? "csui"[verdict] : '?';
}

// The measures that a peer gives of one query; none where it gives none, or has no kernel of that precision.
template <class Real>
std::vector<double> ask_numbers(const std::string& name, const Query<Real>& q) {
  const Reply reply = in_peer(name, [&](AxiscertPlugin* plugin) -> std::string {
    const axiscert_kernel* kernel = nullptr;
    for (std::uint32_t i = 0; (kernel = plugin(i)) != nullptr && kernel->precision != 8 * sizeof(Real);) ++i;
    if (kernel == nullptr) return "";
    const auto numbers = coordinates(q);
    std::array<const void*, coordinate_count> column;
    for (std::size_t k = 0; k < coordinate_count; ++k) column[k] = &numbers[k];
    std::vector<Real> given(kernel->measure_count);
    std::vector<void*> measures;
    for (Real& x : given) measures.push_back(&x);
    std::uint8_t verdict = 255;
    const axiscert_batch asked{sizeof asked, 1, column.size(), column.data()};
    axiscert_answers answers{};
    answers.size = sizeof answers;
    answers.verdict = &verdict;
    answers.measure_count = given.size();
    answers.measure = measures.data();
    kernel->run(&asked, &answers);
    std::string bytes;
    for (const double x : given) bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
    return bytes;
  });
  std::vector<double> found(reply.bytes.size() / sizeof(double));
  std::copy_n(reply.bytes.data(), reply.bytes.size(), reinterpret_cast<char*>(found.data()));
  return found;
}

// A peer's verdicts on a batch, one letter each; only '-' if it has no kernel of that precision.
template <class Real>
Reply ask(const std::string& name, const std::vector<Query<Real>>& queries) {
  return in_peer(name, [&](AxiscertPlugin* plugin) -> std::string {
    const axiscert_kernel* kernel = nullptr;
    for (std::uint32_t i = 0; (kernel = plugin(i)) != nullptr && kernel->precision != 8 * sizeof(Real);) ++i;
    if (kernel == nullptr) return "-";
    QueryBatch<Real> batch(queries.size(), coordinate_count);
    for (const Query<Real>& q : queries) batch.push_back(q);
    const QueryColumns<Real> columns = batch.columns();
    std::array<const void*, coordinate_count> column;
    std::copy_n(columns.column.begin(), columns.count, column.begin());
    const axiscert_batch asked{sizeof asked, columns.size, column.size(), column.data()};
    std::vector<std::uint8_t> verdicts(queries.size(), 255);
    axiscert_answers answers{};
    answers.size = sizeof answers;
    answers.verdict = verdicts.data();
    kernel->run(&asked, &answers);
    std::string letters;
    for (const std::uint8_t verdict : verdicts) letters += letter_of(*kernel, verdict);
    return letters;
  });
}

}  // namespace axiscert::peer
