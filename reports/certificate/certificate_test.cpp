// Certificates that are read and refused: each way to break one has its message.
#include "fuzz/text/json_form.h"
#include "reports/certificate/statement.h"

#include <set>

#include "kernel/base/folders.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/page.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

Json with_digest(Json statement) {
  statement["predicate"]["digest"] = digest_without_itself(statement);
  return statement;
}
Json stored_statement() { return with_digest(Json::parse(text_of(SOURCE_FOLDER "/reports/testing/certificate.json"))); }
CertificateStatement certificate_of(const Json& statement) { return read_as<CertificateStatement>(statement); }
std::string stored_certificate() { return canonical_json(stored_statement()) + "\n"; }
InstrumentReport report_of(const Json& statement) {
  return certificate_report(certificate_of(statement), "axiscert certify published");
}
std::string badge_of(const Json& statement) { return certificate_badge(certificate_of(statement)); }

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
  EXPECT_EQ(read.predicate().digest, stored_statement()["predicate"]["digest"].get<std::string>());
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
  for (const char* other : {"urn:axiscert:certificate:2", "urn:axiscert:certificate:8"}) {
    statement["predicateType"] = other;
    const std::string refusal = refusal_of(canonical_json(statement));
    EXPECT_THAT(refusal, HasSubstr(std::string("error: c.json: is a certificate of version ") + other + "; axiscert"));
    EXPECT_THAT(refusal, HasSubstr("certify the kernel anew"));
  }
  statement["predicateType"] = "https://slsa.dev/provenance/v1";
  EXPECT_THAT(refusal_of(canonical_json(statement)), HasSubstr("not a certificate of axiscert"));
  statement["_type"] = "https://in-toto.io/Statement/v0.1";
  EXPECT_THAT(refusal_of(canonical_json(statement)), HasSubstr("its _type is"));
  EXPECT_THAT(refusal_of("{}"), HasSubstr("is no certificate: `axiscert certify KERNEL` writes one"));
  EXPECT_THAT(refusal_of("[]"), HasSubstr("is no certificate"));
}

