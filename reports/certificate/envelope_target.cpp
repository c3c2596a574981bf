// Fuzzes envelopes and base64: refused with an Error, or read, written and read again to the same; what is no base64 of
// its own bytes is refused; and no signature that was not made is taken for one.
#include "fuzz/targets/json_mutator.h"
#include "fuzz/targets/target.h"
#include "reports/certificate/statement.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/envelope.h"
#include "reports/page/encoding.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;

// The public key of RFC 8032, section 7.1, test 1: whoever knows no more than that signs nothing.
constexpr const char* pem =
    "-----BEGIN PUBLIC KEY-----\nMCowBQYDK2VwAyEA11qYAYKxCrfVS/7TyWQHOg7hcvPapiMlrwIaaPcHURo=\n-----END PUBLIC "
    "KEY-----\n";

const SigningKey& key() {
  static const MemoryFile file(pem);
  static const SigningKey read = SigningKey::public_from(file.path());
  return read;
}

bool is_signed(const Envelope& envelope) {
  try {
    require_signature(envelope, key(), "cert.json");
    return true;
  } catch (const NotValid& wrong) {
    check_message(wrong.what());
    return false;
  }
}

void check(std::string_view text) {
  Envelope envelope;
  if (!accepts([&] { envelope = read_envelope(strict_json(text, "cert.json", most_certificate_bytes), "cert.json"); }))
    return;
  const std::string written = envelope_text(envelope);
  const Envelope again = read_envelope(strict_json(written, "cert.json", most_certificate_bytes), "cert.json");
  if (again.payload != envelope.payload || again.signatures.size() != envelope.signatures.size())
    report_fault("an envelope that was read, written and read again differs");
  if (is_signed(envelope)) report_fault("a signature is taken for that of a key that made none");
}

void check_base64(std::string_view text) {
  std::string bytes;
  if (accepts([&] { bytes = bytes_of_base64(text); }) && base64(bytes) != text)
    report_fault("base64 that was read is written otherwise");
  if (bytes_of_base64(base64(text)) != text) report_fault("bytes that were written as base64 are read otherwise");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  check(text);
  check_base64(text);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  return mutate_json(data, size, room, seed);
}
