// What `axiscert prove` reports: which checkers said what of each bound.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "kernel/names.h"
#include "reports/instrument/data.h"

namespace axiscert {

struct ProofCheckersData {
  Name gappa, coq;

  AXISCERT_FIELDS(ProofCheckersData, AXISCERT_FIELD(gappa, "Which checks the bounds."),
                  AXISCERT_FIELD(coq, "Which checks the ranges that they assume."))
};

struct ProvedBoundData {
  Name comparison, kernel;
  Precision precision = Precision::binary32;
  Name domain;
  double bound_u = 0;
  std::optional<double> attained_u, ratio;
  Name status, file;

  AXISCERT_FIELDS(
      ProvedBoundData, AXISCERT_FIELD(comparison, "The comparison."),
      AXISCERT_FIELD(kernel, "The kernel, with +fma where products and sums are fused."),
      AXISCERT_FIELD(precision, "The precision."),
      AXISCERT_FIELD(domain, "scaled or absolute; docs/bounds.md defines both."),
      AXISCERT_FIELD(bound_u, "Upper bound on |(computed lhs - computed rhs) - (lhs - rhs)|, in u = 2^-24 or 2^-53.",
                     "u"),
      AXISCERT_FIELD(
          attained_u,
          "The greatest that a search attained on the domain, a lower bound of the worst; null: not searched.", "u"),
      AXISCERT_FIELD(ratio, "The ratio of bound_u to attained_u."),
      AXISCERT_FIELD(status,
                     "proved: Gappa accepts the script and Coq the ranges that it assumes. open: Gappa accepts it, and "
                     "its ranges have no proof in Coq. refused: a checker does not accept it. NOT CHECKED: a checker "
                     "that it needs was not run."),
      AXISCERT_FIELD(file, "The script, which --out writes under its folder."))
};

struct ProofsData : DataHead<ProofsData> {
  ProofCheckersData checkers;
  std::vector<ProvedBoundData> bounds;

  static constexpr std::string_view format = "axiscert-proofs/2",
                                    title = "What is proved of the rounding errors, and which checkers said so",
                                    about =
                                        "proofs.json, which `axiscert prove` writes. It depends on the scripts and on "
                                        "the checkers that are installed.";
  AXISCERT_FIELDS(
      ProofsData, base<Of, DataHead<Of>>(),
      AXISCERT_FIELD(
          checkers,
          "The first line of each checker's version, or NOT CHECKED where it is not installed or was not run."),
      AXISCERT_FIELD(bounds, "By kernel, precision, domain and comparison, in the order of the sixteen."))
};

}  // namespace axiscert
