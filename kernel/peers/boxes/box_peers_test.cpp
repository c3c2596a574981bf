// Requirements on every peer that is asked about two boxes: it describes itself, answers what is beyond doubt rightly,
// refuses numbers that are not a query, and keeps nothing from one query to the next. Beside them the faults that are
// known.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include "kernel/peers/boxes/box_pair.h"
#include "kernel/peers/peers_testing.h"

namespace axiscert::peer {
namespace {

// BOX_PEER_NAMES: the names of the peers that are built, separated by spaces.
std::vector<std::string> built_names() {
  std::istringstream all(BOX_PEER_NAMES);
  return {std::istream_iterator<std::string>(all), {}};
}
bool is_built(const std::string& name) {
  const std::vector<std::string> names = built_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<Vec3<double>, 3> upright = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Box<double> cube(const Vec3<double>& at, const std::array<Vec3<double>, 3>& axes = upright) {
  return {at, {1, 1, 1}, axes};
}

// Columns of Rz(z) Ry(y) Rx(x), angles in degrees.
std::array<Vec3<double>, 3> turned_by(double x, double y, double z) {
  const auto turn = [](double angle) {
    const double radians = angle * std::acos(-1.0) / 180;
    return std::pair{std::cos(radians), std::sin(radians)};
  };
  const auto [cx, sx] = turn(x);
  const auto [cy, sy] = turn(y);
  const auto [cz, sz] = turn(z);
  return {{{cz * cy, sz * cy, -sy},
           {cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx},
           {cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx}}};
}

// How deep two boxes overlap, or minus the greatest gap: the least over the fifteen directions, in double.
double penetration(const Boxes<double>& q) {
  using portable::cross, portable::dot;
  const Vec3<double> between = q.b.centre - q.a.centre;
  double least = INFINITY;
  const auto extent = [](const Box<double>& box, const Vec3<double>& d) {
    return box.half.x * std::abs(dot(d, box.axis[0])) + box.half.y * std::abs(dot(d, box.axis[1])) +
           box.half.z * std::abs(dot(d, box.axis[2]));
  };
  const auto along = [&](const Vec3<double>& d) {
    const double length = std::sqrt(dot(d, d));
    if (length < 1e-9) return;  // parallel edges
    least = std::min(least, (extent(q.a, d) + extent(q.b, d) - std::abs(dot(d, between))) / length);
  };
  for (const Vec3<double>& a : q.a.axis) {
    along(a);
    for (const Vec3<double>& b : q.b.axis) along(cross(a, b));
  }
  for (const Vec3<double>& b : q.b.axis) along(b);
  return least;
}

// A peer's answers, a letter each; none without a kernel of that precision.
template <class Real>
std::string ask_boxes(const std::string& name, const std::vector<Boxes<double>>& queries) {
  const Reply reply = in_peer("box-box/" + name, [&](AxiscertPlugin* plugin) -> std::string {
    const axiscert_kernel* kernel = nullptr;
    for (std::uint32_t i = 0; (kernel = plugin(i)) != nullptr && kernel->precision != 8 * sizeof(Real);) ++i;
    if (kernel == nullptr) return "";
    std::vector<std::vector<Real>> numbers(boxes_columns);
    for (const Boxes<double>& q : queries) {
      std::size_t k = 0;
      for (const Box<double>* box : {&q.a, &q.b}) {
        for (const Vec3<double>& v : {box->centre, box->half, box->axis[0], box->axis[1], box->axis[2]}) {
          for (const double x : {v.x, v.y, v.z}) numbers[k++].push_back(static_cast<Real>(x));
        }
      }
    }
    std::vector<const void*> columns;
    for (const auto& column : numbers) columns.push_back(column.data());
    std::vector<std::uint8_t> verdicts(queries.size(), 255);
    const axiscert_batch asked{sizeof asked, queries.size(), columns.size(), columns.data()};
    axiscert_answers answers{};
    answers.size = sizeof answers;
    answers.verdict = verdicts.data();
    kernel->run(&asked, &answers);
    std::string letters;
    for (const std::uint8_t verdict : verdicts) letters += letter_of(*kernel, verdict);
    return letters;
  });
  EXPECT_EQ(reply.signal, 0) << name;
  return reply.bytes;
}

// The measures that a peer gives of one query in double; none where it gives none, or no kernel in double.
std::vector<double> ask_numbers(const std::string& name, const Boxes<double>& q) {
  const Reply reply = in_peer("box-box/" + name, [&](AxiscertPlugin* plugin) -> std::string {
    const axiscert_kernel* kernel = plugin(1);
    if (kernel == nullptr) return "";
    std::vector<double> numbers;
    for (const Box<double>* box : {&q.a, &q.b}) {
      for (const Vec3<double>& v : {box->centre, box->half, box->axis[0], box->axis[1], box->axis[2]})
        numbers.insert(numbers.end(), {v.x, v.y, v.z});
    }
    std::vector<const void*> columns;
    for (const double& x : numbers) columns.push_back(&x);
    std::vector<double> given(kernel->measure_count);
    std::vector<void*> measures;
    for (double& x : given) measures.push_back(&x);
    std::uint8_t verdict = 255;
    const axiscert_batch asked{sizeof asked, 1, columns.size(), columns.data()};
    axiscert_answers answers{};
    answers.size = sizeof answers;
    answers.verdict = &verdict;
    answers.measure_count = given.size();
    answers.measure = measures.data();
    kernel->run(&asked, &answers);
    std::string text;
    for (const double x : given) text += fmt::format("{} ", x);
    return text;
  });
  EXPECT_EQ(reply.signal, 0) << name;
  std::istringstream words(reply.bytes);
  std::vector<double> found;
  for (std::string word; words >> word;) found.push_back(std::stod(word));
  return found;
}

class BoxPeer : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, BoxPeer, testing::ValuesIn(built_names()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(BoxPeer, SaysWhatItIs) {
  const Reply reply = in_peer("box-box/" + GetParam(), [](AxiscertPlugin* plugin) {
    std::string lines;
    for (std::uint32_t i = 0; const axiscert_kernel* k = plugin(i); ++i) {
      lines += fmt::format("{} {} {} {} columns {}\n", k->predicate, k->entry, k->name, k->precision, k->column_count);
    }
    return lines;
  });
  std::string right = fmt::format("box-box matrix {} 32 columns 30\n", GetParam());
  if (GetParam() != "bullet") right += fmt::format("box-box matrix {} 64 columns 30\n", GetParam());
  EXPECT_EQ(reply.bytes, right);
}

TEST_P(BoxPeer, AnswersWhatIsBeyondDoubt) {
  const auto tilted = turned_by(30, 40, 50), other = turned_by(-20, 10, 70);
  const std::vector<Boxes<double>> queries = {
      {cube({0, 0, 0}), cube({1.5, 0.25, 0.125})},           {cube({0, 0, 0}, tilted), cube({1, 0.5, 0.5}, other)},
      {cube({5, 5, 5}, tilted), cube({5, 5, 6.5}, upright)}, {cube({0, 0, 0}), cube({2.5, 0, 0})},
      {cube({0, 0, 0}, tilted), cube({3, 3, 0}, other)},
  };
  // With CONTACTS_UNIMPORTANT contacts are missed at will.
  if (GetParam() == "ode-unimportant") return;
  EXPECT_EQ(ask_boxes<float>(GetParam(), queries), "cccss");
  if (GetParam() != "bullet") {
    EXPECT_EQ(ask_boxes<double>(GetParam(), queries), "cccss");
  }
}

TEST_P(BoxPeer, RefusesNumbersThatAreNotAQueryOrNotARotation) {
  std::vector<Boxes<double>> queries(4, {cube({0, 0, 0}), cube({1.5, 0.25, 0.125})});
  queries[0].a.half.y = -1;
  queries[1].b.centre.x = NAN;
  queries[2].b.axis[1] = {0.5, 1, 0};
  queries[3].b.axis[2] = {0, 0, -1};  // of the other handedness: the same cube
  EXPECT_EQ(ask_boxes<float>(GetParam(), queries).substr(0, 3), "iiu");
  if (GetParam() != "ode-unimportant") {
    EXPECT_EQ(ask_boxes<float>(GetParam(), queries).back(), 'c');
  }
}

// One convention for all: the depth as a negative separation, the normal in which B is pushed, and a point of each box.
TEST_P(BoxPeer, TurnsItsNumbersToOneConvention) {
  // Along the first axis, at which CONTACTS_UNIMPORTANT stops.
  const Boxes<double> q{cube({0, 0, 0}), cube({1.875, 0.5, 0.25})};
  const std::vector<double> found = ask_numbers(GetParam(), q);
  if (found.empty()) return;
  EXPECT_TRUE(found.size() == 4 || found.size() == 10) << found.size();
  // MuJoCo's depth of two faces is half of what it is: below.
  if (GetParam() != "mujoco") {
    EXPECT_NEAR(found[0], -0.125, 1e-6);
  }
  EXPECT_NEAR(found[1], 1, 1e-6);
  EXPECT_NEAR(found[2], 0, 1e-6);
  EXPECT_NEAR(found[3], 0, 1e-6);
  if (found.size() != 10 || GetParam() == "mujoco") return;
  EXPECT_NEAR(found[4], 1, 1e-6) << "the right of A";
  EXPECT_NEAR(found[7], 0.875, 1e-6) << "the left of B";
}

// MuJoCo 2.2.2 says half of the depth where a face decides, in the middle of both surfaces, and the whole of it where
// two edges do.
TEST(BoxPeerFaults, MujocoHalvesTheDepthOfFaces) {
  if (!is_built("mujoco")) return;
  const std::vector<double> faces = ask_numbers("mujoco", {cube({0, 0, 0}), cube({0.5, 0.25, 1.875})});
  EXPECT_NEAR(faces[0], -0.0625, 1e-12);
  EXPECT_NEAR(faces[6], 0.96875, 1e-12);
  EXPECT_NEAR(faces[9], 0.90625, 1e-12);
  const std::vector<double> edges =
      ask_numbers("mujoco", {cube({0, 0, 0}, turned_by(45, 0, 0)), cube({0.1, 0.2, 2.5}, turned_by(0, 45, 0))});
  EXPECT_NEAR(edges[0], 2.5 - 2 * std::sqrt(2.0), 1e-9);
}

// Two unit cubes, one a quarter turn further than the other, overlapping by 0.985: ODE finds no contact, and of the two
// that have ODE's own algorithm with an epsilon each finds one.
TEST(BoxPeerFaults, OdeMissesCubesThatDifferByAQuarterTurn) {
  const std::vector<Boxes<double>> queries = {
      {cube({0, 0, 0}, turned_by(65, 20, 10)), cube({0.5, 1, -0.75}, turned_by(155, 20, 10))}};
  if (is_built("ode")) {
    EXPECT_EQ(ask_boxes<double>("ode", queries), "s");
  }
  if (is_built("ode-touches")) {
    EXPECT_EQ(ask_boxes<double>("ode-touches", queries), "s");
  }
  if (is_built("fcl")) {
    EXPECT_EQ(ask_boxes<double>("fcl", queries), "c");
  }
  if (is_built("bullet-double")) {
    EXPECT_EQ(ask_boxes<double>("bullet-double", queries), "c");
  }
}

// Two unit cubes turned by whole degrees, Rz(z) Ry(y) Rx(x), one of them by up to three quarter turns more about its
// own first axis, their centres apart by multiples of a quarter: of the contacts that are beyond doubt ODE misses some,
// as docs/boxes.md says. The truth is by the fifteen axes in double, with a margin of 1e-6.
TEST(BoxPeerFaultsLong, OdeMissesContactsOfCubesTurnedByWholeDegrees) {
  if (!is_built("ode") || !is_built("fcl")) return;
  std::mt19937_64 random(20261124);
  const auto whole = [&](int below) { return static_cast<double>(random() % static_cast<unsigned>(below)); };
  std::vector<Boxes<double>> queries;
  for (int i = 0; i < 4000; ++i) {
    const double x = whole(360), y = whole(360), z = whole(360), more = 90 * whole(4);
    const Vec3<double> at{whole(17) / 4 - 2, whole(17) / 4 - 2, whole(17) / 4 - 2};
    queries.push_back({cube({0, 0, 0}, turned_by(x, y, z)), cube(at, turned_by(x + more, y, z))});
  }
  const std::string ode = ask_boxes<double>("ode", queries), touches = ask_boxes<double>("ode-touches", queries);
  int contacts = 0, missed = 0, by_axes = 0;
  double deepest = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double depth = penetration(queries[i]);
    if (depth < 1e-6) continue;
    ++contacts;
    missed += ode[i] == 's';
    by_axes += touches[i] == 's';
    if (ode[i] == 's') deepest = std::max(deepest, depth);
  }
  const std::string line =
      fmt::format("{} of {} contacts, the deepest of {:.3f} of a half extent, {} of them by its axes", missed, contacts,
                  deepest, by_axes);
  std::ifstream page(SOURCE_FOLDER "/docs/boxes.md");
  const std::string text((std::istreambuf_iterator<char>(page)), {});
  EXPECT_NE(text.find(line), text.npos) << "docs/boxes.md lacks: " << line;
}

}  // namespace
}  // namespace axiscert::peer
