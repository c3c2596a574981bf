// The C interface of contacts: makes blocks of queries in the callers' shapes, and writes into the callers' arrays.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "kernel/include/axiscert/contact.h"
#include "kernel/sphere_triangle/certified/contact_steps.h"
#include "kernel/sphere_triangle/certified/default_modes.h"

namespace axiscert::certified {

namespace {

// The bits of a byte as bytes, the lowest first: three of these cost less than three of spread_over_bytes().
constexpr auto bytes_of = [] {
  std::array<std::uint64_t, 256> all{};
  for (std::uint64_t bits = 0; bits < all.size(); ++bits) {
    for (unsigned k = 0; k < 8; ++k) all[bits] |= (bits >> k & 1) << (8 * k);
  }
  return all;
}();

}  // namespace

void write_features(const BlockContacts& answer, std::size_t size, std::uint8_t* out) noexcept {
  for (std::size_t first = 0; first < size; first += 64) {
    const std::uint64_t plane[3] = {answer.feature[0][first / 64], answer.feature[1][first / 64],
                                    answer.feature[2][first / 64]};
    for (std::size_t i = first; i < size && i < first + 64; i += 8) {
      const auto bytes = [&](int k) { return bytes_of[plane[k] >> (i - first) & 0xff]; };
      const std::uint64_t features = bytes(0) | bytes(1) << 1 | bytes(2) << 2;
      std::memcpy(out + i, &features, size - i < 8 ? size - i : 8);
    }
  }
}
// Most words of a block have a normal for each query.
void write_has_normal(const BlockContacts& answer, std::size_t size, std::uint8_t* out) noexcept {
  for (std::size_t first = 0; first < size; first += 64) {
    const std::size_t count = size - first < 64 ? size - first : 64;
    std::memset(out + first, 1, count);
    for (std::uint64_t none = answer.no_normal[first / 64]; none != 0; none &= none - 1) {
      const auto at = static_cast<std::size_t>(std::countr_zero(none));
      if (at < count) out[first + at] = 0;
    }
  }
}

namespace {

template <class Real>
struct Numbers {
  Real number[7][block_size];
  ContactColumns<Real> columns() noexcept {
    return {number[0], {number[1], number[2], number[3]}, {number[4], number[5], number[6]}};
  }
};

// Whether the first step answers as the second does, within twice their bounds, about queries that each operation
// matters to: thin triangles beside spheres that touch them but for roundings. It looks at what a compiler's flags
// change.
template <class Real>
bool agrees(const ContactForms& forms) noexcept {
  Real column[13][block_size];
  std::uint64_t state = 20261127;
  const auto one = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<Real>(static_cast<double>(static_cast<std::int64_t>(state) >> 11) * 0x1p-52);
  };
  Block<Real> block{{}, block_size, false};
  for (std::size_t k = 0; k < 13; ++k) block.column[k] = column[k];
  for (std::size_t i = 0; i < block_size; ++i) {
    for (auto& numbers : column) numbers[i] = one();
    const Real along = one(), thin = i % 2 ? Real(1) : std::ldexp(Real(1), -static_cast<int>(i % 64) / 4);
    for (std::size_t k = 0; k < 3; ++k)
      column[6 + k][i] = column[k][i] + along * (column[3 + k][i] - column[k][i]) + thin * one();
    column[12][i] = std::fabs(column[12][i]);
  }
  Numbers<Real> found, exact;
  BlockContacts answer, exact_answer;
  const auto ask = [&] {
    forms.block<Real>()(block, Question::closed_sphere, found.columns(), answer);
    exact_contact_forms().block<Real>()(block, Question::closed_sphere, exact.columns(), exact_answer);
  };
  ask();
  for (std::size_t i = 0; i < block_size; i += 2) {
    column[12][i] += exact.number[0][i];
    if (!(column[12][i] >= 0)) column[12][i] = 0;
  }
  ask();
  bool same = true;
  for (std::size_t w = 0; w < block_size / 64; ++w) {
    same &= answer.contact[w] == exact_answer.contact[w] && answer.invalid[w] == 0;
    for (int k = 0; k < 3; ++k) same &= answer.feature[k][w] == exact_answer.feature[k][w];
  }
  constexpr double u = sizeof(Real) == 4 ? 0x1p-24 : 0x1p-53, greatest_size = 8;
  for (std::size_t k = 0; k < 7; ++k) {
    for (std::size_t i = 0; i < block_size; ++i)
      same &= std::fabs(static_cast<double>(found.number[k][i]) - static_cast<double>(exact.number[k][i])) <=
              (sizeof(Real) == 4 ? 2 : 32) * greatest_size * u;
  }
  return same;
}

const ContactForms& contact_forms_for(axiscert_question question) noexcept {
  static const ContactForms best = [] {
    const ContactForms made = chosen_contact_forms();
    return axiscert_passed_self_check() && agrees<float>(made) && agrees<double>(made) ? made : exact_contact_forms();
  }();
  const bool is_exact_only = question == AXISCERT_EXACT_ONLY || question == AXISCERT_OPEN_EXACT_ONLY;
  return is_exact_only ? exact_contact_forms() : best;
}
Question question_of(axiscert_question question) noexcept {
  const bool is_open = question == AXISCERT_OPEN_SPHERE || question == AXISCERT_OPEN_EXACT_ONLY;
  return is_open ? Question::open_sphere : Question::closed_sphere;
}

// Writes the results of consecutive blocks.
template <class Real, class Arrays>
class Writer {
 public:
  Writer(const Arrays* arrays, axiscert_question question, bool with_verdicts) noexcept
      : to_(arrays ? *arrays : Arrays{}),
        decide_(contact_forms_for(question).block<Real>()),
        question_(question_of(question)) {
    if (!with_verdicts) to_.verdict = nullptr;
  }
  axiscert_counts counts() const noexcept { return counts_; }

