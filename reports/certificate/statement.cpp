#include "reports/certificate/statement.h"

#include <fmt/format.h>

#include <span>

#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/base/version.h"
#include "kernel/plugin/load.h"
#include "reports/certificate/canonical.h"

namespace axiscert {
namespace {

std::string sha256_of(const std::string& bytes) { return sha256_hex(std::as_bytes(std::span(bytes))); }

}  // namespace

KernelKind kind_of_kernel(const Kernel& kernel) {
  if (kernel.file.empty()) return KernelKind::built_in;
  if (!plugin::is_given_by_file(kernel.id)) return KernelKind::peer;
  return plugin::is_program(kernel) ? KernelKind::program : KernelKind::plugin;
}

SubjectStatement file_subject(const std::string& path, const std::string& what) {
  return {base_name(path), {sha256_of(read_bytes(path))}, {what}};
}

SubjectStatement built_in_subject(const std::string& id) { return {id, {source_digests().kernels}, {"built-in"}}; }

std::vector<SubjectStatement> subjects_of(const Kernel& kernel) {
  if (kernel.file.empty()) return {built_in_subject(kernel.id)};
  std::vector<SubjectStatement> subjects;
  for (const plugin::KernelFile& file : plugin::files_of(kernel))
    subjects.push_back(file_subject(file.path, file.kind));
  return subjects;
}

Json without_fractions(const Json& value) {
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_structured()) return value;
  Json whole = value.is_array() ? Json::array() : Json::object();
  for (const auto& [name, part] : value.items()) {
    if (value.is_array()) whole.push_back(without_fractions(part));
    else whole[name] = without_fractions(part);
  }
  return whole;
}

Json portable_plan(Json plan) {
  plan["kernels"][0] = portable_id;
  Json files = Json::array();
  for (const Json& file : plan["files"]) {
    if (file["kind"] == "mesh" || file["kind"] == "queries" || file["kind"] == "corpus") files.push_back(file);
  }
  plan["files"] = files;
  plan["units_done"] = nullptr;
  plan.erase("axiscert");
  return without_fractions(plan);
}

std::string digest_of_json(const Json& value) {
  const std::string text = canonical_json(value);
  return sha256_hex(std::as_bytes(std::span(text)));
}

namespace {

// Whether it is a certificate of axiscert at all, and of the version that is read here.
void require_kind(const Json& statement, const std::string& name) {
  const auto is_text = [&](const char* member) { return statement.contains(member) && statement[member].is_string(); };
  if (!statement.is_object() || !is_text("_type") || !is_text("predicateType")) {
    throw Error(fmt::format("{}: is no certificate: `axiscert certify KERNEL` writes one", name));
  }
  if (statement["_type"] != InToto::format) {
    throw Error(fmt::format("{}: its _type is {}; a certificate is a Statement of in-toto, {}", name,
                            shown(statement["_type"].dump()), InToto::format));
  }
  const std::string type = statement["predicateType"];
  const std::string_view known = CertificateType::format;
  if (type == known) return;
  if (type.starts_with(known.substr(0, known.rfind(':') + 1))) {
    throw Error(
        fmt::format("{}: is a certificate of version {}; axiscert {} reads version {}: verify it with the axiscert "
                    "that made it, or certify the kernel anew",
                    name, shown(type), axiscert_version, known));
  }
  throw Error(fmt::format("{}: is a statement about {}, not a certificate of axiscert, {}", name, shown(type), known));
}

}  // namespace

std::string digest_without_itself(Json statement) {
  statement["predicate"].erase("digest");
  const std::string text = canonical_json(statement);
  return sha256_hex(std::as_bytes(std::span(text)));
}

std::string certificate_text(const CertificateStatement& statement, const SigningKey* key) {
  const Json json = json_of(statement);
  try {
    read_as<CertificateStatement>(json);
  } catch (const JsonFault& fault) {
    throw HarnessFault(fmt::format("the certificate does not conform to its schema: {}", fault.what()));
  }
  std::string text = canonical_json(json);
  return key == nullptr ? text + "\n" : envelope_text(signed_envelope(std::move(text), *key));
}

Certificate read_certificate(std::string_view bytes, const std::string& name) {
  Certificate read;
  std::string written(bytes);
  Json statement = strict_json(bytes, name, most_certificate_bytes);
  if (is_envelope(statement)) {
    read.envelope = read_envelope(statement, name);
    written = read.envelope->payload;
    statement = strict_json(written, name + ", the payload", most_certificate_bytes);
  } else if (written.ends_with('\n')) {
    written.pop_back();
  }
  require_kind(statement, name);
  const Json predicate = statement.value("predicate", Json());
  if (!predicate.is_object() || !predicate.contains("digest") || !predicate["digest"].is_string())
    throw Error(fmt::format("{}: the certificate states no digest of itself", name));
  const std::string digest = digest_without_itself(statement);
  if (predicate["digest"] != digest) {
    throw NotValid(fmt::format("{}: it was changed after it was written: its digest is {}, but it states {}", name,
                               digest, shown(predicate["digest"].dump())));
  }
  if (canonical_json(statement) != written) {
    throw NotValid(fmt::format(
        "{}: it was changed after it was written: the members are the same, and other bytes between them", name));
  }
  try {
    read.statement = read_as<CertificateStatement>(statement);
  } catch (const JsonFault& fault) {
    throw Error(fmt::format("{}: does not conform to {}: {}", name, CertificatePredicate::format, fault.what()));
  }
  return read;
}

Certificate read_certificate_file(const std::string& path) {
  std::ifstream file = open_file(path);
  std::string bytes(most_certificate_bytes + 1, '\0');
  bytes.resize(read_block(file, bytes, path));
  return read_certificate(bytes, path);
}

}  // namespace axiscert
