// replay_answers FILE: asks libaxiscert the queries that write_certified_answers stored, through every function of the
// C interface, with every question, in every floating-point mode, on each instruction set of this machine, and prints
// where an answer differs from the stored one. It needs the library and Highway but no oracle, so it also runs on
// processors for which nothing else of axiscert is built.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <numeric>

#include "kernel/include/axiscert/certified.hpp"
#include "kernel/sphere_triangle/certified/tests/stored_answers.h"
#include "kernel/base/environment.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // as the library is
#include "hwy/highway.h"

namespace axiscert::certified {
namespace {

constexpr axiscert_question questions[] = {AXISCERT_CLOSED_SPHERE, AXISCERT_OPEN_SPHERE, AXISCERT_CONSERVATIVE};

// Modes that callers may set, for a scope: the default modes, each rounding direction with subnormal numbers flushed or
// not, and everything else that the processor has: traps, and on ARM default NaNs and the alternative half-precision
// format.
class CallersModes {
 public:
  static constexpr int count = 9;
  explicit CallersModes(int which) : scope_(static_cast<Rounding>(which % 4), which >= 4) {
    std::feclearexcept(FE_ALL_EXCEPT);
    is_default_ = which == 0;
    has_everything_ = which == 8;
    if (has_everything_) set_everything();
    before_ = modes();
  }
  // To be called before any arithmetic in the scope.
  bool are_as_they_were() const { return modes() == before_ && (is_default_ || std::fetestexcept(FE_ALL_EXCEPT) == 0); }
  ~CallersModes() {
    if (has_everything_) restore();
  }

 private:
#if defined(__SSE2__)
  static std::uint64_t modes() { return _mm_getcsr() & ~0x3fu; }
  void set_everything() {
    scope_control_ = _mm_getcsr();
    _mm_setcsr(0x8040 | 0x4000);  // FTZ and DAZ, upward, no exception masked
  }
  void restore() { _mm_setcsr(static_cast<unsigned>(scope_control_)); }
#else
  static std::uint64_t modes() { return FloatingEnvironment::control(); }
  void set_everything() {
    scope_control_ = modes();
    asm volatile("msr fpcr, %0" ::"r"(std::uint64_t{0x07409f00}) : "memory");  // AHP, DN, FZ, upward, traps
  }
  void restore() { asm volatile("msr fpcr, %0" ::"r"(scope_control_) : "memory"); }
#endif

  FloatingEnvironment scope_;
  std::uint64_t scope_control_ = 0, before_ = 0;
  bool is_default_ = false, has_everything_ = false;
};

struct Count {
  std::uint64_t asked = 0, wrong = 0;
};

template <class Real>
class Replay {
 public:
  Replay(const StoredAnswers<Real>& stored, const char* target, Count& count)
      : stored_(stored), target_(target), count_(count) {}

  void run() {
    for (question_ = 0; question_ < 3; ++question_) {
      expected_.resize(stored_.size());
      for (std::size_t i = 0; i < stored_.size(); ++i) expected_[i] = expected(i);
      for (mode_ = 0; mode_ < CallersModes::count; ++mode_) {
        all_pairs();
        if (stored_.group == 1) one_pair_at_a_time();
        else one_sphere_each();
      }
    }
  }

 private:
  std::uint8_t expected(std::size_t i) const {
    if (stored_.order[i] == invalid_order) return AXISCERT_INVALID;
    if (questions[question_] == AXISCERT_CONSERVATIVE) return stored_.conservative[i];
    const bool contact = questions[question_] == AXISCERT_OPEN_SPHERE ? stored_.order[i] < 0 : stored_.order[i] <= 0;
    return contact ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
  }

  void fail(const char* shape, std::size_t i, int found) {
    if (++count_.wrong > 20) return;
    std::printf("%s, %s, %s, binary%zu, question %d, mode %d, query %zu: %d and not %d:", target_, shape,
                stored_.name.c_str(), 8 * sizeof(Real), question_, mode_, i, found, expected_[i]);
    for (const auto& column : stored_.column) std::printf(" %a", static_cast<double>(column[i]));
    std::printf("\n");
  }

  // Calls ask(results) in the mode, and compares the results with those expected for queries first to first + size - 1.
  // name(i) is the number that stands for the i-th of them among the hits.
  template <class Ask, class Name>
  void check(const char* shape, std::size_t first, std::size_t size, Ask&& ask, Name&& name) {
    verdict_.assign(size + 1, 99);
    bits_.assign(size / 64 + 2, 99);
    hits_.assign(size + 1, 99);
    const axiscert_results results{verdict_.data(), bits_.data(), hits_.data()};
    axiscert_counts counts;
    bool are_as_they_were;
    {
      const CallersModes modes(mode_);
      counts = ask(results);
      are_as_they_were = modes.are_as_they_were();
    }
    if (!are_as_they_were) fail("floating-point modes", first, -1);
    count_.asked += size;
    std::size_t contacts = 0, invalids = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint8_t right = expected_[first + i];
      const bool contact = right == AXISCERT_CONTACT;
      if (verdict_[i] != right) fail(shape, first + i, verdict_[i]);
      if (((bits_[i / 64] >> (i % 64)) & 1u) != (contact ? 1u : 0u)) fail("a bit", first + i, contact ? 0 : 1);
      if (contact && hits_[contacts++] != name(i)) fail("a hit", first + i, static_cast<int>(hits_[contacts - 1]));
      if (right == AXISCERT_INVALID) ++invalids;
    }
    if (counts.contacts != contacts || counts.invalid != invalids) fail("the counts", first, -1);
    if (verdict_[size] != 99 || bits_[(size + 63) / 64] != 99) fail("an array's end", first, -1);
  }

