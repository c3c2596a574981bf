// Requirements on every peer that is asked about a sphere that moves: it describes itself, answers what is beyond doubt
// rightly, with a time, normal and point where it gives them, refuses what is no query, and keeps nothing from one
// query to the next. The faults of each library are in sweep_faults_test.cpp.
#include <fmt/format.h>

#include <iterator>
#include <sstream>

#include "kernel/peers/moving_sphere/sweeps_testing.h"

namespace axiscert::peer {
namespace {

using Vector = Vec3<float>;

struct ExpectedSweeps {
  const char* name;
  bool has_binary64;
  std::size_t measures;
  const char* clear = "cccc";  // its answers to clear_contacts; 's' is a known fault
  double time_error = 2e-3;    // of the way; a library that samples is late by a step
  axiscert_start start = AXISCERT_START_IS_REPORTED;
};
void PrintTo(const ExpectedSweeps& sweeps, std::ostream* out) { *out << sweeps.name; }

constexpr ExpectedSweeps expected_sweeps[] = {
    {"bullet-subsimplex", false, 8, "cccc", 2e-3, AXISCERT_START_IS_IGNORED},
    {"bullet-continuous", false, 8},
    {"bullet-gjk-cast", false, 8},
    {"bullet-world", false, 8},
    {"fcl-continuous", true, 1, "cccc", 1.0 / 9},
    {"fcl-advance-rss", true, 1, "scss", 1.0 / 3},
    {"fcl-advance-obbrss", true, 1, "ssss"},
    {"ode-capsule", true, 0, "cccs"},
    {"libccd-capsule", true, 0},
    {"wildmagic", true, 1},
    {"wildmagic-float", false, 1},
};

// SWEEP_NAMES: the names of the peers that are built, separated by spaces.
std::vector<std::string> built_sweep_names() {
  std::istringstream all(SWEEP_NAMES);
  return {std::istream_iterator<std::string>(all), {}};
}
std::vector<ExpectedSweeps> built_sweeps() {
  std::vector<ExpectedSweeps> rows;
  for (const std::string& name : built_sweep_names()) {
    for (const ExpectedSweeps& row : expected_sweeps) {
      if (row.name == name) rows.push_back(row);
    }
  }
  return rows;
}

TEST(Sweeps, EachBuiltPeerIsTested) {
  EXPECT_EQ(built_sweeps().size(), built_sweep_names().size())
      << "a peer of " SWEEP_NAMES " has no row in kernel/peers/moving_sphere/sweeps_test.cpp, table `expected_sweeps`";
}

class SweepPeer : public testing::TestWithParam<ExpectedSweeps> {};
INSTANTIATE_TEST_SUITE_P(All, SweepPeer, testing::ValuesIn(built_sweeps()), [](const auto& parameter) {
  std::string name = parameter.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(SweepPeer, SaysWhatItIs) {
  const ExpectedSweeps& peer = GetParam();
  const Reply reply = in_peer(fmt::format("moving-sphere/{}", peer.name), [](AxiscertPlugin* plugin) {
    std::string lines;
    for (std::uint32_t i = 0; const axiscert_kernel* k = plugin(i); ++i) {
      lines += fmt::format("{} {} {} columns {} measures {} touching {} start {}\n", k->predicate, k->name,
                           k->precision, k->column_count, k->measure_count, k->touching, k->start);
    }
    return lines;
  });
  std::string right;
  for (const int precision : {32, 64}) {
    if (precision == 64 && !peer.has_binary64) continue;
    right += fmt::format("moving-sphere {} {} columns 16 measures {} touching {} start {}\n", peer.name, precision,
                         peer.measures, static_cast<int>(AXISCERT_TOUCHING_IS_EITHER), static_cast<int>(peer.start));
  }
  EXPECT_EQ(reply.bytes, right);
}

// With 0.3 of depth and more, over 0.6 of the way and more, so that those that sample see it too.
const Sweep<float> clear_contacts[] = {
    motion<float>({1, 1, 3}, {0, 0, -4}, 1),          // the face, from its two sides
    motion<float>({1, 1, -3}, {0, 0, 4}, 1),          //
    motion<float>({2, -3, 0.5f}, {0, 4, -0.25f}, 1),  // an edge
    motion<float>({-3, -4, 0.5f}, {3, 4, -0.5f}, 1),  // a vertex
};
const double clear_times[] = {0.5, 0.5, 0.5178, 0.801};
const Sweep<float> clear_separations[] = {
    motion<float>({1, 1, 3}, {0, 0, 4}, 1), motion<float>({1, 1, 3}, {0, 0, -1}, 1),
    motion<float>({2, -3, 0}, {8, 0, 0}, 1), motion<float>({6, 5, 1}, {1, 1, -1}, 1)};

TEST_P(SweepPeer, AnswersWhatIsBeyondDoubt) {
  std::vector<Sweep<float>> narrow(std::begin(clear_contacts), std::end(clear_contacts));
  narrow.insert(narrow.end(), std::begin(clear_separations), std::end(clear_separations));
  const auto answers = ask_sweeps(GetParam().name, narrow);
  const std::string right = std::string(GetParam().clear) + "ssss";
  EXPECT_EQ(letters_of(answers), right);
  std::vector<Sweep<double>> wide;
  const auto widened = [](const Vector& v) { return Vec3<double>{v.x, v.y, v.z}; };
  for (const Sweep<float>& q : narrow)
    wide.push_back({widened(q.a), widened(q.b), widened(q.c), widened(q.p), widened(q.d), q.r});
  EXPECT_EQ(letters_of(ask_sweeps(GetParam().name, wide)), GetParam().has_binary64 ? right : "");
}

TEST_P(SweepPeer, AContactComesWithItsTimeNormalAndPoint) {
  const auto answers =
      ask_sweeps(GetParam().name, std::vector<Sweep<float>>(std::begin(clear_contacts), std::end(clear_contacts)));
  ASSERT_EQ(answers.size(), std::size(clear_contacts));
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::vector<double>& said = answers[i].measures;
    const bool is_contact = answers[i].letter == 'c';
    for (std::size_t k = 0; k < said.size(); ++k) {
      const bool gives = is_contact && k != 1 && k < GetParam().measures;  // no library names the feature
      EXPECT_EQ(std::isnan(said[k]), !gives) << "query " << i << ", measure " << k;
    }
    if (!is_contact || GetParam().measures == 0) continue;
    EXPECT_NEAR(said[0], clear_times[i], GetParam().time_error) << "query " << i;
    if (GetParam().measures == 1) continue;
    // From the point the normal leads to the centre, r away.
    const Sweep<float>& q = clear_contacts[i];
    const double centre[] = {q.p.x + said[0] * q.d.x, q.p.y + said[0] * q.d.y, q.p.z + said[0] * q.d.z};
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(said[5 + k] + q.r * said[2 + k], centre[k], 4e-2) << "query " << i;
  }
}

TEST_P(SweepPeer, WhatIsNoQueryIsInvalid) {
  using Limits = std::numeric_limits<float>;
  std::vector<Sweep<float>> queries;
  for (const float bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (Vector Sweep<float>::*member :
         {&Sweep<float>::a, &Sweep<float>::b, &Sweep<float>::c, &Sweep<float>::p, &Sweep<float>::d}) {
      for (float Vector::*axis : {&Vector::x, &Vector::y, &Vector::z}) {
        queries.push_back(clear_contacts[0]);
        queries.back().*member.*axis = bad;
      }
    }
    queries.push_back(motion<float>({1, 1, 3}, {0, 0, -4}, bad));
  }
  queries.push_back(motion<float>({1, 1, 3}, {0, 0, -4}, -1));
  EXPECT_EQ(letters_of(ask_sweeps(GetParam().name, queries)), std::string(queries.size(), 'i'));
}

TEST_P(SweepPeer, AnAnswerDependsOnItsQueryAlone) {
  std::vector<Sweep<float>> mixed(std::begin(clear_contacts), std::end(clear_contacts));
  mixed.push_back(clear_separations[0]);
  mixed.push_back({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 3, 0}, {0, -4, 0}, 1});  // three vertices on a line
  mixed.push_back(motion<float>({1, 1, 0.5f}, {0, 0, 0}, 1));
  mixed.push_back(motion<float>({1, 1, std::numeric_limits<float>::infinity()}, {0, 0, 0}, 1));
  std::string alone, both;
  for (const Sweep<float>& q : mixed) alone += letters_of(ask_sweeps<float>(GetParam().name, {q}));
  ASSERT_EQ(alone.size(), mixed.size());
  std::vector<Sweep<float>> queries;
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    for (std::size_t k = 0; k < mixed.size(); ++k) {
      queries.insert(queries.end(), {mixed[i], mixed[k]});
      both += alone[i];
      both += alone[k];
    }
  }
  EXPECT_EQ(letters_of(ask_sweeps(GetParam().name, queries)), both);
}

}  // namespace
}  // namespace axiscert::peer
