// Plug-ins of two boxes whose verdict is that of the fifteen axes with cofactors, and whose numbers have one fault
// each.
#pragma once

#include <cstdint>

#include "kernel/boxes/contact.h"
#include "kernel/include/axiscert/plugin.h"

namespace axiscert::boxes {

struct Contact {
  float separation;
  Vec3<float> normal, point_a, point_b;
};

// Each query's numbers as `change(Contact&, const BoxPair<float>&)` leaves them.
template <auto change>
void run_changed(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (std::size_t i = 0; i < batch->count; ++i) {
    const auto q =
        MatrixBoxes::problem<float>([&](std::size_t k) { return static_cast<const float*>(batch->column[k])[i]; });
    const bool is_contact = bits_of<Cofactor, float>(q, [](std::size_t, float, float) {}) == 0;
    answers->verdict[i] = is_contact ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
    float m[contact_measures];
    WithContact<Cofactor>::measure(q, m);
    Contact contact{m[0], {m[1], m[2], m[3]}, {m[4], m[5], m[6]}, {m[7], m[8], m[9]}};
    if (is_contact) change(contact, q);
    const auto& [separation, n, a, b] = contact;
    const float numbers[] = {separation, n.x, n.y, n.z, a.x, a.y, a.z, b.x, b.y, b.z};
    for (std::size_t k = 0; k < answers->measure_count; ++k) static_cast<float*>(answers->measure[k])[i] = numbers[k];
  }
}

template <auto change>
const axiscert_kernel* changed_kernel(std::uint32_t index, const char* name, const char* source) {
  static axiscert_kernel kernel{};
  if (index != 0) return nullptr;
  kernel.abi = AXISCERT_PLUGIN_ABI;
  kernel.precision = 32;
  kernel.size = sizeof kernel;
  kernel.name = name;
  kernel.column_count = 30;
  kernel.run = run_changed<change>;
  kernel.predicate = "box-box";
  kernel.entry = "matrix";
  kernel.source = source;
  kernel.measure_count = contact_measures;
  return &kernel;
}

}  // namespace axiscert::boxes

// `change` is a function of a Contact& and a const BoxPair<float>&.
#define AXISCERT_BOX_CONTACT(name, change)                                                         \
  const axiscert_kernel* axiscert_plugin(std::uint32_t index) {                                    \
    return axiscert::boxes::changed_kernel<axiscert::boxes::change>(index, name, AXISCERT_SOURCE); \
  }
