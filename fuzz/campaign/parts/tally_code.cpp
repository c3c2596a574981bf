#include "fuzz/campaign/parts/tally_code.h"

#include "fuzz/fields/journal_form.h"

namespace axiscert {
namespace {

template <class Of>
std::string encoded(const Of& of) {
  Encoder encoder;
  encoder.put(of);
  return encoder.bytes();
}

// Reports bytes that do not fit as an Error.
template <class Of>
Of decoded(std::string_view bytes, Of into) {
  try {
    Decoder decoder(bytes);
    decoder.get(into);
    decoder.finish();
    return into;
  } catch (const Cbor::exception& wrong) {
    throw Error(std::string("the bytes are not a tally: ") + wrong.what());
  }
}

}  // namespace

std::string encode(const Tally& tally) { return encoded(tally); }
std::string encode(const Costs& costs) { return encoded(costs); }
Tally decode_tally(std::string_view bytes, const Predicate& predicate) {
  return decoded(bytes, empty_tally(predicate));
}
Costs decode_costs(std::string_view bytes) { return decoded(bytes, Costs()); }

}  // namespace axiscert
