#include "kernel/sphere_triangle/certified/kernels.h"

#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/certified/default_modes.h"
#include "kernel/sphere_triangle/forms/simd.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
using Decide = void (*)(const certified::Block<Real>&, certified::Question, certified::BlockAnswer&) noexcept;

template <class Real>
void verdicts(Decide<Real> decide, std::size_t block_size, certified::Question question,
              const QueryColumns<Real>& batch, Verdict* out) {
  const certified::DefaultModes modes;
  for (std::size_t first = 0; first < batch.size; first += block_size) {
    certified::Block<Real> block{{}, std::min(block_size, batch.size - first), false};
    for (std::size_t k = 0; k < coordinate_count; ++k) block.column[k] = batch.column[k] + first;
    certified::BlockAnswer answer;
    decide(block, question, answer);
    certified::write_verdicts(answer, block.size, reinterpret_cast<std::uint8_t*>(out + first));
  }
}

}  // namespace

template <class Real>
Implementation<Real> certified_implementation(std::string_view target, certified::Question question) {
  static const SimdTable<certified::Forms> table([] { return certified::chosen_forms(); });
  const bool is_scalar = target == scalar_target;
  const certified::Forms& forms = table.on(is_scalar ? std::string_view(simd_targets().front()) : target);
  const Decide<Real> decide = is_scalar ? forms.one<Real>() : forms.block<Real>();
  const std::size_t block_size = is_scalar ? 1 : certified::block_size;
  return {.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) {
    verdicts<Real>(decide, block_size, question, batch, out);
  }};
}
template Implementation<float> certified_implementation<float>(std::string_view, certified::Question);
template Implementation<double> certified_implementation<double>(std::string_view, certified::Question);

}  // namespace axiscert
