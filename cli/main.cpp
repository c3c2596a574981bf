// axiscert: judges collision tests beside exact arithmetic.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/ending.h"
#include "cli/usage.h"
#include "fuzz/files/query_file.h"

int main(int argc, char** argv) {
  using namespace axiscert;
  // Each plug-in at work on a thread is a process with a socket and a memory file.
  if (rlimit files{}; getrlimit(RLIMIT_NOFILE, &files) == 0) {
    files.rlim_cur = files.rlim_max;
    setrlimit(RLIMIT_NOFILE, &files);
  }
  // Where both are one file or pipe (2>&1), their lines keep their order.
  struct stat out {
  }, error{};
  if (fstat(STDOUT_FILENO, &out) == 0 && fstat(STDERR_FILENO, &error) == 0 && out.st_dev == error.st_dev &&
      out.st_ino == error.st_ino)
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  CLI::App app;
  std::set<std::string> said;  // a file may be read again, of which nothing new is to be said
  set_query_notes([&](const std::string& note) {
    if (said.insert(note).second) fmt::print(stderr, "axiscert: {}\n", note);
  });
  Action action;
  declare_command_line(app, action);
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  begin_command(words);
  try {
    app.parse(argc, argv);
    require_values(app, words);
    const int code = action();
    finish_output();
    if (code == exit_interrupted || code == exit_terminated) print_how_to_go_on();
    return code;
  } catch (const CLI::ParseError& usage) {
    return print_usage(app, usage, words);
  } catch (...) {
    return print_failure(std::current_exception());
  }
}