  void add(const Block<Real>& block) noexcept {
    ContactColumns<Real> columns = unused_.columns();
    const auto use = [&](Real* given, Real*& column) {
      if (given) column = given + first_;
    };
    use(to_.separation, columns.separation);
    for (int k = 0; k < 3; ++k) {
      use(to_.normal[k], columns.normal[k]);
      use(to_.point[k], columns.point[k]);
    }
    BlockContacts answer;
    decide_(block, question_, columns, answer);
    if (to_.verdict) write_verdicts(answer, block.size, to_.verdict + first_);
    if (to_.feature) write_features(answer, block.size, to_.feature + first_);
    if (to_.has_normal) write_has_normal(answer, block.size, to_.has_normal + first_);
    for (std::size_t w = 0; w * 64 < block.size; ++w) {
      counts_.contacts += static_cast<std::size_t>(std::popcount(answer.contact[w]));
      counts_.invalid += static_cast<std::size_t>(std::popcount(answer.invalid[w]));
    }
    first_ += block.size;
  }

 private:
  Arrays to_;
  DecideContacts<Real> decide_;
  Question question_;
  std::size_t first_ = 0;
  axiscert_counts counts_{};
  Numbers<Real> unused_;  // for the arrays that are null
};

std::size_t block_from(std::size_t first, std::size_t size) noexcept {
  return size - first < block_size ? size - first : block_size;
}

template <class Real, class Arrays>
axiscert_counts by_columns(const Real* const* columns, std::size_t size, axiscert_question question,
                           const Arrays* arrays) noexcept {
  const DefaultModes modes;
  Writer<Real, Arrays> out(arrays, question, true);
  // Stores that cross cache lines take half as long again. Where the numbers lie in a line as the queries do, as those
  // of vectors do, the first block ends with a line.
  const auto place_in_line = [](const Real* column) { return reinterpret_cast<std::uintptr_t>(column) % 64; };
  const std::size_t place = arrays && arrays->separation ? place_in_line(arrays->separation) : 0;
  const bool aligns = size != 0 && place == place_in_line(columns[0]);  // of no queries there are no columns
  const std::size_t head = aligns ? (64 - place) % 64 / sizeof(Real) : 0;
  for (std::size_t first = 0, count = 0; first < size; first += count) {
    count = first == 0 && head != 0 && head < size ? head : block_from(first, size);
    Block<Real> block{{}, count, false};
    for (std::size_t k = 0; k < 13; ++k) block.column[k] = columns[k] + first;
    out.add(block);
  }
  return out.counts();
}

// The numbers of the hits that a mesh call of certified.h found.
template <class Real, class Mesh, class Arrays>
axiscert_counts of_hits(const Real* sphere, const Mesh* mesh, axiscert_counts counts, axiscert_question question,
                        const std::uint32_t* hits, const Arrays* arrays) noexcept {
  const DefaultModes modes;
  Writer<Real, Arrays> out(arrays, question, false);
  Real column[9][block_size];
  for (std::size_t first = 0; first < counts.contacts; first += block_size) {
    Block<Real> block{{}, block_from(first, counts.contacts), true};
    for (std::size_t k = 0; k < 9; ++k) block.column[k] = column[k];
    for (std::size_t k = 9; k < 13; ++k) block.column[k] = sphere + (k - 9);
    for (std::size_t i = 0; i < block.size; ++i) {
      const std::uint32_t* vertices = mesh->indices + 3 * std::size_t{hits[first + i]};
      for (std::size_t k = 0; k < 9; ++k) column[k][i] = mesh->vertices[mesh->stride * vertices[k / 3] + k % 3];
    }
    out.add(block);
  }
  return counts;
}

template <class Real, class Data>
axiscert_verdict one_pair(const Real* triangle, const Real* sphere, axiscert_question question, Data* data) noexcept {
  Block<Real> block{{}, 1, true};
  for (std::size_t k = 0; k < 9; ++k) block.column[k] = triangle + k;
  for (std::size_t k = 9; k < 13; ++k) block.column[k] = sphere + (k - 9);
  Data unused, &to = data ? *data : unused;
  BlockContacts answer;
  {
    const DefaultModes modes;
    contact_forms_for(question).one<Real>()(
        block, question_of(question),
        {&to.separation, {&to.normal[0], &to.normal[1], &to.normal[2]}, {&to.point[0], &to.point[1], &to.point[2]}},
        answer);
  }
  const auto digit = [&](int k) { return (answer.feature[k][0] & 1u) << k; };
  to.feature = static_cast<std::uint8_t>(digit(0) | digit(1) | digit(2));
  to.has_normal = static_cast<std::uint8_t>(~answer.no_normal[0] & 1u);
  return answer.invalid[0] ? AXISCERT_INVALID : answer.contact[0] ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
}

// What decides which triangles are contacts: a conservative answer is none of these questions.
axiscert_question asked(axiscert_question question) noexcept {
  return question == AXISCERT_CONSERVATIVE ? AXISCERT_CLOSED_SPHERE : question;
}

}  // namespace
}  // namespace axiscert::certified

