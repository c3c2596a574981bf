// certificate.json: the Statement that is the payload of what `axiscert certify` writes and `axiscert verify` reads.
#pragma once

#include "kernel/outcome.h"
#include "reports/certificate/certificate_parts.h"

namespace axiscert {

struct DigestStatement {
  Sha256 sha256;

  AXISCERT_FIELDS(DigestStatement, AXISCERT_FIELD(sha256))
};

struct AnnotationsStatement {
  SaidText what;

  AXISCERT_FIELDS(AnnotationsStatement, AXISCERT_FIELD(what))
};

struct SubjectStatement {
  Name name;
  DigestStatement digest;
  AnnotationsStatement annotations;

  static constexpr std::string_view about = "An entry of in-toto: a name, its SHA-256, and what it is.";
  AXISCERT_FIELDS(SubjectStatement, AXISCERT_FIELD(name), AXISCERT_FIELD(digest), AXISCERT_FIELD(annotations))
};
using SubjectsStatement = Several<SubjectStatement, 1, 1000>;

// What it was made from.

struct AxiscertMaterial {
  SaidText version;
  Sha256 sources;

  AXISCERT_FIELDS(AxiscertMaterial, AXISCERT_FIELD(version), AXISCERT_FIELD(sources))
};

struct PositiveCount {
  std::uint64_t value = 1;
};
template <>
struct JsonForm<PositiveCount> {
  static Json write(PositiveCount count) { return count.value; }
  static void read(const JsonPlace& place, PositiveCount& into) {
    read_json(place, into.value);
    if (into.value == 0) place.refuse("is outside the minimum of 1");
  }
  static Json schema() {
    Json schema = json_schema_of<std::uint64_t>();
    schema["minimum"] = 1;
    return schema;
  }
};

struct PlanMaterial {
  Sha256 digest;
  PositiveCount units_per_stretch;
  JsonObject plan;

  AXISCERT_FIELDS(PlanMaterial, AXISCERT_FIELD(digest), AXISCERT_FIELD(units_per_stretch),
                  AXISCERT_FIELD(plan, "Of the record, but for its kernel's name and files."))
};

struct FamilyMaterial {
  std::uint64_t base_triangles = 0;
  std::optional<JsonObject> invariance, image_numbers;

  AXISCERT_FIELDS(FamilyMaterial, AXISCERT_FIELD(base_triangles), AXISCERT_OPTIONAL_FIELD(invariance),
                  AXISCERT_OPTIONAL_FIELD(image_numbers))
};

// The id of the certificate's kernel in its materials, which do not depend on where the kernel's files are.
inline constexpr const char* portable_id = "kernel";

struct KernelMaterial {
  SaidText id;
  Precision precision = Precision::binary32;
  NamedValues<FamilyMaterial> families;
  NamedValues<Json> declared;  // the other members of its entry

  AXISCERT_FIELDS(KernelMaterial, AXISCERT_FIELD(id), AXISCERT_FIELD(precision), AXISCERT_FIELD(families),
                  rest(&Of::declared))
};

struct FindingMaterial {
  Name kernel;
  std::optional<Precision> precision;
  std::optional<Name> family;
  FindingKind kind = FindingKind::load;
  PositiveCount count;
  SaidText detail;
  std::optional<Name> address;

  AXISCERT_FIELDS(FindingMaterial, AXISCERT_FIELD(kernel), AXISCERT_FIELD(precision), AXISCERT_FIELD(family),
                  AXISCERT_FIELD(kind), AXISCERT_FIELD(count), AXISCERT_FIELD(detail), AXISCERT_FIELD(address))
};

struct TallyMaterial {
  std::uint64_t stretch = 0;
  SaidText of;
  Several<Sha256, 1, 20> sha256;
  Several<JsonObject, 1, 20> counts;

