// What becomes of a block of queries: which step is asked about which, and how the answer is made of what they say.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace axiscert::proofs::certified {

// What a step said of a query.
struct BlockEvent {
  enum Kind { separated, contact, told, last } kind;
  int query;
  std::uint64_t known = 0;    // the bits told (exact_step.h), or those that the last step was given
  bool is_separated = false;  // the last step's answer
};
struct RecordedBlock {
  std::string name;
  int size;
  std::vector<int> invalid_queries;
  std::vector<BlockEvent> events;
  std::vector<std::uint64_t> contact, invalid;  // the answer's words
  std::string text;                             // what was asked, a vector a line
};
// Blocks of several sizes, shapes, formats and questions, each with a script of what the steps say.
std::vector<RecordedBlock> recorded_blocks();

// The query that a lane has: its number in the block; which of its vertices is first; and whether its numbers were
// scaled up or, for the conservative test, down.
struct LaneQuery {
  int query = 0, turn = 0, scale = 0;
  static LaneQuery padding() { return {.query = -1}; }
  bool is_padding() const { return query < 0; }
};

// Says for each step what it answers, and writes down what it is asked. What it says of a query follows from two bits
// for each of its axes, so that no two steps contradict each other.
class Script {
 public:
  enum Step { box, coarse, coarse_in_double, fine, conservative, conservative_scaled };
  struct Deep {
    bool holds, fails;
  };

  Script(std::uint64_t seed, int size, bool one_sphere, bool open, bool in_double)
      : is_wide(in_double), is_open_(open), one_sphere_(one_sphere), seed_(seed) {
    made_.size = size;
    for (int i = 0; i < size; ++i) {
      if (is_invalid(i)) made_.invalid_queries.push_back(i);
    }
  }

  // Number k of query i, which tells both.
  double number(int i, int k) const;
  // The query that has these numbers; throws where they are not one's.
  LaneQuery query_of(const double (&numbers)[13]) const;
  void check_sphere(double px, double py, double pz, double r) const;
  void check_sphere_kind(bool open) const;

  bool decides(Step step, const LaneQuery& q) const;
  bool is_separated(const LaneQuery& q) const { return (axes_with(q, 0) & axes_with(q, 1)) != 0; }
  std::uint64_t known(Step step, const LaneQuery& q) const;
  Deep deep(int group, int axis, const LaneQuery& q) const;
  // No query that is not valid, as the coarse step's recording says (in_deep_range).
  bool is_in_deep_range(const LaneQuery& q) const { return !is_invalid(q.query) && chance(q.query, 11) % 4 != 0; }
  bool is_surely_valid(const LaneQuery& q) const {
    return !is_invalid(q.query) && (q.scale != 0 || chance(q.query, 12) % 7 != 0);
  }
  bool is_in_fine_range(const LaneQuery& q) const { return q.scale != 0 || chance(q.query, 13) % 5 != 0; }
  bool can_be_scaled(const LaneQuery& q) const { return chance(q.query, 14) % 3 != 0; }

  template <class Lanes>
  void note_decided(Step step, const Lanes& lanes) {
    write(name_of(step), lanes);
    for (const LaneQuery& q : lanes) {
      if (q.is_padding() || !decides(step, q)) continue;
      made_.events.push_back({is_separated(q) ? BlockEvent::separated : BlockEvent::contact, q.query});
      made_.text += is_separated(q) ? " separated" : " contact";
    }
  }
  template <class Lanes>
  void note_told(Step step, const Lanes& lanes) {
    write(std::string(name_of(step)) + " tells", lanes);
    for (const LaneQuery& q : lanes) {
      if (!q.is_padding()) made_.events.push_back({BlockEvent::told, q.query, known(step, q)});
    }
  }
  template <class Lanes>
  void note_deep(int group, int first, const Lanes& lanes) {
    write(std::string("deep ") + (group == 8 ? "radius " : "sides ") + std::to_string(first), lanes);
    for (const LaneQuery& q : lanes) {
      if (q.is_padding()) continue;
      const Deep found = deep(group, first + q.turn, q);
      made_.events.push_back(
          {BlockEvent::told, q.query,
           std::uint64_t{found.holds} << (group + first + q.turn) | std::uint64_t{found.fails} << (first + q.turn)});
    }
  }
  bool last_step(const double (&numbers)[13], bool open, std::uint64_t known, int widest);

  RecordedBlock& made() { return made_; }

  const bool is_wide;  // binary64

 private:
  static std::string_view name_of(Step step);
  std::uint64_t chance(int query, std::uint64_t salt) const;
  bool is_invalid(int i) const { return !one_sphere_ && chance(i, 1) % 13 == 0; }
  // The axes whose radius comparison (0) or sides (1) hold.
  std::uint64_t axes_with(const LaneQuery& q, int what) const;
  template <class Lanes>
  void write(std::string_view what, const Lanes& lanes) {
    made_.text += "\n  " + std::string(what) + ":";
    for (const LaneQuery& q : lanes) write(q);
  }
  void write(const LaneQuery& q);

  RecordedBlock made_;
  bool is_open_, one_sphere_;
  std::uint64_t seed_;
};
inline thread_local Script* script = nullptr;

}  // namespace axiscert::proofs::certified
