// ratchet.txt: the ratchet that would accept the run.
#include "reports/formats/format.h"
#include "reports/gates/ratchet.h"

namespace axiscert {

extern const Format ratchet_format = {"ratchet.txt", "the ratchet that would accept this run", [](const Run& run) {
                                        return run.ratchet ? run.ratchet->accepted : ratchet_text(run.record);
                                      }};

}  // namespace axiscert
