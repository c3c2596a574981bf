#include "fuzz/text/json.h"
#include "reports/formats/schemas.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/diagnosis/diagnosis.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Schemas, EachIsOfTheFormatOfItsName) {
  for (const SchemaEntry& entry : schemas()) {
    const Json schema = schema_named(entry.name);
    // The format of a certificate is that of its predicate.
    const Json& members = schema.at("properties");
    const Json& file = members.contains("predicateType") ? members.at("predicate").at("properties") : members;
    // A line of a corpus names none.
    if (entry.name != "corpus") {
      EXPECT_THAT(file.at("schema").at("const").get<std::string>(),
                  StartsWith(fmt::format("axiscert-{}/", entry.name == "ratchet" ? "held" : entry.name)));
    }
    EXPECT_FALSE(schema.at("title").get<std::string>().empty());
    EXPECT_FALSE(schema.at("description").get<std::string>().empty());
  }
}

TEST(Schemas, AnotherNameIsToldWhichThereAre) {
  try {
    schema_named("laddr");
    ADD_FAILURE() << "there is none of that name";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("ladder"));
  }
}

TEST(Schemas, OfADiagnosisHasTheValuesOfEachProperty) {
  const Json schema = schema_named("diagnosis");
  const Json& property = schema.at("properties").at("properties").at("items");
  const Json& names = property.at("properties").at("name").at("enum");
  ASSERT_EQ(names.size(), property_kinds().size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const PropertyKind& kind = property_kinds()[i];
    EXPECT_EQ(names[i], kind.name);
    const Json& alternative = property.at("anyOf").at(i + 1).at("properties");
    EXPECT_EQ(alternative.at("name").at("const"), kind.name);
    EXPECT_EQ(alternative.contains("value"), !kind.values.empty()) << kind.name;
    if (kind.values.empty()) continue;
    EXPECT_EQ(alternative.at("value").at("enum"), Json(kind.values)) << kind.name;
  }
}

}  // namespace
}  // namespace axiscert
