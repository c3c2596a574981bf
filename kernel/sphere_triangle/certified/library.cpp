// The C interface: makes blocks of queries in the callers' shapes, and the callers' results of the answers to blocks.
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "kernel/include/axiscert/certified.h"
#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/certified/default_modes.h"

namespace axiscert::certified {
namespace {

// What answers the questions that steps in floating point may answer, chosen once, under default modes: these steps on
// the best instruction set, or integers alone where the steps do not pass the check.
struct ChosenForms {
  bool passed;
  Forms forms;
};
const ChosenForms& chosen() noexcept {
  static const ChosenForms made = [] {
    if (!answer_as_stored(exact_only_forms(), true)) {
      std::fputs(
          "libaxiscert: its exact step fails its own check, so that no answer would be right; was it compiled with "
          "-ffast-math, or for another processor?\n",
          stderr);
      std::abort();
    }
    const Forms best = chosen_forms();
    const bool passed = answer_as_stored(best, false);
    return ChosenForms{passed, passed ? best : exact_only_forms()};
  }();
  return made;
}
const Forms& forms_for(axiscert_question question) noexcept {
  const ChosenForms& mine = chosen();
  if (question == AXISCERT_EXACT_ONLY || question == AXISCERT_OPEN_EXACT_ONLY) return exact_only_forms();
  return mine.forms;
}
Question question_of(axiscert_question question) noexcept {
  return question == AXISCERT_OPEN_EXACT_ONLY ? Question::open_sphere : static_cast<Question>(question);
}

// Writes the results of consecutive blocks.
class Results {
 public:
  Results(const axiscert_results* results, const Question question) noexcept
      : to_(results ? *results : axiscert_results{}), question_(question) {}

  Question question() const noexcept { return question_; }
  axiscert_counts counts() const noexcept { return counts_; }

  // name(i) is the number that stands for the i-th query of the whole call among the hits.
  template <std::size_t most, class Name>
  void add(const Answer<most>& answer, std::size_t size, Name&& name) noexcept {
    if (to_.verdict) write_verdicts(answer, size, to_.verdict + first_);
    for (std::size_t w = 0; w * 64 < size; ++w) {
      if (to_.contact) to_.contact[first_ / 64 + w] = answer.contact[w];
      if (to_.hits) {
        std::uint32_t* next = to_.hits + counts_.contacts;
        for (std::uint64_t rest = answer.contact[w]; rest != 0; rest &= rest - 1) {
          *next++ = static_cast<std::uint32_t>(name(first_ + w * 64 + first_bit(rest)));
        }
      }
      counts_.contacts += static_cast<std::size_t>(std::popcount(answer.contact[w]));
      counts_.invalid += static_cast<std::size_t>(std::popcount(answer.invalid[w]));
    }
    first_ += size;
  }

