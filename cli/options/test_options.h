// The test of a command: `--test`, kernels and queries that have to be of one test, and what commands need of a test.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

// Adds --test; `use` says what the command does with it.
CLI::Option* add_test_option(CLI::App& command, std::string& test, const std::string& use);
// The test of a command that names none, neither itself nor by a kernel or queries.
const TestDescription& default_test();
// The test that --test names; the default where it was not given. Throws Error that lists the tests.
const TestDescription& test_given(const std::string& test);

// The test that --test names; where it was not given that of the kernels, and the default where there are none.
// Throws Error that names two kernels of different tests, or a kernel of another test than --test.
const TestDescription& test_of_kernels(const std::string& test, const std::vector<const Kernel*>& kernels);
// The kernel of a command that names none: the first that takes this entry of the test.
const Kernel& default_kernel(const TestDescription& test, std::size_t entry = 0);
// The entry of the first of these families that is of the test; of none, the test's first.
std::size_t entry_of_families(const TestDescription& test, const std::vector<std::string>& families);
// Throws Error that names a kernel and a source of different tests, or of different entries of one test.
void require_one_test(const std::vector<const Kernel*>& kernels, const std::vector<SourcePtr>& sources);
// The test that --test names; where it was not given that of the first source. Throws Error that names a source of
// another test.
const TestDescription& test_of_sources(const std::string& test, const std::vector<SourcePtr>& sources);

// Commands ask whether an entry of a test has something that they need.
using Capability = bool(const TestDescription& test, std::size_t entry);
bool has_critical_length(const TestDescription& test, std::size_t entry);
bool has_filters(const TestDescription& test, std::size_t entry = 0);
// Whether search, shrink and map can move its queries.
bool has_moves(const TestDescription& test, std::size_t entry);
// Whether search values the errors of comparisons (Capabilities::aim_values).
bool has_error_aims(const TestDescription& test, std::size_t entry);
// Whether shrink maps a query to its images (Capabilities::image_maps).
bool has_image_maps(const TestDescription& test, std::size_t entry);
// Whether a kernel of the test has formulae of kernel/formulae_list.h.
bool has_formulae(const TestDescription& test, std::size_t entry);
// "sphere-triangle, box-box".
std::string ids_of(const std::vector<const TestDescription*>& tests);
// The tests that have it in some entry.
std::vector<const TestDescription*> tests_with(Capability& capability);

// For a command, or an option of one, that needs a capability: throws Error where the test, or its entry, has it not.
void require_capability(Capability& capability, std::string_view command, const TestDescription& test,
                        std::size_t entry);
void require_moves(std::string_view command, const TestDescription& test, std::size_t entry);

// For a command, or an option of one, that serves these tests: throws Error for any other.
void require_served(std::string_view command, const TestDescription& test,
                    const std::vector<const TestDescription*>& served);

}  // namespace axiscert
