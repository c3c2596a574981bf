// The second step of a contact's numbers, for the queries that the first is not certain of.
#pragma once

#include "kernel/sphere_triangle/certified/contact/contact_steps.h"

namespace axiscert::certified {

// Decides query i of a block as it stands: verdict and feature by the signs of integers, the numbers from differences,
// normals and offsets that are rounded once. Subnormal numbers must not be flushed, and rounding has to be to nearest.
// Uses about as much stack as exactly_separated.
template <class Real>
void settle_contact(const double (&query)[13], Question question, std::size_t i, const ContactColumns<Real>& to,
                    BlockContacts& answer) noexcept;
extern template void settle_contact<float>(const double (&)[13], Question, std::size_t, const ContactColumns<float>&,
                                           BlockContacts&) noexcept;
extern template void settle_contact<double>(const double (&)[13], Question, std::size_t, const ContactColumns<double>&,
                                            BlockContacts&) noexcept;

}  // namespace axiscert::certified
