// The envelope of DSSE: a payload, its type, and Ed25519 signatures over both.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/text/json_fwd.h"

namespace axiscert {

inline constexpr const char* statement_type = "application/vnd.in-toto+json";

struct EnvelopeSignature {
  std::string
      keyid;  // SHA-256 of the public key in DER, 64 hex digits, as axiscert writes it; another's may be any text
  std::string bytes;  // 64
};
struct Envelope {
  std::string payload_type, payload;
  std::vector<EnvelopeSignature> signatures;
};

// A key in a PEM file.
class SigningKey {
 public:
  // Throws Error where the file is no private, or public, Ed25519 key; one with a pass phrase is refused.
  static SigningKey private_from(const std::string& path);
  static SigningKey public_from(const std::string& path);

  std::string id() const;                          // as EnvelopeSignature::keyid
  std::string sign(std::string_view bytes) const;  // with a private key
  bool has_signed(std::string_view bytes, std::string_view signature) const;

 private:
  SigningKey(void* key, std::string path);
  std::shared_ptr<void> key_;  // an EVP_PKEY
  std::string path_;
};

// The bytes that are signed: "DSSEv1 LEN TYPE LEN PAYLOAD".
std::string pre_authentication(std::string_view payload_type, std::string_view payload);

Envelope signed_envelope(std::string payload, const SigningKey& key);
// One line of canonical JSON with its end.
std::string envelope_text(const Envelope& envelope);

// Whether JSON is meant as an envelope: it has the member `payload`.
bool is_envelope(const Json& json);
// Throws Error, which begins with `name`, for members that are missing or unknown, another payload type, base64 that is
// not exactly that of its bytes, no signature, more than 16, and one that has not 64 bytes.
Envelope read_envelope(const Json& json, const std::string& name);

// Throws NotValid where no signature is of this key, and where one is, and the payload is not what was signed.
void require_signature(const Envelope& envelope, const SigningKey& key, const std::string& name);

// The bytes of base64 as base64() writes it (reports/page/encoding.h). Throws Error, without a name, for any other
// text.
std::string bytes_of_base64(std::string_view text);

}  // namespace axiscert
