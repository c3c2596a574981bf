/* Exports no axiscert_plugin: a shared object of something else. */
#include "kernel/plugin/misbehaving/right.h"

AXISCERT_EXPORT void no_plugin(const axiscert_batch* batch, const axiscert_answers* answers);
void no_plugin(const axiscert_batch* batch, const axiscert_answers* answers) { answer_rightly(batch, answers); }
