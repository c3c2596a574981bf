#include "fuzz/diagnosis/scenes/clear_queries.h"

#include <cmath>

#include "fuzz/instruments/exponent_window.h"

namespace axiscert::diagnosis {
namespace {

// Positions that are looked at for each query that is wanted.
constexpr std::uint64_t most_positions = 64;

}  // namespace

bool is_of_motions(const TestDescription& test) {
  return std::ranges::any_of(test.measures, [](const TestMeasure& measure) { return measure.name == "time"; });
}

const Family* plain_family(const Kernel& kernel) {
  for (const Family* family : families_of(*kernel.test)) {
    const std::string_view last = family->name.substr(family->name.rfind('/') + 1);
    if (family->entry == kernel.entry && (last.starts_with("general") || last.ends_with("_general"))) return family;
  }
  return nullptr;
}

template <class Real>
std::vector<ClearQuery<Real>> clear_queries(const Kernel& kernel, std::size_t count) {
  std::vector<ClearQuery<Real>> found;
  const Oracles& oracles = oracles_of(kernel);
  if (kernel.test == &first_test()) {
    for (const Query<Real>& q : window_queries<Real>()) {
      if (found.size() < count) found.push_back({q, oracles.truth(Numbers<Real>(q)).verdict});
    }
    return found;
  }
  const Family* family = plain_family(kernel);
  if (!family || !oracles.has_depth()) return found;
  for (std::uint64_t position = 0; found.size() < count && position < count * most_positions; ++position) {
    const Numbers<Real> numbers = family->make<Real>(1, position);
    const Truth truth = oracles.truth(numbers);
    if (truth.verdict == Verdict::invalid || !oracles.is_promised(kernel.motion, numbers)) continue;
    const std::optional<double> depth = oracles.depth(numbers);
    if (depth && *depth > clear_depth) found.push_back({numbers, truth.verdict});
  }
  return found;
}

template <class Real>
Numbers<Real> in_unit(const Kernel& kernel, const Numbers<Real>& numbers, int exponent) {
  const std::vector<TestColumn>& columns = kernel.test->entries[kernel.entry].columns;
  const bool displacements = is_of_motions(*kernel.test);
  Numbers<Real> scaled = numbers;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Role role = columns[k].role;
    if (role == Role::time || (role == Role::direction && !displacements)) continue;
    scaled[k] = std::ldexp(numbers[k], exponent);
  }
  return scaled;
}

template <class Real>
std::optional<std::string> why_not_sound(Subject<Real>& subject) {
  const auto clear = clear_queries<Real>(subject.kernel(), 128);
  if (clear.empty()) return std::nullopt;
  Queries<Real> queries;
  for (const auto& query : clear) queries.push_back(query.numbers);
  const std::vector<Verdict> said = subject.ask(queries);
  std::size_t right = 0, contacts = 0, separated = 0;
  for (std::size_t i = 0; i < said.size(); ++i) {
    right += said[i] == clear[i].truth;
    contacts += said[i] == Verdict::contact;
    separated += said[i] == Verdict::separated;
  }
  if (3 * right >= 2 * said.size() && contacts != 0 && separated != 0) return std::nullopt;
  return fmt::format(
      "It is right on {} of {} queries that are far from every boundary, and says contact on {}: its "
      "answers say nothing about finer things.",
      right, said.size(), contacts);
}

#define AXISCERT_INSTANCES(Real)                                                          \
  template std::vector<ClearQuery<Real>> clear_queries<Real>(const Kernel&, std::size_t); \
  template Numbers<Real> in_unit(const Kernel&, const Numbers<Real>&, int);               \
  template std::optional<std::string> why_not_sound(Subject<Real>&);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis
