#include "cli/options/test_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <fmt/ranges.h>

#include "kernel/base/error.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

// "family 'tangent'", "mesh/spider.obj".
std::string shown_source(const Source& source) {
  return source.file() ? source.name() : fmt::format("family '{}'", source.name());
}

std::string_view entry_name(const TestDescription& test, std::size_t entry) { return test.entries[entry].name; }

}  // namespace

CLI::Option* add_test_option(CLI::App& command, std::string& test, const std::string& use) {
  return command.add_option("--test", test, use);
}

const TestDescription& test_given(const std::string& test) { return test.empty() ? first_test() : find_test(test); }

const TestDescription& test_of_kernels(const std::string& test, const std::vector<const Kernel*>& kernels) {
  if (!test.empty()) {
    const TestDescription& given = find_test(test);
    for (const Kernel* kernel : kernels) {
      if (kernel->test == &given) continue;
      throw Error(fmt::format("kernel '{}' is of the test {}, and --test is {}; a run judges kernels of one test",
                              kernel->id, kernel->test->id, given.id));
    }
    return given;
  }
  for (const Kernel* kernel : kernels) {
    if (kernel->test == kernels.front()->test) continue;
    throw Error(fmt::format("kernel '{}' is of the test {}, and kernel '{}' of {}; a run judges kernels of one test",
                            kernels.front()->id, kernels.front()->test->id, kernel->id, kernel->test->id));
  }
  return kernels.empty() ? first_test() : *kernels.front()->test;
}

const Kernel& default_kernel(const TestDescription& test, std::size_t entry) {
  if (&test == &first_test()) return find_kernel("published");
  for (const Kernel& kernel : kernels()) {
    if (kernel.test == &test && kernel.entry == entry) return kernel;
  }
  throw Error(fmt::format("the test {} has no built-in kernel; give one with --kernel", test.id));
}

std::size_t entry_of_families(const TestDescription& test, const std::vector<std::string>& families) {
  for (const std::string& name : families) {
    if (name == "all") continue;
    if (const Family& family = find_family(name); &family.test() == &test) return family.entry;
  }
  return 0;
}

void require_one_test(const std::vector<const Kernel*>& kernels, const std::vector<SourcePtr>& sources) {
  for (const SourcePtr& source : sources) {
    for (const Kernel* kernel : kernels) {
      if (kernel->test != &source->test()) {
        throw Error(
            fmt::format("kernel '{}' is of the test {}, and {} of {}; a run judges kernels of one test (--test)",
                        kernel->id, kernel->test->id, shown_source(*source), source->test().id));
      }
      if (kernel->entry != source->entry()) {
        throw Error(fmt::format(
            "kernel '{}' takes the entry {} of the test {}, and {} has {}; a kernel is judged on queries of its own "
            "entry",
            kernel->id, entry_name(*kernel->test, kernel->entry), kernel->test->id, shown_source(*source),
            entry_name(source->test(), source->entry())));
      }
    }
  }
}

const TestDescription& test_of_sources(const std::string& test, const std::vector<SourcePtr>& sources) {
  const TestDescription& given = test.empty() && !sources.empty() ? sources.front()->test() : test_given(test);
  for (const SourcePtr& source : sources) {
    if (&source->test() == &given) continue;
    const std::string other = test.empty() ? fmt::format("{} of {}", shown_source(*sources.front()), given.id)
                                           : fmt::format("--test is {}", given.id);
    throw Error(fmt::format("{} is of the test {}, and {}; queries of one test go together{}", shown_source(*source),
                            source->test().id, other, test.empty() ? " (--test)" : ""));
  }
  return given;
}

bool has_columns(const TestDescription& test, std::size_t entry) { return entry == 0 || test.id != "moving-sphere"; }

void require_columns(std::string_view command, const TestDescription& test, std::size_t entry) {
  if (has_columns(test, entry)) return;
  throw Error(fmt::format("{} does not serve the entry {} of the test {} yet; it serves {}", command,
                          entry_name(test, entry), test.id, entry_name(test, 0)));
}

std::vector<const TestDescription*> tests_with_moves() {
  return {&sphere_triangle_test(), &find_test("moving-sphere"), &find_test("box-box"), &find_test("box-triangle")};
}

bool has_moves(const TestDescription& test, std::size_t entry) {
  const auto served = tests_with_moves();
  return std::find(served.begin(), served.end(), &test) != served.end() && has_columns(test, entry);
}

void require_moves(std::string_view command, const TestDescription& test, std::size_t entry) {
  require_served(command, test, tests_with_moves());
  require_columns(command, test, entry);
}

void require_served(std::string_view command, const TestDescription& test) {
  require_served(command, test, {&sphere_triangle_test()});
}

void require_served(std::string_view command, const TestDescription& test,
                    const std::vector<const TestDescription*>& served) {
  std::vector<std::string_view> names;
  for (const TestDescription* one : served) {
    if (&test == one) return;
    names.push_back(one->id);
  }
  throw Error(fmt::format("{} does not serve the test {} yet; it serves {}", command, test.id, fmt::join(names, ", ")));
}

}  // namespace axiscert
