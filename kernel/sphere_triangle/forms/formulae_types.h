// The types of the formulae that formulae_list.h names, for the code that evaluates them.
#pragma once

#include "kernel/sphere_triangle/formulae.h"
#include "kernel/sphere_triangle/forms/methods.h"
#include "kernel/sphere_triangle/forms/ladder.h"
#include "kernel/sphere_triangle/forms/reduced.h"
#include "kernel/sphere_triangle/forms/slips.h"
#include "kernel/formulae_list.h"

namespace axiscert {

template <Formulae f>
struct FormulaeTypeOf;
#define AXISCERT_TYPE(name, type_, kind)  \
  template <>                             \
  struct FormulaeTypeOf<Formulae::name> { \
    using type = type_;                   \
  };
AXISCERT_FORMULAE(AXISCERT_TYPE)
#undef AXISCERT_TYPE
template <Formulae f>
using FormulaeType = typename FormulaeTypeOf<f>::type;

}  // namespace axiscert
