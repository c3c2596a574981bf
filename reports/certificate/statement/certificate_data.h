// certificate.json: the Statement that is the payload of what `axiscert certify` writes and `axiscert verify` reads.
#pragma once

#include "kernel/outcome.h"
#include "reports/certificate/statement/certificate_parts.h"

namespace axiscert {

struct DigestStatement {
  Sha256 sha256;

  static constexpr auto fields(auto&& visit) { return visit(field(&DigestStatement::sha256, {"sha256", {}})); }
};

struct AnnotationsStatement {
  SaidText what;

  static constexpr auto fields(auto&& visit) { return visit(field(&AnnotationsStatement::what, {"what", {}})); }
};

struct SubjectStatement {
  Name name;
  DigestStatement digest;
  AnnotationsStatement annotations;

  static constexpr std::string_view about = "An entry of in-toto: a name, its SHA-256, and what it is.";
  static constexpr auto fields(auto&& visit) {
    using Of = SubjectStatement;
    return visit(field(&Of::name, {"name", {}}), field(&Of::digest, {"digest", {}}),
                 field(&Of::annotations, {"annotations", {}}));
  }
};
using SubjectsStatement = Several<SubjectStatement, 1, 1000>;

// What it was made from.

struct AxiscertMaterial {
  SaidText version;
  Sha256 sources;

  static constexpr auto fields(auto&& visit) {
    using Of = AxiscertMaterial;
    return visit(field(&Of::version, {"version", {}}), field(&Of::sources, {"sources", {}}));
  }
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

  static constexpr auto fields(auto&& visit) {
    using Of = PlanMaterial;
    return visit(field(&Of::digest, {"digest", {}}), field(&Of::units_per_stretch, {"units_per_stretch", {}}),
                 field(&Of::plan, {"plan", "Of the record, but for its kernel's name and files."}));
  }
};

struct FamilyMaterial {
  std::uint64_t base_triangles = 0;
  std::optional<JsonObject> invariance, image_numbers;

  static constexpr auto fields(auto&& visit) {
    using Of = FamilyMaterial;
    return visit(field(&Of::base_triangles, {"base_triangles", {}}),
                 field(&Of::invariance, {.name = "invariance", .about = {}, .may_be_absent = true}),
                 field(&Of::image_numbers, {.name = "image_numbers", .about = {}, .may_be_absent = true}));
  }
};

// The id of the certificate's kernel in its materials, which do not depend on where the kernel's files are.
inline constexpr const char* portable_id = "kernel";

struct KernelMaterial {
  SaidText id;
  Precision precision = Precision::binary32;
  NamedValues<FamilyMaterial> families;
  NamedValues<Json> declared;  // the other members of its entry

  static constexpr auto fields(auto&& visit) {
    using Of = KernelMaterial;
    return visit(field(&Of::id, {"id", {}}), field(&Of::precision, {"precision", {}}),
                 field(&Of::families, {"families", {}}), rest(&Of::declared));
  }
};

struct FindingMaterial {
  Name kernel;
  std::optional<Precision> precision;
  std::optional<Name> family;
  FindingKind kind = FindingKind::load;
  PositiveCount count;
  SaidText detail;
  std::optional<Name> address;

  static constexpr auto fields(auto&& visit) {
    using Of = FindingMaterial;
    return visit(field(&Of::kernel, {"kernel", {}}), field(&Of::precision, {"precision", {}}),
                 field(&Of::family, {"family", {}}), field(&Of::kind, {"kind", {}}), field(&Of::count, {"count", {}}),
                 field(&Of::detail, {"detail", {}}), field(&Of::address, {"address", {}}));
  }
};

struct TallyMaterial {
  std::uint64_t stretch = 0;
  SaidText of;
  Several<Sha256, 1, 20> sha256;
  Several<JsonObject, 1, 20> counts;

  static constexpr auto fields(auto&& visit) {
    using Of = TallyMaterial;
    return visit(
        field(&Of::stretch, {"stretch", {}}), field(&Of::of, {"of", {}}),
        field(&Of::sha256, {"sha256", "Of each kernel's full tally, in the order of the plan."}),
        field(&Of::counts, {"counts",
                            "The counts of each kernel that levels read, as a family of a record has them, without "
                            "zeros; empty where it does not exist in the precision."}));
  }
};

struct MaterialsStatement {
  AxiscertMaterial axiscert;
  Sha256 proofs;
  PlanMaterial plan;
  Several<KernelMaterial, 1, 40> kernels;
  Several<FindingMaterial, 0, 10000> findings;
  Several<TallyMaterial, 0, 4194304> tallies;

  static constexpr auto fields(auto&& visit) {
    using Of = MaterialsStatement;
    return visit(
        field(&Of::axiscert, {"axiscert", {}}), field(&Of::proofs, {"proofs", {}}), field(&Of::plan, {"plan", {}}),
        field(&Of::kernels,
              {"kernels",
               "The record's entries of the kernels; of their families what is not counted by stretch. The first "
               "kernel of the plan is called \"kernel\"."}),
        field(&Of::findings, {"findings", "The record's findings, without their queries."}),
        field(&Of::tallies, {"tallies", {}}));
  }
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

  static constexpr std::string_view format = "axiscert-certificate/4";
  static constexpr auto fields(auto&& visit) {
    using Of = CertificatePredicate;
    return visit(
        field(&Of::schema, {"schema", {}}),
        field(&Of::digest, {"digest", "The SHA-256 of the canonical JSON of all else."}),
        field(&Of::signed_at, {"signed_at", {}}),
        field(&Of::signed_by, {"signed_by", "The SHA-256 of the signer's public key in DER; null: not signed."}),
        field(&Of::kernel, {"kernel", {}}), field(&Of::asked, {"asked", {}}), field(&Of::levels, {"levels", {}}),
        field(&Of::safe_margin, {"safe_margin", {}}), field(&Of::diagnosis, {"diagnosis", {}}),
        field(&Of::search, {"search", {}}), field(&Of::harness, {"harness", {}}),
        field(&Of::comparison, {"comparison", "Every kernel of the run, on the same queries."}),
        field(&Of::breaks_first, {"breaks_first", "Null where nothing is wrong."}),
        field(&Of::situations, {"situations", {}}), field(&Of::witnesses, {"witnesses", {}}),
        field(&Of::limits, {"limits", "Sentences that say what the certificate leaves open."}),
        field(&Of::materials, {"materials", {}}));
  }
};

struct InToto {
  static constexpr std::string_view format = "https://in-toto.io/Statement/v1";
};
struct CertificateType {
  static constexpr std::string_view format = "urn:axiscert:certificate:4";
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
  static constexpr auto fields(auto&& visit) {
    using Of = CertificateStatement;
    return visit(field(&Of::type, {"_type", {}}), field(&Of::predicate_type, {"predicateType", {}}),
                 field(&Of::subject, {"subject", {}}), field(&Of::predicate, {"predicate", {}}));
  }
};

}  // namespace axiscert
