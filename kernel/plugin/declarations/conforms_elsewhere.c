/* Conforms to a kernel that does not exist in its precision. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("conforms_elsewhere", answer_rightly, .conforms_to = "published+world-double")
