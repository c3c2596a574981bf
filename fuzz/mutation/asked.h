// A batch of one family, and the truth known about it.
#pragma once

#include <atomic>
#include <vector>

#include "exact/trait/oracles.h"
#include "fuzz/campaign/unit.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/mutants/mutant.h"

namespace axiscert {

// Whether a wrong verdict on a family counts against a kernel that claims formulae, but not how it rounds: arithmetic
// is exact there, and in one unit of length, as `--require logic` has it. In others a kernel that computes in a
// narrower precision may leave its range.
inline bool shows_formulae(std::string_view family, bool exact_arithmetic) {
  return exact_arithmetic && image_group(family) == nullptr;
}

// The truth is found when it is first needed: few queries need it.
template <class Real>
struct Asked {
  const Family* family;
  const Oracles* oracles = &oracles_of(family->test(), family->entry);
  QueryBatch<Real> batch{batch_size, family->column_count()};
  std::vector<ComparisonBits> base;
  std::vector<Verdict> base_verdicts;
  // For each query: -1, 0, 1 where the two overlap, touch or are apart, or one of these. Threads that ask at the same
  // time find the same.
  static constexpr signed char unknown = 2, invalid = 3;
  std::vector<std::atomic<signed char>> order = std::vector<std::atomic<signed char>>(batch_size);

  explicit Asked(const Family* of) : family(of) {}
  const TestDescription& test() const { return family->test(); }

  // Makes `size` queries of the family from position `first` on, and the answers of the kernel without a fault.
  void prepare(const mutants::Mutant& without_fault, std::uint64_t seed, std::uint64_t first, std::size_t size) {
    batch.resize(size);
    family->fill(seed, first, batch.mutable_columns());
    base.resize(size);
    mutants::mutant_bits(without_fault, batch.columns(), base.data());
    base_verdicts.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      base_verdicts[i] = verdict_of(test(), base[i]);
      order[i].store(unknown, std::memory_order_relaxed);
    }
  }

  bool shows_formulae() const { return axiscert::shows_formulae(family->name, family->exact_arithmetic); }

  signed char order_of(std::size_t i) {
    signed char known = order[i].load(std::memory_order_relaxed);
    if (known != unknown) return known;
    const Truth truth = oracles->truth(batch[i]);
    known = truth.verdict == Verdict::invalid     ? invalid
            : truth.touching                      ? 0
            : truth.verdict == Verdict::separated ? 1
                                                  : -1;
    order[i].store(known, std::memory_order_relaxed);
    return known;
  }
  // Whether that verdict is wrong, touching being contact.
  bool is_wrong(std::size_t i, Verdict verdict) {
    const signed char known = order_of(i);
    return known != invalid && (known > 0) != (verdict == Verdict::separated);
  }
};

}  // namespace axiscert
