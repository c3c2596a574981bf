#include "cli/options/test_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <fmt/ranges.h>

#include "exact/trait/oracles.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/base/error.h"

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

const TestDescription& default_test() { return test_named(""); }

const TestDescription& test_given(const std::string& test) { return test.empty() ? default_test() : find_test(test); }

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
  return kernels.empty() ? default_test() : *kernels.front()->test;
}

const Kernel& default_kernel(const TestDescription& test, std::size_t entry) {
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

bool has_critical_length(const TestDescription& test, std::size_t entry) {
  return oracles_of(test, entry).critical_length().has_value();
}

bool has_filters(const TestDescription& test, std::size_t entry) { return oracles_of(test, entry).has_filters(); }

bool has_moves(const TestDescription& test, std::size_t entry) { return test.entries[entry].has_free_numbers; }

bool has_error_aims(const TestDescription& test, std::size_t) { return capabilities_of(test).aim_values != nullptr; }

bool has_image_maps(const TestDescription& test, std::size_t) { return capabilities_of(test).image_maps != nullptr; }

bool has_formulae(const TestDescription& test, std::size_t entry) {
  return test.claims_arithmetic && std::ranges::any_of(kernels(), [&](const Kernel& kernel) {
           return kernel.test == &test && kernel.entry == entry && !kernel.formulae.empty();
         });
}

std::string ids_of(const std::vector<const TestDescription*>& tests) {
  std::vector<std::string_view> ids;
  for (const TestDescription* test : tests) ids.push_back(test->id);
  return fmt::format("{}", fmt::join(ids, ", "));
}

std::vector<const TestDescription*> tests_with(Capability& capability) {
  std::vector<const TestDescription*> able;
  for (const TestDescription* test : tests()) {
    std::size_t entry = 0;
    while (entry < test->entries.size() && !capability(*test, entry)) ++entry;
    if (entry < test->entries.size()) able.push_back(test);
  }
  return able;
}

void require_capability(Capability& capability, std::string_view command, const TestDescription& test,
                        std::size_t entry) {
  require_served(command, test, tests_with(capability));
  if (capability(test, entry)) return;
  std::vector<std::string_view> able;
  for (std::size_t other = 0; other < test.entries.size(); ++other) {
    if (capability(test, other)) able.push_back(entry_name(test, other));
  }
  throw Error(fmt::format("{} does not serve the entry {} of the test {} yet; it serves {}", command,
                          entry_name(test, entry), test.id, fmt::join(able, ", ")));
}

void require_moves(std::string_view command, const TestDescription& test, std::size_t entry) {
  require_capability(has_moves, command, test, entry);
}

void require_served(std::string_view command, const TestDescription& test,
                    const std::vector<const TestDescription*>& served) {
  if (std::ranges::find(served, &test) != served.end()) return;
  throw Error(fmt::format("{} does not serve the test {} yet; it serves {}", command, test.id, ids_of(served)));
}

}  // namespace axiscert
