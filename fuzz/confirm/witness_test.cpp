// The exact contact beside a witness is read again as it was written, however large the numbers of its query are.
#include "fuzz/confirm/witness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/judge/oracles.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json_form.h"

namespace axiscert {
namespace {

TEST(Witness, ContactsBeyondBinary64AreReadAgain) {
  const Oracles& oracles = oracles_of(box_box_predicate());
  const Family& family = find_family("box-box/bits");
  int beyond = 0;
  for (std::uint64_t i = 0; i < 128; ++i) {
    const auto query = family.make<double>(1, i);
    const auto contact = exact_contact_of(oracles, oracles.truth(query), query);
    if (!contact) continue;
    EXPECT_EQ(json_of(read_as<ExactContactRecord>(json_of(*contact))), json_of(*contact)) << "position " << i;
    beyond += !contact->point;
  }
  EXPECT_GT(beyond, 0);
}

}  // namespace
}  // namespace axiscert
