// A certificate for people: a page and a text of the same content, and a badge.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/certificate/certificate_data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// How much a certificate rests on, in the sentences with which its page, its badge and `verify` begin.

// "made by axiscert 1.0.0 with effort quick, seed 1".
std::string made_sentence(const CertificatePredicate& predicate);
// "not signed", or "signed by the key 0123456789abcdef", the beginning of its id.
std::string signer_sentence(const CertificatePredicate& predicate);
// "28,311,552 queries of 28 families and files, in binary32 and binary64".
std::string asked_sentence(const CertificatePredicate& predicate);
// "27,900,000 looked at; left out: 3 outside its limits, 4 declined; 411,552 are no query".
std::string looked_sentence(const CertificatePredicate& predicate);
// "it gave no answer that counts in binary32"; empty where it gave some in each precision.
std::string no_answers_sentence(const CertificatePredicate& predicate);

// The first statement of each level, in their order: there is one for each precision.
std::vector<const LevelStatement*> first_of_levels(const CertificatePredicate& predicate);
// The levels of a state in all precisions together: "not met" where it is so in one, else "NOT CHECKED" where it is so
// in one, else "met". By their claims: "exact within its limits: 19 of 27 families".
std::vector<std::string> levels_with(const CertificatePredicate& predicate, LevelState state);
LevelState state_of_level(const CertificatePredicate& predicate, const std::string& level);

// A level with what it is said of: "exact", "exact within its limits: 19 of 27 families".
std::string claim_of_level(const CertificatePredicate& predicate, const std::string& level);
// Every level that is met leaves out this besides: " of the 61.2 % that it decides", " but for touching"; empty for
// nothing.
std::string decided_text(const CertificatePredicate& predicate);

// The faults of a kernel and what to do about them, for the page.

// A sentence on what breaks first, and what to do; or on how much nothing broke.
std::string breaks_note(const CertificatePredicate& predicate);

// Findings of the diagnosis that somebody who uses the kernel has to know; empty where there are none.
std::string peculiarities_note(const CertificatePredicate& predicate);

// The situations in which it is wrong, with what to do in each; no rows for a predicate whose wrong verdicts have
// classes.
InstrumentTable situations_table(const CertificatePredicate& predicate);

// `command` is what made it. `record`, of the same kernel, says the sentences with which the page begins; null: none.
InstrumentReport certificate_report(const CertificateStatement& statement, const std::string& command,
                                    const Record* record = nullptr);

// The same for a terminal: sentences are wrapped at 110 columns.
std::string certificate_words(const InstrumentReport& report);

// An SVG: the strongest of exact, conservative and logic that is met, or that none is, and how much was asked; its
// title has the first lines of the page.
std::string certificate_badge(const CertificateStatement& statement);

}  // namespace axiscert