  AXISCERT_FIELDS(TallyMaterial, AXISCERT_FIELD(stretch), AXISCERT_FIELD(of),
                  AXISCERT_FIELD(sha256, "Of each kernel's full tally, in the order of the plan."),
                  AXISCERT_FIELD(counts,
                                 "The counts of each kernel that levels read, as a family of a record has them, "
                                 "without zeros; empty where it does not exist in the precision."))
};

struct MaterialsStatement {
  AxiscertMaterial axiscert;
  Sha256 proofs;
  PlanMaterial plan;
  Several<KernelMaterial, 1, 40> kernels;
  Several<FindingMaterial, 0, 10000> findings;
  Several<TallyMaterial, 0, 4194304> tallies;

  AXISCERT_FIELDS(MaterialsStatement, AXISCERT_FIELD(axiscert), AXISCERT_FIELD(proofs), AXISCERT_FIELD(plan),
                  AXISCERT_FIELD(kernels,
                                 "The record's entries of the kernels; of their families what is not counted by "
                                 "stretch. The first kernel of the plan is called \"kernel\"."),
                  AXISCERT_FIELD(findings, "The record's findings, without their queries."), AXISCERT_FIELD(tallies))
};

// The statement.

struct SignedAtRule {
  static constexpr std::size_t longest = 20;
  static constexpr std::string_view pattern = "^[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z$";
};

struct CertificatePredicate {
  FormatName<CertificatePredicate> schema;
  Sha256 digest;
  std::optional<Text<SignedAtRule>> signed_at;
  std::optional<Sha256> signed_by;
  KernelStatement kernel;
  AskedStatement asked;
  Several<LevelStatement, 0, 1000> levels;
  SafeMarginStatement safe_margin;
  DiagnosisStatement diagnosis;
  SearchesStatement search;
  HarnessStatement harness;
  Several<ComparisonStatement, 0, 100> comparison;
  std::optional<BreakStatement> breaks_first;
  Several<SituationStatement, 0, 100> situations;
  Several<CertificateWitness, 0, 3> witnesses;
  Several<SaidText, 0, 100> limits;
  MaterialsStatement materials;

  static constexpr std::string_view format = "axiscert-certificate/7";
  AXISCERT_FIELDS(CertificatePredicate, AXISCERT_FIELD(schema),
                  AXISCERT_FIELD(digest, "The SHA-256 of the canonical JSON of all else."), AXISCERT_FIELD(signed_at),
                  AXISCERT_FIELD(signed_by, "The SHA-256 of the signer's public key in DER; null: not signed."),
                  AXISCERT_FIELD(kernel), AXISCERT_FIELD(asked), AXISCERT_FIELD(levels), AXISCERT_FIELD(safe_margin),
                  AXISCERT_FIELD(diagnosis), AXISCERT_FIELD(search), AXISCERT_FIELD(harness),
                  AXISCERT_FIELD(comparison, "Every kernel of the run, on the same queries."),
                  AXISCERT_FIELD(breaks_first, "Null where nothing is wrong."), AXISCERT_FIELD(situations),
                  AXISCERT_FIELD(witnesses),
                  AXISCERT_FIELD(limits, "Sentences that say what the certificate leaves open."),
                  AXISCERT_FIELD(materials))
};

struct InToto {
  static constexpr std::string_view format = "https://in-toto.io/Statement/v1";
};
struct CertificateType {
  static constexpr std::string_view format = "urn:axiscert:certificate:7";
};

struct CertificateStatement {
  FormatName<InToto> type;
  FormatName<CertificateType> predicate_type;
  SubjectsStatement subject;
  CertificatePredicate predicate;

  static constexpr std::string_view
      title = "A certificate of axiscert: a Statement of in-toto whose predicate says what a kernel was found to be",
      about =
          "The payload of certificate.json, which `axiscert certify` writes and `axiscert verify` reads; figures that "
          "are no whole numbers are decimal texts.";
  AXISCERT_FIELDS(CertificateStatement, field(&Of::type, {"_type", {}}),
                  field(&Of::predicate_type, {"predicateType", {}}), AXISCERT_FIELD(subject), AXISCERT_FIELD(predicate))
};

}  // namespace axiscert
