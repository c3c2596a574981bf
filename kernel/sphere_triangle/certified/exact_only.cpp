#include "kernel/sphere_triangle/certified/steps.h"

#include <cmath>

#include "kernel/sphere_triangle/certified/exact_step.h"

namespace axiscert::certified {
namespace {

// Decides query i of an answer, as it stands, with nothing known before.
template <std::size_t most>
void decide(const double (&query)[13], Question question, std::size_t i, Answer<most>& answer) noexcept {
  bool is_valid = query[12] >= 0;
  for (const double x : query) is_valid &= std::isfinite(x);
  const std::uint64_t bit = std::uint64_t{1} << (i % 64);
  if (!is_valid) answer.invalid[i / 64] |= bit;
  else if (!separated_by_integers(query, question)) answer.contact[i / 64] |= bit;
}

template <class Real>
void decide_block(const Block<Real>& block, Question question, BlockAnswer& answer) noexcept {
  answer = {};
  for (std::size_t i = 0; i < block.size; ++i) {
    double query[13];
    for (std::size_t k = 0; k < 13; ++k) query[k] = block.column[k][k >= 9 && block.one_sphere ? 0 : i];
    decide(query, question, i, answer);
  }
}

template <class Real>
void decide_mesh(const MeshChunk<Real>& mesh, Question question, Outcodes&, MeshAnswer& answer) noexcept {
  answer = {};
  for (std::size_t i = 0; i < mesh.size; ++i) {
    const std::uint32_t* vertices = mesh.indices + 3 * std::size_t{mesh.list ? mesh.list[i] : i};
    double query[13];
    for (std::size_t k = 0; k < 9; ++k) query[k] = mesh.vertices[mesh.stride * vertices[k / 3] + k % 3];
    for (std::size_t k = 9; k < 13; ++k) query[k] = mesh.sphere[k - 9];
    decide(query, question, i, answer);
  }
}

template <class Real>
void decide_pair(const Real* triangle, const Real* sphere, Question question, BlockAnswer& answer) noexcept {
  answer.contact[0] = answer.invalid[0] = 0;
  double query[13];
  for (std::size_t k = 0; k < 9; ++k) query[k] = triangle[k];
  for (std::size_t k = 9; k < 13; ++k) query[k] = sphere[k - 9];
  decide(query, question, 0, answer);
}

}  // namespace

const Forms& exact_only_forms() noexcept {
  static constexpr Forms forms = {decide_block<float>, decide_block<double>, decide_block<float>, decide_block<double>,
                                  decide_mesh<float>,  decide_mesh<double>,  decide_pair<float>,  decide_pair<double>};
  return forms;
}

}  // namespace axiscert::certified
