#include "kernel/sphere_triangle/certified_kernels.h"

#include <limits>

#include "kernel/sphere_triangle/certified/contact_steps.h"
#include "kernel/sphere_triangle/certified/default_modes.h"
#include "kernel/sphere_triangle/certified/steps.h"
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

namespace {

// Calls visit(answer, first, size) for each block of contacts; to(first) is where its numbers go.
template <class Real, class To, class Visit>
void for_each_block(certified::DecideContacts<Real> decide, std::size_t block_size, const QueryColumns<Real>& batch,
                    To&& to, Visit&& visit) {
  const certified::DefaultModes modes;
  for (std::size_t first = 0; first < batch.size; first += block_size) {
    certified::Block<Real> block{{}, std::min(block_size, batch.size - first), false};
    for (std::size_t k = 0; k < coordinate_count; ++k) block.column[k] = batch.column[k] + first;
    certified::BlockContacts answer;
    decide(block, certified::Question::closed_sphere, to(first), answer);
    visit(answer, first, block.size);
  }
}
template <class Real>
void contact_verdicts(certified::DecideContacts<Real> decide, std::size_t block_size, const QueryColumns<Real>& batch,
                      Verdict* out) {
  Real unused[7][certified::block_size];
  const certified::ContactColumns<Real> to{
      unused[0], {unused[1], unused[2], unused[3]}, {unused[4], unused[5], unused[6]}};
  for_each_block(
      decide, block_size, batch, [&](std::size_t) { return to; },
      [&](const certified::BlockContacts& answer, std::size_t first, std::size_t size) {
        certified::write_verdicts(answer, size, reinterpret_cast<std::uint8_t*>(out + first));
      });
}
// The predicate's measures: separation, feature, normal and point. An invalid query has none.
template <class Real>
void contact_numbers(certified::DecideContacts<Real> decide, std::size_t block_size, const QueryColumns<Real>& batch,
                     Answers<Real>& out) {
  const auto column = [&](std::size_t k, std::size_t first) { return out.measures[k].data() + first; };
  for_each_block(
      decide, block_size, batch,
      [&](std::size_t i) -> certified::ContactColumns<Real> {
        return {column(0, i), {column(2, i), column(3, i), column(4, i)}, {column(5, i), column(6, i), column(7, i)}};
      },
      [&](const certified::BlockContacts& answer, std::size_t first, std::size_t size) {
        std::uint8_t feature[certified::block_size];
        certified::write_features(answer, size, feature);
        constexpr std::uint8_t none = 7;
        for (std::size_t i = 0; i < size; ++i) {
          column(1, first)[i] =
              feature[i] == none ? std::numeric_limits<Real>::quiet_NaN() : static_cast<Real>(feature[i]);
        }
      });
}

}  // namespace

template <class Real>
Implementation<Real> contact_implementation(std::string_view target) {
  static const SimdTable<certified::ContactForms> table([] { return certified::chosen_contact_forms(); });
  const bool is_scalar = target == scalar_target;
  const certified::ContactForms& forms = table.on(is_scalar ? std::string_view(simd_targets().front()) : target);
  const auto decide = is_scalar ? forms.one<Real>() : forms.block<Real>();
  const std::size_t block_size = is_scalar ? 1 : certified::block_size;
  Implementation<Real> made;
  made.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) {
    contact_verdicts<Real>(decide, block_size, batch, out);
  };
  made.measure = [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    contact_numbers<Real>(decide, block_size, batch, out);
  };
  return made;
}
template Implementation<float> contact_implementation<float>(std::string_view);
template Implementation<double> contact_implementation<double>(std::string_view);

}  // namespace axiscert