 private:
  axiscert_results to_;
  Question question_;
  std::size_t first_ = 0;
  axiscert_counts counts_{};
};

std::size_t block_from(std::size_t first, std::size_t size) noexcept {
  return size - first < block_size ? size - first : block_size;
}
std::size_t own_index(std::size_t i) noexcept { return i; }

// Uses the columns in place: thirteen, or nine of the triangles if `sphere` is not null, which then is the sphere of
// all queries.
template <class Real>
axiscert_counts by_columns(const Real* const* columns, const Real* sphere, std::size_t size, axiscert_question question,
                           const axiscert_results* results) noexcept {
  Results out(results, question_of(question));
  const DefaultModes modes;
  const auto decide = forms_for(question).block<Real>();
  for (std::size_t first = 0; first < size; first += block_size) {
    Block<Real> block{{}, block_from(first, size), sphere != nullptr};
    for (std::size_t k = 0; k < 9; ++k) block.column[k] = columns[k] + first;
    for (std::size_t k = 9; k < 13; ++k) block.column[k] = sphere ? sphere + (k - 9) : columns[k] + first;
    BlockAnswer answer;
    decide(block, out.question(), answer);
    out.add(answer, block.size, own_index);
  }
  return out.counts();
}

// The triangles of a list or, if it is null, those from `first` on.
template <class Real, class Mesh>
axiscert_counts by_mesh(const Real* sphere, const Mesh* mesh, const std::uint32_t* list, std::size_t first,
                        std::size_t size, axiscert_question question, const axiscert_results* results) noexcept {
  Results out(results, question_of(question));
  const DefaultModes modes;
  const auto decide = forms_for(question).mesh<Real>();
  Outcodes outcodes;
  MeshChunk<Real> chunk{sphere, mesh->vertices, mesh->stride, mesh->indices + 3 * first, list, 0};
  for (std::size_t rest = size; rest != 0; rest -= chunk.size) {
    chunk.size = rest < mesh_chunk_size ? rest : mesh_chunk_size;
    MeshAnswer answer;
    decide(chunk, out.question(), outcodes, answer);
    out.add(answer, chunk.size, [list, first](std::size_t i) { return list ? list[i] : first + i; });
    if (list) chunk.list += chunk.size;
    else chunk.indices += 3 * chunk.size;
  }
  return out.counts();
}

template <class Real>
axiscert_verdict pair(const Real* triangle, const Real* sphere, axiscert_question question) noexcept {
  BlockAnswer answer;
  {
    const DefaultModes modes;
    forms_for(question).pair<Real>()(triangle, sphere, question_of(question), answer);
  }
  return answer.invalid[0] ? AXISCERT_INVALID : answer.contact[0] ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
}

}  // namespace
}  // namespace axiscert::certified

using namespace axiscert::certified;  // for the definitions of the C functions

int axiscert_passed_self_check(void) noexcept {
  const DefaultModes modes;
  return chosen().passed;
}
axiscert_verdict axiscert_pair_f32(const float* triangle, const float* sphere, axiscert_question question) noexcept {
  return pair(triangle, sphere, question);
}
axiscert_verdict axiscert_pair_f64(const double* triangle, const double* sphere, axiscert_question question) noexcept {
  return pair(triangle, sphere, question);
}
axiscert_counts axiscert_pairs_f32(const float* const* columns, std::size_t size, axiscert_question question,
                                   const axiscert_results* results) noexcept {
  return by_columns<float>(columns, nullptr, size, question, results);
}
axiscert_counts axiscert_pairs_f64(const double* const* columns, std::size_t size, axiscert_question question,
                                   const axiscert_results* results) noexcept {
  return by_columns<double>(columns, nullptr, size, question, results);
}
axiscert_counts axiscert_triangles_f32(const float* sphere, const float* const* columns, std::size_t size,
                                       axiscert_question question, const axiscert_results* results) noexcept {
  return by_columns<float>(columns, sphere, size, question, results);
}
axiscert_counts axiscert_triangles_f64(const double* sphere, const double* const* columns, std::size_t size,
                                       axiscert_question question, const axiscert_results* results) noexcept {
  return by_columns<double>(columns, sphere, size, question, results);
}
axiscert_counts axiscert_mesh_list_f32(const float* sphere, const axiscert_mesh_f32* mesh,
                                       const std::uint32_t* triangle, std::size_t count, axiscert_question question,
                                       const axiscert_results* results) noexcept {
  return by_mesh(sphere, mesh, triangle, 0, count, question, results);
}
axiscert_counts axiscert_mesh_list_f64(const double* sphere, const axiscert_mesh_f64* mesh,
                                       const std::uint32_t* triangle, std::size_t count, axiscert_question question,
                                       const axiscert_results* results) noexcept {
  return by_mesh(sphere, mesh, triangle, 0, count, question, results);
}
axiscert_counts axiscert_mesh_range_f32(const float* sphere, const axiscert_mesh_f32* mesh, std::size_t first,
                                        std::size_t count, axiscert_question question,
                                        const axiscert_results* results) noexcept {
  return by_mesh(sphere, mesh, nullptr, first, count, question, results);
}
axiscert_counts axiscert_mesh_range_f64(const double* sphere, const axiscert_mesh_f64* mesh, std::size_t first,
                                        std::size_t count, axiscert_question question,
                                        const axiscert_results* results) noexcept {
  return by_mesh(sphere, mesh, nullptr, first, count, question, results);
}
