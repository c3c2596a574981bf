// Envelopes: what is signed, by whom, and every way in which one does not hold.
#include "fuzz/text/json.h"
#include "reports/certificate/envelope.h"
#include "reports/page/encoding.h"

#include "kernel/base/folders.h"
#include "reports/certificate/canonical.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

// The keys of RFC 8032, section 7.1, tests 1 and 2.
constexpr const char* first_private =
    "-----BEGIN PRIVATE KEY-----\nMC4CAQAwBQYDK2VwBCIEIJ1hsZ3v/VpguoRK9JLsLMREScVpezJpGXA7rAMcrn9g\n-----END PRIVATE "
    "KEY-----\n";
constexpr const char* first_public =
    "-----BEGIN PUBLIC KEY-----\nMCowBQYDK2VwAyEA11qYAYKxCrfVS/7TyWQHOg7hcvPapiMlrwIaaPcHURo=\n-----END PUBLIC "
    "KEY-----\n";
constexpr const char* second_public =
    "-----BEGIN PUBLIC KEY-----\nMCowBQYDK2VwAyEAPUAXw+hDiVqStwqnTRt+vJyYLM8uxJaMwM1V8Sr0Zgw=\n-----END PUBLIC "
    "KEY-----\n";

class EnvelopeKeys : public testing::Test {
 protected:
  SigningKey from(const char* pem, bool is_private = false) const {
    const std::string path = folder_.write("key.pem", pem);
    return is_private ? SigningKey::private_from(path) : SigningKey::public_from(path);
  }
  TemporaryFolder folder_;
};

Envelope envelope_of(const std::string& text) { return read_envelope(strict_json(text, "c", 100000), "c"); }

template <class Do>
std::string said(Do&& doing) {
  try {
    doing();
    return "nothing";
  } catch (const std::exception& wrong) {
    return wrong.what();
  }
}

TEST_F(EnvelopeKeys, SignAsTheStandardHasIt) {
  // The empty message of RFC 8032's test 1.
  const std::string signature = from(first_private, true).sign("");
  EXPECT_EQ(base64(signature),
            "5VZDAMNgrHKQhuLMgG6CioSHfx645dl02HPgZSJJAVVfuIIVkKM7rMYeOXAc+bRr0lv18FlbviRlUUFDjnoQCw==");
  EXPECT_TRUE(from(first_public).has_signed("", signature));
  EXPECT_FALSE(from(first_public).has_signed("x", signature));
  EXPECT_EQ(pre_authentication("http://example.com/HelloWorld", "hello world"),
            "DSSEv1 29 http://example.com/HelloWorld 11 hello world");
}

TEST_F(EnvelopeKeys, AnEnvelopeHoldsForItsKeyAndItsBytesAlone) {
  const SigningKey key = from(first_private, true);
  const Envelope made = signed_envelope("{\"a\":1}", key);
  const Envelope read = envelope_of(envelope_text(made));
  EXPECT_EQ(read.payload, "{\"a\":1}");
  EXPECT_EQ(read.signatures[0].keyid, from(first_public).id());
  require_signature(read, from(first_public), "c");
  EXPECT_THAT(said([&] { require_signature(read, from(second_public), "c"); }),
              HasSubstr("c: it was not signed with this key, whose id is " + from(second_public).id()));
  Envelope changed = read;
  changed.payload = "{\"a\":2}";
  EXPECT_THAT(said([&] { require_signature(changed, from(first_public), "c"); }),
              HasSubstr("it was changed after it was signed"));
  changed = read;
  changed.signatures[0].bytes[10] = static_cast<char>(changed.signatures[0].bytes[10] ^ 1);
  EXPECT_THAT(said([&] { require_signature(changed, from(first_public), "c"); }),
              HasSubstr("it was changed after it was signed"));
  EXPECT_THROW(require_signature(changed, from(first_public), "c"), NotValid);
}

TEST_F(EnvelopeKeys, WhatIsNoKeyIsRefused) {
  EXPECT_THAT(said([&] { from("hello"); }), HasSubstr("is no public key in PEM"));
  EXPECT_THAT(said([&] { from(first_public, true); }), HasSubstr("is no private key in PEM"));
  EXPECT_THAT(said([&] { from(first_private); }), HasSubstr("is no public key in PEM"));
  // On the curve P-256.
  EXPECT_THAT(
      said([&] {
        from(
            "-----BEGIN PUBLIC KEY-----\nMFkwEwYHKoZIzj0CAQYIKoZIzj0DAQcDQgAE6/GWfvl/TlxRk1a3IH2SwQdoOlSmgsaHOb3z"
            "cYbthQiuKhrv96FGUQz8Ni6QJ/QcLlgsOr/BYpz2C+5SWcMtyw==\n-----END PUBLIC KEY-----\n");
      }),
      HasSubstr("is no Ed25519 key"));
}

TEST_F(EnvelopeKeys, WhatIsNoEnvelopeIsRefused) {
  const std::string whole = envelope_text(signed_envelope("{}", from(first_private, true)));
  const auto refusal = [&](const std::string& member, const Json& value) {
    Json json = Json::parse(whole);
    if (value.is_null()) json.erase(member);
    else json[member] = value;
    return said([&] { envelope_of(json.dump()); });
  };
  EXPECT_EQ(said([&] { envelope_of(whole); }), "nothing");
  EXPECT_THAT(refusal("payloadType", nullptr), HasSubstr("has no text 'payloadType'"));
  EXPECT_THAT(refusal("payloadType", "text/plain"), HasSubstr("payloadType is text/plain"));
  EXPECT_THAT(refusal("payload", "e30"), HasSubstr("'payload' of the envelope: is not base64"));
  EXPECT_THAT(refusal("payload", "e30=\n"), HasSubstr("is not base64"));
  EXPECT_THAT(refusal("signatures", Json::array()), HasSubstr("has no signature"));
  EXPECT_THAT(refusal("signatures", Json::array({{{"sig", "AAAA"}}})),
              HasSubstr("a signature of the envelope has 3 bytes"));
  EXPECT_THAT(refusal("signatures", Json(std::vector<Json>(17, Json::parse(whole)["signatures"][0]))),
              HasSubstr("more than 16 signatures"));
  EXPECT_THAT(refusal("more", 1), HasSubstr("has a member more"));
}

TEST(Base64, IsReadOnlyAsItIsWritten) {
  for (const std::string bytes : {"", "f", "fo", "foo", "foob", "fooba", "foobar"})
    EXPECT_EQ(bytes_of_base64(base64(bytes)), bytes);
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  for (const char* wrong :
       {"Zg", "Zg=", "Zh==", "Zm9=", " Zg==", "Zg== ", "Zg==\n", "Z===", "====", "Zm9v=", "Zm9vYg=", "Zm9v-_==", "Z"})
    EXPECT_THROW(bytes_of_base64(wrong), Error) << wrong;
}

}  // namespace
}  // namespace axiscert
