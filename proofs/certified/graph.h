// The computation of a step of the certified predicate, operation by operation: a graph whose nodes are numbers of the
// step's format, words of as many bits, and flags.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace axiscert::proofs::certified {
enum class Sort : unsigned char { number, word, flag };

// X(name, sort of the result, number of operands)
#define AXISCERT_GRAPH_OPERATIONS(X)                                                     \
  X(input, number, 0)                                                                    \
  X(constant, number, 0)                                                                 \
  X(negate, number, 1)                                                                   \
  X(magnitude, number, 1)                                                                \
  X(truncate, number, 1)                                                                 \
  X(add, number, 2)                                                                      \
  X(subtract, number, 2)                                                                 \
  X(multiply, number, 2)                                                                 \
  X(divide, number, 2)                                                                   \
  X(least, number, 2)                                                                    \
  X(greatest, number, 2)                                                                 \
  X(with_sign, number, 2) /* the magnitude of the first, the sign of the second */       \
  X(fused, number, 3)     /* a b + c, rounded once */                                    \
  X(choose, number, 3)    /* a flag; the number where it holds, and where it does not */ \
  X(from_bits, number, 1)                                                                \
  X(from_integer, number, 1) /* of a signed word */                                      \
  X(word_constant, word, 0)                                                              \
  X(bits, word, 1)                                                                       \
  X(to_integer, word, 1) /* towards zero */                                              \
  X(all_ones, word, 1)   /* where a flag holds; else 0 */                                \
  X(word_add, word, 2)                                                                   \
  X(word_subtract, word, 2)                                                              \
  X(word_multiply, word, 2)                                                              \
  X(word_and, word, 2)                                                                   \
  X(word_or, word, 2)                                                                    \
  X(flag_constant, flag, 0)                                                              \
  X(less, flag, 2)                                                                       \
  X(at_most, flag, 2)                                                                    \
  X(equal, flag, 2)                                                                      \
  X(word_equal, flag, 2)                                                                 \
  X(word_less, flag, 2) /* of signed words */                                            \
  X(both, flag, 2)                                                                       \
  X(either, flag, 2)                                                                     \
  X(opposite, flag, 1)

enum class Op : unsigned char {
#define AXISCERT_NAME(name, sort, count) name,
  AXISCERT_GRAPH_OPERATIONS(AXISCERT_NAME)
#undef AXISCERT_NAME
};
struct OpInfo {
  std::string_view name;
  Sort sort;
  std::size_t operands;
};
inline constexpr auto op_list = std::to_array<OpInfo>({
#define AXISCERT_NAME(name, sort, count) {#name, Sort::sort, count},
    AXISCERT_GRAPH_OPERATIONS(AXISCERT_NAME)
#undef AXISCERT_NAME
});
constexpr const OpInfo& info(Op op) { return op_list[static_cast<std::size_t>(op)]; }

using Index = std::uint32_t;  // of a node

// The operands are earlier nodes.
struct Node {
  Op op;
  std::array<Index, 3> operands{};
  double number = 0;       // of a constant
  std::uint64_t word = 0;  // of a constant; of a flag's, 0 or 1
  std::string name{};      // of an input
};

class Graph {
 public:
  Index input(std::string name);
  Index number(double x);
  Index word(std::uint64_t x);
  Index flag(bool x);
  // The node of this operation, an existing one or a new one. Where a flag is combined with one that is known, or
  // constants are compared, the result is a node that exists.
  Index node(Op op, std::array<Index, 3> operands);

  const std::vector<Node>& nodes() const { return nodes_; }
  // Plants a fault: another node in place of this one.
  void replace(Index at, Node node) { nodes_.at(at) = std::move(node); }
  // The nodes on which the results depend, these included, in order.
  std::vector<Index> needed_by(const std::vector<Index>& results) const;

 private:
  using Key = std::tuple<Op, std::array<Index, 3>, std::uint64_t>;
  Index found_or_made(const Key& key, Node node);

  std::vector<Node> nodes_;
  std::map<Key, Index> made_;
};

struct Result {
  std::string name;
  Index node;
};