using namespace axiscert::certified;  // for the definitions of the C functions

axiscert_verdict axiscert_contact_f32(const float* triangle, const float* sphere, axiscert_question question,
                                      axiscert_contact_data_f32* data) noexcept {
  return one_pair(triangle, sphere, question, data);
}
axiscert_verdict axiscert_contact_f64(const double* triangle, const double* sphere, axiscert_question question,
                                      axiscert_contact_data_f64* data) noexcept {
  return one_pair(triangle, sphere, question, data);
}
axiscert_counts axiscert_contact_pairs_f32(const float* const* columns, std::size_t size, axiscert_question question,
                                           const axiscert_contact_arrays_f32* arrays) noexcept {
  return by_columns<float>(columns, size, question, arrays);
}
axiscert_counts axiscert_contact_pairs_f64(const double* const* columns, std::size_t size, axiscert_question question,
                                           const axiscert_contact_arrays_f64* arrays) noexcept {
  return by_columns<double>(columns, size, question, arrays);
}
axiscert_counts axiscert_contact_mesh_list_f32(const float* sphere, const axiscert_mesh_f32* mesh,
                                               const std::uint32_t* triangle, std::size_t count,
                                               axiscert_question question, std::uint32_t* hits,
                                               const axiscert_contact_arrays_f32* arrays) noexcept {
  const axiscert_results found{nullptr, nullptr, hits};
  return of_hits(sphere, mesh, axiscert_mesh_list_f32(sphere, mesh, triangle, count, asked(question), &found), question,
                 hits, arrays);
}
axiscert_counts axiscert_contact_mesh_list_f64(const double* sphere, const axiscert_mesh_f64* mesh,
                                               const std::uint32_t* triangle, std::size_t count,
                                               axiscert_question question, std::uint32_t* hits,
                                               const axiscert_contact_arrays_f64* arrays) noexcept {
  const axiscert_results found{nullptr, nullptr, hits};
  return of_hits(sphere, mesh, axiscert_mesh_list_f64(sphere, mesh, triangle, count, asked(question), &found), question,
                 hits, arrays);
}
axiscert_counts axiscert_contact_mesh_range_f32(const float* sphere, const axiscert_mesh_f32* mesh, std::size_t first,
                                                std::size_t count, axiscert_question question, std::uint32_t* hits,
                                                const axiscert_contact_arrays_f32* arrays) noexcept {
  const axiscert_results found{nullptr, nullptr, hits};
  return of_hits(sphere, mesh, axiscert_mesh_range_f32(sphere, mesh, first, count, asked(question), &found), question,
                 hits, arrays);
}
axiscert_counts axiscert_contact_mesh_range_f64(const double* sphere, const axiscert_mesh_f64* mesh, std::size_t first,
                                                std::size_t count, axiscert_question question, std::uint32_t* hits,
                                                const axiscert_contact_arrays_f64* arrays) noexcept {
  const axiscert_results found{nullptr, nullptr, hits};
  return of_hits(sphere, mesh, axiscert_mesh_range_f64(sphere, mesh, first, count, asked(question), &found), question,
                 hits, arrays);
}
