// For tests: the stored run whose `published` promises something else.
#pragma once

#include "reports/testing/test_run.h"

namespace axiscert {

// `published` promises nothing below this radius, and so many valid queries of each family are outside, of which three
// in five are contacts.
inline Json with_least_radius(double radius, std::uint64_t outside) {
  Json record = stored_record();
  Json& kernel = record["kernels"][0];
  kernel["limits"] = {{"least_coordinate", nullptr},
                      {"greatest_coordinate", nullptr},
                      {"least_area", nullptr},
                      {"least_radius", radius},
                      {"greatest_radius", nullptr}};
  for (Json& family : kernel["families"]) {
    family["verdict"]["outside_limits"] = {{"trials", outside}, {"false_separation", 0},      {"false_contact", 0},
                                           {"unanswered", 0},   {"contact", outside * 3 / 5}, {"touching", 0},
                                           {"deepest", 0.0}};
  }
  return record;
}

// `published` without any wrong answer.
inline Json without_errors(Json record) {
  for (Json& family : record["kernels"][0]["families"]) {
    Json& verdict = family["verdict"];
    for (const char* member : {"false_separation", "false_contact", "undecided", "invalid", "unanswered"})
      verdict[member] = 0;
    for (const char* member : {"deepest", "deepest_false_separation", "deepest_false_contact"}) verdict[member] = 0.0;
    for (Json& comparison : family["comparisons"]) {
      for (const char* member : {"false_separation", "missed_separation", "tolerance_failures"}) {
        if (!comparison[member].is_null()) comparison[member] = 0;
      }
    }
  }
  return record;
}

}  // namespace axiscert
