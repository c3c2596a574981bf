/* Declares a column fewer than its predicate has. */
#define COLUMN_COUNT 12
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("wrong_columns", answer_rightly)
