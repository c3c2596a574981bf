#include "reports/certificate/envelope.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <algorithm>
#include <span>

#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "reports/certificate/canonical.h"
#include "reports/page/encoding.h"

namespace axiscert {
namespace {

constexpr std::size_t signature_bytes = 64, most_signatures = 16, most_key_bytes = 16 * 1024, most_keyid = 256;

const unsigned char* unsigned_bytes(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

// No pass phrase is ever asked for.
int no_pass_phrase(char*, int, int, void*) { return -1; }

using Bio = std::unique_ptr<BIO, decltype(&BIO_free)>;

EVP_PKEY* read_key(const std::string& path, bool is_private) {
  const std::string pem = read_bytes(path);
  if (pem.size() > most_key_bytes)
    throw Error(fmt::format("--key {}: {} bytes are too many for a key", path, pem.size()));
  const Bio bio(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())), &BIO_free);
  EVP_PKEY* key = is_private ? PEM_read_bio_PrivateKey(bio.get(), nullptr, no_pass_phrase, nullptr)
                             : PEM_read_bio_PUBKEY(bio.get(), nullptr, no_pass_phrase, nullptr);
  const char* const kind = is_private ? "private" : "public";
  const char* const made = is_private ? "openssl genpkey -algorithm ed25519 -out key.pem"
                                      : "openssl pkey -in key.pem -pubout -out public.pem";
  if (key == nullptr) throw Error(fmt::format("--key {}: is no {} key in PEM; `{}` makes one", path, kind, made));
  if (EVP_PKEY_get_base_id(key) == EVP_PKEY_ED25519) return key;
  EVP_PKEY_free(key);
  throw Error(fmt::format("--key {}: is no Ed25519 key; `{}` makes one", path, made));
}

using Context = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;
Context new_context() { return Context(EVP_MD_CTX_new(), &EVP_MD_CTX_free); }

const std::string& text_member(const Json& object, const char* member, const std::string& name) {
  if (object.is_object() && object.contains(member) && object[member].is_string())
    return object[member].get_ref<const std::string&>();
  throw Error(fmt::format("{}: the envelope has no text '{}'", name, member));
}

void require_members(const Json& object, std::initializer_list<std::string_view> known, const std::string& name) {
  for (const auto& [member, ignored] : object.items()) {
    if (std::find(known.begin(), known.end(), member) == known.end())
      throw Error(fmt::format("{}: the envelope has a member {}, which DSSE does not", name, shown(member)));
  }
}

std::string decoded_member(const Json& object, const char* member, const std::string& name) {
  try {
    return bytes_of_base64(text_member(object, member, name));
  } catch (const Error& wrong) {
    throw Error(fmt::format("{}: '{}' of the envelope: {}", name, member, wrong.what()));
  }
}

}  // namespace

SigningKey::SigningKey(void* key, std::string path)
    : key_(key, [](void* p) { EVP_PKEY_free(static_cast<EVP_PKEY*>(p)); }), path_(std::move(path)) {}
SigningKey SigningKey::private_from(const std::string& path) { return {read_key(path, true), path}; }
SigningKey SigningKey::public_from(const std::string& path) { return {read_key(path, false), path}; }

std::string SigningKey::id() const {
  unsigned char* der = nullptr;
  const int size = i2d_PUBKEY(static_cast<EVP_PKEY*>(key_.get()), &der);
  if (size <= 0) throw HarnessFault("OpenSSL refused to write a public key");
  const std::string bytes(reinterpret_cast<char*>(der), static_cast<std::size_t>(size));
  OPENSSL_free(der);
  return sha256_hex(std::as_bytes(std::span(bytes)));
}

std::string SigningKey::sign(std::string_view bytes) const {
  const Context context = new_context();
  std::string signature(signature_bytes, '\0');
  std::size_t size = signature.size();
  auto* const key = static_cast<EVP_PKEY*>(key_.get());
  if (EVP_DigestSignInit(context.get(), nullptr, nullptr, nullptr, key) != 1 ||
      EVP_DigestSign(context.get(), reinterpret_cast<unsigned char*>(signature.data()), &size, unsigned_bytes(bytes),
                     bytes.size()) != 1 ||
      size != signature_bytes) {
    throw Error(fmt::format("--key {}: OpenSSL does not sign with it", path_));
  }
  return signature;
}

