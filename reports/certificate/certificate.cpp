#include "reports/certificate/certificate.h"

#include <fmt/format.h>

#include <span>

#include "fuzz/text/file_bytes.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/base/version.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/page/embedded.h"
#include "reports/run_folder/schema.h"

namespace axiscert {
namespace {

std::string digest_without_itself(Json statement) {
  statement["predicate"].erase("digest");
  const std::string text = canonical_json(statement);
  return sha256_hex(std::as_bytes(std::span(text)));
}

std::optional<std::string> certificate_fault(const Json& statement) {
  static const Json schema = Json::parse(embedded::certificate_schema_json);
  return schema_fault(schema, statement);
}

// Whether it is a certificate of axiscert at all, and of the version that is read here.
void require_kind(const Json& statement, const std::string& name) {
  const auto is_text = [&](const char* member) { return statement.contains(member) && statement[member].is_string(); };
  if (!statement.is_object() || !is_text("_type") || !is_text("predicateType")) {
    throw Error(fmt::format("{}: is no certificate: `axiscert certify KERNEL` writes one", name));
  }
  if (statement["_type"] != statement_schema) {
    throw Error(fmt::format("{}: its _type is {}; a certificate is a Statement of in-toto, {}", name,
                            shown(statement["_type"].dump()), statement_schema));
  }
  const std::string type = statement["predicateType"];
  const std::string_view known = certificate_type;
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

Json with_digest(Json statement) {
  statement["predicate"]["digest"] = digest_without_itself(statement);
  return statement;
}

std::string certificate_text(const Json& statement, const SigningKey* key) {
  if (const auto fault = certificate_fault(statement))
    throw HarnessFault(fmt::format("the certificate does not conform to its schema: {}", *fault));
  std::string text = canonical_json(statement);
  return key == nullptr ? text + "\n" : envelope_text(signed_envelope(std::move(text), *key));
}

Certificate read_certificate(std::string_view bytes, const std::string& name) {
  Certificate read;
  std::string written(bytes);
  read.statement = strict_json(bytes, name, most_certificate_bytes);
  if (is_envelope(read.statement)) {
    read.envelope = read_envelope(read.statement, name);
    written = read.envelope->payload;
    read.statement = strict_json(written, name + ", the payload", most_certificate_bytes);
  } else if (written.ends_with('\n')) {
    written.pop_back();
  }
  require_kind(read.statement, name);
  const Json& statement = read.statement;
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
  if (const auto fault = certificate_fault(statement))
    throw Error(fmt::format("{}: does not conform to {}: {}", name, certificate_schema, *fault));
  return read;
}

Certificate read_certificate_file(const std::string& path) {
  std::ifstream file = open_file(path);
  std::string bytes(most_certificate_bytes + 1, '\0');
  bytes.resize(read_block(file, bytes, path));
  return read_certificate(bytes, path);
}

}  // namespace axiscert
