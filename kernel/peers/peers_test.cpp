// Requirements on every peer: it describes itself, answers clear queries rightly, refuses invalid ones, and keeps
// nothing from one query to the next. The faults of each library are in faults_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

#include "kernel/peers/peers_testing.h"
#include "kernel/queries_testing.h"

namespace axiscert::peer {
namespace {

struct ExpectedPeer {
  const char* name;
  bool has_binary64;
  axiscert_touching touching;
  std::size_t measures;  // that it gives
  char centre_on_triangle = 'c';
  bool may_decline = false;
};
void PrintTo(const ExpectedPeer& peer, std::ostream* out) { *out << peer.name; }

constexpr axiscert_touching contact = AXISCERT_TOUCHING_IS_CONTACT, separated = AXISCERT_TOUCHING_IS_SEPARATED,
                            either = AXISCERT_TOUCHING_IS_EITHER;
constexpr ExpectedPeer expected[] = {
    {"bullet", false, separated, 8},
    {"bullet-double", true, separated, 8},
    {"bullet-gjk", false, contact, 8},
    {"ode", true, contact, 8, 'i', true},  // a depth of NaN; declines where ODE does not start
    {"fcl", true, either, 8},
    {"fcl-float", false, either, 8},
    {"fcl-gjk", true, either, 5},
    {"libccd-gjk", true, either, 5},
    {"libccd-mpr", true, either, 5},
    {"cgal-float", false, contact, 1},
    {"cgal-double", true, contact, 1},
    {"cgal-epick", true, contact, 0},
};

class Peer : public testing::TestWithParam<ExpectedPeer> {
 protected:
  // Checks the peer's letters for the queries, in both precisions if it has both.
  static void expect(const std::vector<Query<float>>& queries, const std::string& letters) {
    const Reply narrow = ask(GetParam().name, queries);
    EXPECT_EQ(narrow.signal, 0);
    EXPECT_EQ(narrow.bytes, letters) << "binary32";
    std::vector<Query<double>> wide;
    for (const Query<float>& q : queries) wide.push_back(widened(q));
    const Reply reply = ask(GetParam().name, wide);
    EXPECT_EQ(reply.signal, 0);
    EXPECT_EQ(reply.bytes, GetParam().has_binary64 ? letters : "-") << "binary64";
  }
};

// PEER_NAMES: the names of the peers that are built, separated by spaces.
std::vector<std::string> built_names() {
  std::istringstream all(PEER_NAMES);
  return {std::istream_iterator<std::string>(all), {}};
}
std::vector<ExpectedPeer> built() {
  std::vector<ExpectedPeer> rows;
  for (const std::string& name : built_names()) {
    for (const ExpectedPeer& row : expected) {
      if (row.name == name) rows.push_back(row);
    }
  }
  return rows;
}
TEST(Peers, EachBuiltOneIsTested) {
  for (const std::string& name : built_names()) {
    const bool has_row = std::any_of(std::begin(expected), std::end(expected),
                                     [&](const ExpectedPeer& row) { return row.name == name; });
    EXPECT_TRUE(has_row) << "kernel peer/" << name << " has no row in kernel/peers/peers_test.cpp, table `expected`";
  }
}

INSTANTIATE_TEST_SUITE_P(All, Peer, testing::ValuesIn(built()), [](const auto& parameter) {
  std::string name = parameter.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// A triangle with a right angle at the origin and legs of length 4.
Query<float> sphere(float x, float y, float z, float r) { return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {x, y, z}, r}; }

TEST_P(Peer, SaysWhatItIs) {
  const ExpectedPeer& peer = GetParam();
  const auto line = [](const axiscert_kernel& k) {
    return fmt::format("abi {} precision {} {} exposes {} touching {} declines {} summary {} claims {} limits {}\n",
                       k.abi, k.precision, k.name, k.exposes, k.touching, k.may_decline, k.summary != nullptr,
                       k.conforms_to != nullptr || k.formulae != nullptr, k.limits != nullptr);
  };
  const Reply reply = in_peer(peer.name, [&](AxiscertPlugin* plugin) {
    std::string lines;
    for (std::uint32_t i = 0; const axiscert_kernel* k = plugin(i); ++i) lines += line(*k);
    return lines;
  });
  std::string right;
  for (const int precision : {32, 64}) {
    if (precision == 64 && !peer.has_binary64) continue;
    right += fmt::format(
        "abi {} precision {} {} exposes 0 touching {} declines {} summary true claims false limits false\n",
        AXISCERT_PLUGIN_ABI, precision, peer.name, static_cast<int>(peer.touching), peer.may_decline ? 1 : 0);
  }
  EXPECT_EQ(reply.bytes, right);
}

TEST_P(Peer, AnswersWhatIsBeyondDoubtInEveryVertexOrder) {
  const Query<float> contacts[] = {
      sphere(1, 1, 0.5f, 1),      sphere(1, 1, -0.5f, 1),    // the face, from both sides
      sphere(2, -0.5f, 0, 1),     sphere(2.5f, 2.5f, 0, 1),  // edges
      sphere(-0.3f, -0.4f, 0, 1),                            // a vertex
      sphere(1, 1, 0.25f, 100),                              // the whole triangle inside the sphere
      sphere(1, 1, 0.01f, 0.1f),                             // the sphere's whole section inside the triangle
  };
  const Query<float> separations[] = {sphere(1, 1, 3, 1),    sphere(1, 1, -3, 1),  sphere(2, -2, 0, 1),
                                      sphere(3, 3, 1, 1),    sphere(-3, -4, 0, 4), sphere(9, 0, 0, 4),
                                      sphere(1, 1, 3, -0.0f)};
  std::vector<Query<float>> queries;
  std::string letters;
  const auto add = [&](const Query<float>& q, char letter) {
    testing_support::for_each_vertex_order(q, [&](const Query<float>& turned, std::string_view) {
      queries.push_back(turned);
      letters += letter;
    });
  };
  for (const Query<float>& q : contacts) add(q, 'c');
  for (const Query<float>& q : separations) add(q, 's');
  expect(queries, letters);
}

// One convention for all: the depth as a negative separation, no feature, the normal that pushes the sphere, and the
// triangle's point.
TEST_P(Peer, TurnsItsNumbersToOneConvention) {
  struct Right {
    Query<float> q;
    double separation;
    std::array<double, 3> normal, point;
  };
  const Right all[] = {{sphere(1, 1, 0.5f, 1), -0.5, {0, 0, 1}, {1, 1, 0}},
                       {sphere(1, 1, -0.5f, 1), -0.5, {0, 0, -1}, {1, 1, 0}},
                       {sphere(2, -0.5f, 0, 1), -0.5, {0, -1, 0}, {2, 0, 0}},
                       {sphere(-0.375f, -0.5f, 0, 1), -0.375, {-0.6, -0.8, 0}, {0, 0, 0}}};
  const std::string name = GetParam().name;
  // Iterations end at a tolerance, and MPR says a depth that need not be the least.
  const double slack = name.starts_with("libccd") || name == "fcl-gjk" ? 0.1 : 1e-3;
  for (const Right& right : all) {
    const std::vector<double> found = ask_numbers(GetParam().name, right.q);
    ASSERT_EQ(found.size(), GetParam().measures);
    if (found.empty()) return;
    if (name == "ode" && right.point[2] == right.q.p.z) continue;  // beside an edge: in faults_test.cpp
    EXPECT_NEAR(found[0], right.separation, slack);
    if (found.size() < 5) continue;
    EXPECT_TRUE(std::isnan(found[1]));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(found[2 + k], right.normal[k], slack);
      if (found.size() == 8) {
        EXPECT_NEAR(found[5 + k], right.point[k], slack);
      }
    }
  }
}

TEST_P(Peer, CentreOnTheTriangle) {
  expect({sphere(1, 1, 0, 0.5f), sphere(2, 0, 0, 0.5f), sphere(0, 0, 0, 0.5f)},
         std::string(3, GetParam().centre_on_triangle));
}

TEST_P(Peer, WhatIsNoQueryIsInvalid) {
  using Limits = std::numeric_limits<float>;
  std::vector<Query<float>> queries;
  for (const float bad : {Limits::quiet_NaN(), Limits::signaling_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (std::size_t k = 0; k < coordinate_count; ++k) {
      auto v = coordinates(sphere(1, 1, 0.5f, 1));
      v[k] = bad;
      queries.push_back(from_coordinates(v));
    }
  }
  queries.push_back(sphere(1, 1, 0.5f, -1));
  queries.push_back(sphere(1, 1, 0.5f, -Limits::denorm_min()));
  expect(queries, std::string(queries.size(), 'i'));
}

// Distances that every precision represents exactly. A peer that makes no promise about touching must give both answers
// here.
TEST_P(Peer, TouchingIsWhatItSays) {
  std::vector<Query<float>> touching = {sphere(1, 1, 1, 1),  sphere(1, 1, 4, 4),   sphere(2, -1, 0, 1),
                                        sphere(2, -4, 0, 4), sphere(-3, -4, 0, 5), sphere(9, 0, 0, 5)};
  if (GetParam().centre_on_triangle == 'c') touching.push_back(sphere(1, 1, 0, 0));
  if (GetParam().touching != either) {
    expect(touching, std::string(touching.size(), GetParam().touching == contact ? 'c' : 's'));
    return;
  }
  const std::string letters = ask(GetParam().name, touching).bytes;
  EXPECT_NE(letters.find('c'), letters.npos) << letters;
  EXPECT_NE(letters.find('s'), letters.npos) << letters;
}

TEST_P(Peer, AnAnswerDependsOnItsQueryAlone) {
  const Query<float> mixed[] = {
      sphere(1, 1, 0.5f, 1),
      sphere(1, 1, 3, 1),
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0.5f, 0}, 1},  // three vertices on a line
      {{1e-9f, 0, 0}, {0, 1e-9f, 0}, {0, 0, 1e-9f}, {0, 0, 0}, 1e-9f},
      sphere(1, 1, std::numeric_limits<float>::infinity(), 1),
      {{5e8f, 0, 0}, {0, 5e8f, 0}, {0, 0, 5e8f}, {0, 0, 0}, 1e8f},
      sphere(3, 3, 1, 1.73206f),
      {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 50, 0}, 1},  // one vertex three times
  };
  std::string alone;
  for (const Query<float>& q : mixed) alone += ask<float>(GetParam().name, {q}).bytes;
  // Each query after each other query.
  std::vector<Query<float>> queries;
  std::string letters;
  for (std::size_t i = 0; i < std::size(mixed); ++i) {
    for (std::size_t k = 0; k < std::size(mixed); ++k) {
      for (const std::size_t place : {i, k}) {
        queries.push_back(mixed[place]);
        letters += alone[place];
      }
    }
  }
  EXPECT_EQ(ask(GetParam().name, queries).bytes, letters);
}

}  // namespace
}  // namespace axiscert::peer