bool SigningKey::has_signed(std::string_view bytes, std::string_view signature) const {
  const Context context = new_context();
  return EVP_DigestVerifyInit(context.get(), nullptr, nullptr, nullptr, static_cast<EVP_PKEY*>(key_.get())) == 1 &&
         EVP_DigestVerify(context.get(), unsigned_bytes(signature), signature.size(), unsigned_bytes(bytes),
                          bytes.size()) == 1;
}

std::string pre_authentication(std::string_view payload_type, std::string_view payload) {
  return fmt::format("DSSEv1 {} {} {} {}", payload_type.size(), payload_type, payload.size(), payload);
}

Envelope signed_envelope(std::string payload, const SigningKey& key) {
  const std::string signature = key.sign(pre_authentication(statement_type, payload));
  return {statement_type, std::move(payload), {{key.id(), signature}}};
}

std::string envelope_text(const Envelope& envelope) {
  Json signatures = Json::array();
  for (const EnvelopeSignature& s : envelope.signatures)
    signatures.push_back({{"keyid", s.keyid}, {"sig", base64(s.bytes)}});
  return canonical_json({{"payloadType", envelope.payload_type},
                         {"payload", base64(envelope.payload)},
                         {"signatures", signatures}}) +
         "\n";
}

bool is_envelope(const Json& json) { return json.is_object() && json.contains("payload"); }

Envelope read_envelope(const Json& json, const std::string& name) {
  Envelope envelope;
  envelope.payload_type = text_member(json, "payloadType", name);
  require_members(json, {"payloadType", "payload", "signatures"}, name);
  if (envelope.payload_type != statement_type) {
    throw Error(fmt::format("{}: the envelope's payloadType is {}, not {}", name, shown(envelope.payload_type),
                            statement_type));
  }
  envelope.payload = decoded_member(json, "payload", name);
  if (!json.contains("signatures") || !json["signatures"].is_array() || json["signatures"].empty())
    throw Error(fmt::format("{}: the envelope has no signature", name));
  if (json["signatures"].size() > most_signatures)
    throw Error(fmt::format("{}: the envelope has more than {} signatures", name, most_signatures));
  for (const Json& signature : json["signatures"]) {
    EnvelopeSignature& read = envelope.signatures.emplace_back();
    read.bytes = decoded_member(signature, "sig", name);
    require_members(signature, {"keyid", "sig"}, name);
    if (signature.contains("keyid")) read.keyid = text_member(signature, "keyid", name);
    if (read.bytes.size() != signature_bytes || read.keyid.size() > most_keyid) {
      throw Error(fmt::format("{}: a signature of the envelope has {} bytes and a keyid of {}; one of Ed25519 has {}",
                              name, read.bytes.size(), read.keyid.size(), signature_bytes));
    }
  }
  return envelope;
}

void require_signature(const Envelope& envelope, const SigningKey& key, const std::string& name) {
  const std::string signed_bytes = pre_authentication(envelope.payload_type, envelope.payload);
  const std::string id = key.id();
  bool is_named = false;
  std::string others;
  for (const EnvelopeSignature& signature : envelope.signatures) {
    if (key.has_signed(signed_bytes, signature.bytes)) return;
    is_named |= signature.keyid == id;
    others += (others.empty() ? "" : ", ") + (signature.keyid.empty() ? "an unnamed key" : shown(signature.keyid));
  }
  if (is_named) {
    throw NotValid(fmt::format(
        "{}: it says that key {} signed it, and that key did not sign these bytes: it was changed after it was signed",
        name, id));
  }
  throw NotValid(fmt::format("{}: it was not signed with this key, whose id is {}, but with {}", name, id, others));
}

std::string bytes_of_base64(std::string_view text) {
  // The library takes blanks and other tails; only what it writes itself is taken here.
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with("=") ? 1 : 0;
  std::string bytes(text.size() / 4 * 3 + 3, '\0');
  const int size = text.size() % 4 == 0 ? EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                                          unsigned_bytes(text), static_cast<int>(text.size()))
                                        : -1;
  if (size >= 0 && static_cast<std::size_t>(size) >= padding) {
    bytes.resize(static_cast<std::size_t>(size) - padding);
    if (base64(bytes) == text) return bytes;
  }
  throw Error("is not base64 as RFC 4648 has it, with its padding and without blanks");
}

}  // namespace axiscert
