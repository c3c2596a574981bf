// The second step of a contact's numbers, for the queries that the first is not certain of.
#pragma once

#include "kernel/sphere_triangle/certified/contact_steps.h"

namespace axiscert::certified {

// Decides query i of a block as it stands: verdict and feature by the signs of integers, the numbers from differences,
// normals and offsets that are rounded once. Subnormal numbers must not be flushed, and rounding has to be to nearest.
// Uses about as much stack as exactly_separated.
template <class Real>
void settle_contact(const double (&query)[13], Question question, std::size_t i, const ContactColumns<Real>& to,
                    BlockContacts& answer) noexcept;
// The verdicts of `count` queries of a block by the steps of certified.h; their numbers are there.
template <class Real>
void settle_verdicts(const Block<Real>& block, const std::uint16_t* index, std::size_t count, Question question,
                     const ContactColumns<Real>& to, BlockContacts& answer) noexcept;
extern template void settle_contact<float>(const double (&)[13], Question, std::size_t, const ContactColumns<float>&,
                                           BlockContacts&) noexcept;
extern template void settle_contact<double>(const double (&)[13], Question, std::size_t, const ContactColumns<double>&,
                                            BlockContacts&) noexcept;
extern template void settle_verdicts<float>(const Block<float>&, const std::uint16_t*, std::size_t, Question,
                                            const ContactColumns<float>&, BlockContacts&) noexcept;
extern template void settle_verdicts<double>(const Block<double>&, const std::uint16_t*, std::size_t, Question,
                                             const ContactColumns<double>&, BlockContacts&) noexcept;

}  // namespace axiscert::certified