  void all_pairs() {
    std::array<const Real*, 13> columns;
    for (std::size_t k = 0; k < 13; ++k) columns[k] = stored_.column[k].data();
    check(
        "pairs", 0, stored_.size(),
        [&](const axiscert_results& to) { return pairs(columns, stored_.size(), questions[question_], to); },
        [](std::size_t i) { return i; });
  }

  void one_pair_at_a_time() {
    for (std::size_t i = 0; i < stored_.size(); ++i) {
      Real v[13];
      for (std::size_t k = 0; k < 13; ++k) v[k] = stored_.column[k][i];
      int found;
      bool are_as_they_were;
      {
        const CallersModes modes(mode_);
        found = pair(v, v + 9, questions[question_]);
        are_as_they_were = modes.are_as_they_were();
      }
      ++count_.asked;
      if (found != expected_[i]) fail("pair", i, found);
      if (!are_as_they_were) fail("floating-point modes", i, -1);
    }
  }

  // A sphere against its triangles, as columns and as a mesh with five numbers per vertex.
  void one_sphere_each() {
    constexpr std::size_t stride = 5;
    std::vector<std::uint32_t> indices(3 * stored_.group), list(stored_.group);
    std::iota(indices.rbegin(), indices.rend(), 0u);  // the last vertex first
    std::iota(list.begin(), list.end(), 0u);
    for (std::size_t first = 0; first + stored_.group <= stored_.size(); first += stored_.group) {
      Real sphere[4];
      for (std::size_t k = 0; k < 4; ++k) sphere[k] = stored_.column[9 + k][first];
      std::array<const Real*, 9> columns;
      for (std::size_t k = 0; k < 9; ++k) columns[k] = stored_.column[k].data() + first;
      std::vector<Real> vertices(3 * stride * stored_.group, Real(99));
      for (std::size_t i = 0; i < 3 * stored_.group; ++i) {
        for (std::size_t k = 0; k < 3; ++k) vertices[indices[i] * stride + k] = columns[3 * (i % 3) + k][i / 3];
      }
      const Mesh<Real> mesh{vertices.data(), stride, indices.data()};
      const axiscert_question question = questions[question_];
      const std::size_t size = stored_.group;
      const auto own = [](std::size_t i) { return i; };
      check(
          "triangles", first, size,
          [&](const axiscert_results& to) { return triangles(sphere, columns, size, question, to); }, own);
      check(
          "mesh_list", first, size,
          [&](const axiscert_results& to) { return mesh_list(sphere, mesh, list.data(), size, question, to); }, own);
      const std::size_t skipped = size < 8 ? 0 : 7;
      check(
          "mesh_range", first + skipped, size - skipped,
          [&](const axiscert_results& to) { return mesh_range(sphere, mesh, skipped, size - skipped, question, to); },
          [skipped](std::size_t i) { return skipped + i; });
    }
  }

  const StoredAnswers<Real>& stored_;
  const char* target_;
  Count& count_;
  int question_ = 0, mode_ = 0;
  std::vector<std::uint8_t> expected_, verdict_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> hits_;
};

template <class Real>
bool replay_section(const Header& header, std::FILE* file, const char* target, Count& count) {
  StoredAnswers<Real> stored;
  if (!read(header, file, stored)) return false;
  Replay<Real>(stored, target, count).run();
  return true;
}

// Replays the whole file on one instruction set; returns the exit status.
int replay(const char* path, const char* target) {
  std::FILE* file = std::fopen(path, "rb");
  if (!file) {
    std::perror(path);
    return 2;
  }
  Header header;
  Count count;
  bool whole = true;
  while (whole && std::fread(&header, sizeof header, 1, file) == 1) {
    whole = std::memcmp(header.format, answers_format, sizeof answers_format) == 0;
    if (!whole) break;
    whole = header.precision == 32 ? replay_section<float>(header, file, target, count)
                                   : replay_section<double>(header, file, target, count);
  }
  std::fclose(file);
  if (!whole || count.asked == 0) {
    std::printf("%s: is not a file of answers, or is cut short\n", path);
    return 2;
  }
  std::printf("%s: %llu answers, %llu wrong\n", target, static_cast<unsigned long long>(count.asked),
              static_cast<unsigned long long>(count.wrong));
  return count.wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace axiscert::certified

// The library chooses its instruction set once, so each has a process of its own.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: replay_answers FILE\n");
    return 2;
  }
  int worst = 0;
  for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      hwy::SetSupportedTargetsForTest(target);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      return axiscert::certified::replay(argv[1], hwy::TargetName(target));
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
      std::printf("%s: the process ended without an exit status\n", hwy::TargetName(target));
      worst = 2;
    } else {
      worst = std::max(worst, WEXITSTATUS(status));
    }
  }
  return worst;
}
