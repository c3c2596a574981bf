#include "fuzz/campaign/parts/fault_message.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "exact/judge/truth.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

using Cbor = nlohmann::json;

Cbor fault_json(const std::exception_ptr& fault) {
  try {
    std::rethrow_exception(fault);
  } catch (const OracleDisagreement& d) {
    return {"disagreement", d.what(), d.precision, d.query, d.predicate->id, d.entry};
  } catch (const HarnessFault& f) {
    return {"harness", f.what()};
  } catch (const Error& e) {
    return {"input", e.what()};
  } catch (const std::exception& e) {
    return {"other", e.what()};
  }
}

}  // namespace

std::string fault_message(const std::exception_ptr& fault) {
  std::string bytes;
  Cbor::to_cbor(fault_json(fault), bytes);
  return bytes;
}

void rethrow_fault(std::string_view message, int rank) {
  const Cbor json = Cbor::from_cbor(message);
  const auto kind = json.at(0).get<std::string>(), what = json.at(1).get<std::string>();
  if (kind == "disagreement") {
    OracleDisagreement disagreement("", Numbers<float>(), find_predicate(json.at(4).get<std::string>()));
    json.at(5).get_to(disagreement.entry);
    disagreement.precision = json.at(2).get<Precision>();
    json.at(3).get_to(disagreement.query);
    static_cast<HarnessFault&>(disagreement) = HarnessFault(what);
    throw disagreement;
  }
  if (kind == "harness") throw HarnessFault(what);
  if (kind == "input") throw Error(what);
  throw std::runtime_error(fmt::format("rank {}: {}", rank, what));
}

}  // namespace axiscert
