// Certificates that are read and refused: each way to break one has its message.
#include "reports/certificate/certificate.h"

#include "kernel/base/temporary_folder.h"
#include "reports/certificate/page.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/certificate/statement/statement.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

Json stored_statement() {
  return with_digest(Json::parse(text_of(SOURCE_FOLDER "/reports/testdata/certificate.json")));
}
std::string stored_certificate() { return certificate_text(stored_statement(), nullptr); }

// The message of an Error or of NotValid, with which of the two it is.
std::string refusal_of(const std::string& bytes) {
  try {
    read_certificate(bytes, "c.json");
    return "read";
  } catch (const NotValid& wrong) {
    return std::string("NOT VALID: ") + wrong.what();
  } catch (const Error& wrong) {
    return std::string("error: ") + wrong.what();
  }
}

std::string replaced_once(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, text.npos) << part;
  return at == text.npos ? text : text.replace(at, part.size(), by);
}

TEST(Certificate, IsReadToWhatWasWritten) {
  const Certificate read = read_certificate(stored_certificate(), "c.json");
  EXPECT_FALSE(read.envelope);
  EXPECT_EQ(certificate_text(read.statement, nullptr), stored_certificate());
  EXPECT_EQ(read.digest(), stored_statement()["predicate"]["digest"].get<std::string>());
}

TEST(Certificate, EveryChangedByteIsRefused) {
  const std::string whole = stored_certificate();
  for (std::size_t at = 0; at + 1 < whole.size(); ++at) {
    for (const int bit : {0, 5}) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ (1 << bit));
      ASSERT_NE(refusal_of(changed), "read") << "byte " << at << ", bit " << bit;
    }
  }
}

TEST(Certificate, AWordThatWasChangedIsToldFromAFileThatIsCutOff) {
  const std::string whole = stored_certificate();
  EXPECT_THAT(refusal_of(replaced_once(whole, "\"not met\"", "\"met\"")),
              HasSubstr("NOT VALID: c.json: it was changed after it was written: its digest is"));
  EXPECT_THAT(refusal_of(whole.substr(0, whole.size() / 2)), HasSubstr("error: c.json: it ends in the middle"));
  EXPECT_THAT(refusal_of(""), HasSubstr("error: c.json: it ends in the middle, after 0 bytes"));
  EXPECT_THAT(refusal_of("hello"), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal_of(" " + whole), HasSubstr("other bytes between them"));
  EXPECT_THAT(refusal_of(whole + "\n"), HasSubstr("other bytes between them"));
}

TEST(Certificate, AnotherVersionAndAnotherStatementAreNamed) {
  Json statement = stored_statement();
  statement["predicateType"] = "urn:axiscert:certificate:2";
  EXPECT_THAT(refusal_of(canonical_json(statement)),
              HasSubstr("error: c.json: is a certificate of version urn:axiscert:"
                        "certificate:2; axiscert"));
  statement["predicateType"] = "https://slsa.dev/provenance/v1";
  EXPECT_THAT(refusal_of(canonical_json(statement)), HasSubstr("not a certificate of axiscert"));
  statement["_type"] = "https://in-toto.io/Statement/v0.1";
  EXPECT_THAT(refusal_of(canonical_json(statement)), HasSubstr("its _type is"));
  EXPECT_THAT(refusal_of("{}"), HasSubstr("is no certificate: `axiscert certify KERNEL` writes one"));
  EXPECT_THAT(refusal_of("[]"), HasSubstr("is no certificate"));
}

TEST(Certificate, WhatConformsToNoSchemaIsRefusedThoughItsDigestIsRight) {
  for (const char* member : {"levels", "kernel", "materials", "limits", "signed_at"}) {
    Json statement = stored_statement();
    statement["predicate"].erase(member);
    EXPECT_THAT(refusal_of(canonical_json(with_digest(statement))),
                HasSubstr("does not conform to axiscert-certificate/1"))
        << member;
    EXPECT_THROW(certificate_text(with_digest(statement), nullptr), HarnessFault);
  }
  Json statement = stored_statement();
  statement["predicate"]["more"] = 1;
  EXPECT_THAT(refusal_of(canonical_json(with_digest(statement))), HasSubstr("/predicate/more"));
}

TEST(StrictJson, RefusesWhatTheLibraryTakes) {
  const auto refusal = [](const std::string& text, std::size_t most = 1000) -> std::string {
    try {
      strict_json(text, "x", most);
      return "read";
    } catch (const Error& wrong) {
      return wrong.what();
    }
  };
  EXPECT_EQ(refusal(R"({"a":[1,{"b":2}],"c":{"b":-3}})"), "read");
  EXPECT_THAT(refusal(R"({"a":1,"b":{"a":1},"a":1})"), HasSubstr("x: the member \"a\" occurs twice"));
  EXPECT_THAT(refusal(R"({"a":1.5})"), HasSubstr("no whole one"));
  EXPECT_THAT(refusal("18446744073709551616"), HasSubstr("no whole one"));
  EXPECT_EQ(refusal(std::string(32, '[') + std::string(32, ']')), "read");
  EXPECT_THAT(refusal(std::string(33, '[') + std::string(33, ']')), HasSubstr("more than 32 levels"));
  EXPECT_THAT(refusal(std::string(400, '['), 100), HasSubstr("x: 400 bytes; a certificate has at most 100"));
  EXPECT_THAT(refusal("\"\xff\""), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal("{} {}"), HasSubstr("is not JSON"));
}

TEST(CanonicalJson, HasEqualBytesForEqualValuesAndNoFraction) {
  EXPECT_EQ(canonical_json(Json::parse(R"({ "b" : [1, {"d":null,"c":true}], "a" : "\u00e9\n" })")),
            "{\"a\":\"\xc3\xa9\\n\",\"b\":[1,{\"c\":true,\"d\":null}]}");
  EXPECT_THROW(canonical_json({{"a", 0.5}}), HarnessFault);
  EXPECT_EQ(canonical_json(without_fractions({{"a", 0.5}, {"b", {1e-7, 3}}})), R"({"a":"0.5","b":["1e-07",3]})");
}

TEST(CertificatePage, ShowsEveryLevelMarginAndLimit) {
  const InstrumentReport report = certificate_report(stored_statement(), "axiscert certify published");
  const std::string words = certificate_words(report), page = instrument_page(report);
  for (const char* part : {"Met: exact. Not met: logic.", "invariant=scale", "Safe margin in binary32", "1.00001",
                           "some text", "What breaks first", "Levels that were not asked"}) {
    EXPECT_THAT(words, HasSubstr(part));
    EXPECT_THAT(page, HasSubstr(part));
  }
  EXPECT_THAT(page, HasSubstr("<h2>In short</h2>"));
}

TEST(CertificatePage, ABadgeSaysTheStrongestLevelThatIsMet) {
  Json statement = stored_statement();
  EXPECT_THAT(certificate_badge(statement), HasSubstr("axiscert: exact met"));
  statement["predicate"]["levels"][0]["state"] = "not met";
  EXPECT_THAT(certificate_badge(statement), HasSubstr("axiscert: no level met"));
  statement["predicate"]["levels"][1]["state"] = "met";
  EXPECT_THAT(certificate_badge(statement), HasSubstr("axiscert: logic met"));
}

}  // namespace
}  // namespace axiscert