TEST(Certificate, WhatConformsToNoSchemaIsRefusedThoughItsDigestIsRight) {
  for (const char* member : {"levels", "kernel", "materials", "limits", "signed_at", "signed_by"}) {
    Json statement = stored_statement();
    statement["predicate"].erase(member);
    EXPECT_THAT(refusal_of(canonical_json(with_digest(statement))),
                HasSubstr("does not conform to axiscert-certificate/7"))
        << member;
  }
  CertificateStatement written = certificate_of(stored_statement());
  written.predicate.kernel.precisions.clear();
  EXPECT_THROW(certificate_text(written, nullptr), HarnessFault);
  Json statement = stored_statement();
  statement["predicate"]["more"] = 1;
  EXPECT_THAT(refusal_of(canonical_json(with_digest(statement))), HasSubstr("/predicate/more"));
  statement = stored_statement();
  statement["predicate"]["materials"]["plan"]["units_per_stretch"] = 0;
  EXPECT_THAT(refusal_of(canonical_json(with_digest(statement))), HasSubstr("0 is outside the minimum of 1"));
  statement = stored_statement();
  statement["predicate"]["witnesses"] = Json::array({{}, {}, {}, {}});
  EXPECT_THAT(refusal_of(canonical_json(with_digest(statement))),
              HasSubstr("/predicate/witnesses: an array with too many items"));
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

// Beginning with how much was asked of what, by whom: the first five lines of both.
TEST(CertificatePage, BeginsWithHowMuchWasLookedAt) {
  const std::string words = certificate_words(report_of(stored_statement()));
  const std::string first = words.substr(0, words.find("\nWhat breaks first"));
  EXPECT_EQ(first,
            "Certificate of published, sphere-triangle\n"
            "Made by axiscert 0.1.0 with effort quick, seed 1; not signed.\n"
            "Asked: 16 queries of 1 families and files, in binary32.\n"
            "9 looked at; left out: 2 outside its limits, 1 called invalid, 3 without an answer; 1 are no query.\n"
            "Met: exact. Not met: logic. NOT CHECKED: invariant=scale.");
  Json statement = stored_statement();
  statement["predicate"]["signed_by"] = std::string(64, 'a');
  statement["predicate"]["comparison"][0]["looked_at"] = 0;
  const std::string signed_words = certificate_words(report_of(statement));
  EXPECT_THAT(signed_words,
              testing::StartsWith("Certificate of published, sphere-triangle: it gave no answer that counts in "
                                  "binary32\n"));
  EXPECT_THAT(signed_words, HasSubstr("seed 1; signed by the key aaaaaaaaaaaaaaaa."));
}

TEST(CertificatePage, ShowsEveryLevelMarginAndLimit) {
  const InstrumentReport report = report_of(stored_statement());
  const std::string words = certificate_words(report), page = instrument_page(report);
  for (const char* part : {"Met: exact. Not met: logic.", "invariant=scale", "Safe margin in binary32", "1.00001",
                           "some text", "What breaks first", "Levels that were NOT CHECKED", "no answer"}) {
    EXPECT_THAT(words, HasSubstr(part));
    EXPECT_THAT(page, HasSubstr(part));
  }
  EXPECT_THAT(page, HasSubstr("<h2>In short</h2>"));
  // The levels stand first, and what each says is folded at the end.
  EXPECT_LT(page.find("<section id=\"answer\">"), page.find("<h2>In short</h2>"));
  EXPECT_LT(page.find("What this does not say"), page.find("<details><summary><h2>Levels</h2>"));
  ASSERT_TRUE(report.first);
  std::set<std::string> shown, stated;
  for (const auto& row : report.first->table.rows) shown.insert(row[0]);
  for (const LevelStatement& level : certificate_of(stored_statement()).predicate.levels) stated.insert(level.level);
  EXPECT_EQ(shown, stated);
}

TEST(CertificatePage, ASearchThatDecidedNothingForAGoalDidNotLookForIt) {
  const auto cell_of = [](const Json& statement, const char* goal = "critical_radius") {
    for (const InstrumentTable& table : report_of(statement).tables) {
      for (const auto& row : table.rows) {
        if (row.size() > 2 && row[1] == goal) return row[2];
      }
    }
    return std::string("no such row");
  };
  Json statement = stored_statement();
  EXPECT_EQ(cell_of(statement), "not looked at");
  statement["predicate"]["search"]["precisions"]["binary32"]["looked_at"]["critical_radius"] = 1234;
  EXPECT_EQ(cell_of(statement), "none among 1,234 decided");
  Json& search = statement["predicate"]["search"]["precisions"]["binary32"];
  search["finds"]["number left"] = nullptr;
  EXPECT_EQ(cell_of(statement, "number left"), "not looked at");
  search["looked_at"]["number left"] = 12;
  EXPECT_EQ(cell_of(statement, "number left"), "none among 12 judged") << "an answer may be decided without it";
}

// Nothing breaks where nothing is decided.
TEST(CertificatePage, SaysOnHowMuchNothingBroke) {
  Json statement = stored_statement();
  Json& predicate = statement["predicate"];
  predicate["breaks_first"] = nullptr;
  predicate["search"]["precisions"]["binary32"]["finds"] = {{"missed_contact", nullptr}};
  const auto note = [&] { return breaks_note(certificate_of(statement).predicate); };
  EXPECT_EQ(note(), "No verdict is wrong on 9 decided queries; not met: logic.");
  predicate["levels"][1]["state"] = "met";
  EXPECT_EQ(note(), "Nothing broke on 9 decided queries.");
  predicate["asked"]["contacts"] = predicate["asked"]["left_out"]["declined_contacts"] = 4;
  predicate["asked"]["left_out"]["declined"] = 4;
  EXPECT_EQ(note(), "Nothing broke on 9 decided queries; no contact was decided.");
  predicate["asked"]["left_out"]["declined_contacts"] = 0;
  predicate["asked"]["separations"] = predicate["asked"]["left_out"]["declined"] = 3;
  EXPECT_EQ(note(), "Nothing broke on 9 decided queries; no separation was decided.");
  predicate["asked"]["looked_at"] = 0;
  EXPECT_EQ(note(), "Nothing was looked at: none of 16 queries was decided.");
  predicate["search"]["precisions"]["binary32"]["finds"]["missed_contact"] = {
      {"depth", "0.25"}, {"links", Json::array()}, {"query", Json::object()}};
  EXPECT_EQ(note(),
            "Nothing was looked at: none of 16 queries was decided. But a search found a missed contact of depth 0.25 "
            "in binary32.");
}

TEST(CertificatePage, ABadgeSaysTheStrongestLevelThatIsMetAndHowMuchWasAsked) {
  Json statement = stored_statement();
  EXPECT_THAT(badge_of(statement), HasSubstr(">exact met; quick, 16 queries<"));
  EXPECT_THAT(badge_of(statement),
              HasSubstr("<title>axiscert: exact met; quick, 16 queries; made by axiscert 0.1.0 "
                        "with effort quick, seed 1; not signed; asked: 16 queries of 1 families and "
                        "files, in binary32; 9 looked at; left out: 2 outside"));
  statement["predicate"]["levels"][0]["state"] = "not met";
  EXPECT_THAT(badge_of(statement), HasSubstr(">no level met; quick"));
  statement["predicate"]["levels"][1]["state"] = "met";
  EXPECT_THAT(badge_of(statement), HasSubstr(">logic met; quick"));
}

// Never a bare "met" where something was left out.
TEST(CertificatePage, ABadgeSaysWhatALevelLeavesOut) {
  Json statement = stored_statement();
  Json& predicate = statement["predicate"];
  predicate["levels"][0]["claim"] = "exact within its limits: 19 of 27 families";
  EXPECT_THAT(badge_of(statement), HasSubstr(">exact within its limits: 19 of 27 families; quick"));
  predicate["levels"][0]["claim"] = "exact";
  predicate["asked"]["left_out"]["declined"] = 5;
  EXPECT_THAT(badge_of(statement), HasSubstr(">exact of the 64.2 % that it decides; quick"));
  predicate["asked"]["left_out"]["declined"] = 10000;
  EXPECT_THAT(badge_of(statement), HasSubstr(">exact of the less than 0.1 % that it decides; quick"));
  predicate["asked"]["left_out"]["declined"] = 0;
  predicate["asked"]["left_out"]["touching"] = 4;
  EXPECT_THAT(badge_of(statement), HasSubstr(">exact but for touching; quick"));
  predicate["comparison"][0]["looked_at"] = 0;
  EXPECT_THAT(badge_of(statement), HasSubstr(">it gave no answer that counts in binary32; quick"));
}

TEST(CertificatePage, ALevelThatIsNotCheckedInOnePrecisionIsNotMet) {
  Json statement = stored_statement();
  Json& levels = statement["predicate"]["levels"];
  levels.push_back(levels[0]);
  levels.back()["precision"] = "binary64";
  levels.back()["state"] = "NOT CHECKED";
  levels.back()["reason"] = "3 of 45 promised queries looked at";
  EXPECT_THAT(badge_of(statement), HasSubstr("no level met"));
  EXPECT_THAT(certificate_words(report_of(statement)), HasSubstr("NOT CHECKED: exact, invariant=scale."));
}

}  // namespace
}  // namespace axiscert