// What a step asked of all lanes together: whether each of these flags holds, or none.
struct AskedOfLanes {
  bool of_all;
  std::vector<Index> flags;
  bool operator==(const AskedOfLanes&) const = default;
};

// A step as recorded. Its inputs are ax ay az bx by bz cx cy cz px py pz r, in this order and before every other node.
struct RecordedStep {
  std::string name;  // coarse, pair, box, fine, deep_closed_vertex_radius, ...
  int bits;          // of the numbers: 32 or 64
  bool fused;        // whether the instruction set has fused multiply-add
  Graph graph;
  std::vector<Result> results;
  // What it asked before it went on, and the answers that it was given: no to each, so that the most is computed; and
  // the recordings with other answers.
  std::vector<AskedOfLanes> asked{};
  std::vector<bool> answers{};
  std::vector<RecordedStep> otherwise{};

  Index result(std::string_view of) const;  // throws std::out_of_range
};

inline constexpr std::array<std::string_view, 13> query_inputs = {"ax", "ay", "az", "bx", "by", "bz", "cx",
                                                                  "cy", "cz", "px", "py", "pz", "r"};

// What the exact step asks before it answers: the sign of a node, a bit of what is known (exact_step.h; fails, radius,
// sides) of an axis, or whether an axis separates.
struct Asked {
  enum Kind { positive, negative, zero, at_least_zero, at_most_zero, known, separates } kind;
  Index of;
  Index axis = 0;
  bool operator==(const Asked&) const = default;
};
// What is asked first, with what follows a yes and a no; or the answer.
struct AskedTree {
  std::optional<Asked> asked{};
  std::vector<AskedTree> after{};
  bool answer = false;
};
// Integers for numbers of `size` bits: the exponent of the negligible radius, and the words of values of degree 1, 2,
// 3, 4 and 6.
struct RecordedSize {
  int size, negligible;
  std::array<int, 5> words;
};

// The exact step's margins over integers: sums, differences and products. `degree` has that of each node, in the
// query's numbers; the exact step gives its values as many words as their degree needs.
struct RecordedExact {
  Graph graph;
  std::vector<Result> results;
  std::vector<int> degree;
  // Whether each axis separates, for the closed and the open sphere; whether some does.
  std::array<std::vector<AskedTree>, 2> axes;
  AskedTree verdict;
  // The answers of certain signs about each axis, if the others fail: whether it fails, its radius holds, its sides
  // hold.
  std::vector<std::vector<AskedTree>> told;
  // By the axes of the plane and the edges that fail, 8 times their bits, and the edges whose sides hold.
  std::vector<bool> needs_normal;
  std::vector<RecordedSize> sizes;
  std::vector<int> size_for;  // of each span, from 0 on
};
RecordedExact recorded_exact();

// Every step that computes with numbers of a format, in each format and with and without fused multiply-add.
std::vector<RecordedStep> recorded_steps();
// The step of the sphere's box, in each format, which is never fused: its ends, what it passes over, outcodes.
std::vector<RecordedStep> recorded_box();
// How queries of binary64 are scaled, with and without.
std::vector<RecordedStep> recorded_scaling();

// The graph that is being recorded on this thread; lanes that are symbols have no other place to keep it.

inline thread_local Graph* recorder = nullptr;

// A number that stands for a node where a step reads numbers from memory: a NaN whose last bits are the node's index.
template <class Real>
Real as_number(Index node);
// The node of a number: the one that it stands for, or a constant.
template <class Real>
Index node_of(Real x);

template <>
float as_number<float>(Index node);
template <>
double as_number<double>(Index node);
extern template Index node_of<float>(float x);
extern template Index node_of<double>(double x);

// What the step that is recorded asks of all lanes, and the answers that it is given; no, where there are no more.
inline thread_local std::vector<AskedOfLanes>* asked = nullptr;
inline thread_local const std::vector<bool>* answers = nullptr;
inline bool answer_to(AskedOfLanes question) {
  asked->push_back(std::move(question));
  return asked->size() <= answers->size() && (*answers)[asked->size() - 1];
}

}  // namespace axiscert::proofs::certified
