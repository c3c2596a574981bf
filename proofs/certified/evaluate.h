// A recorded step computed on the processor's own numbers, operation by operation.
#pragma once

#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "kernel/sphere_triangle/query.h"
#include "proofs/certified/graph.h"

namespace axiscert::proofs::certified {
template <class Real>
class EvaluatedStep {
 public:
  using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  using SignedWord = std::make_signed_t<Word>;

  explicit EvaluatedStep(const RecordedStep& step)
      : step_(step), numbers_(step.graph.nodes().size()), words_(numbers_.size()), flags_(numbers_.size()) {
    if (step.bits != 8 * sizeof(Real)) throw std::logic_error(step.name + " is recorded in another format");
  }
  // Computes the step of a query: ax ay az bx by bz cx cy cz px py pz r.
  void compute(std::span<const Real, 13> query);

  bool flag_at(Index node) const { return flags_[node] != 0; }
  Word word_at(Index node) const { return words_[node]; }

 private:
  const RecordedStep& step_;
  std::vector<Real> numbers_;
  std::vector<Word> words_;
  std::vector<unsigned char> flags_;
};

template <class Real>
void EvaluatedStep<Real>::compute(std::span<const Real, 13> query) {
  const auto& nodes = step_.graph.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    const auto x = [&](std::size_t k) { return numbers_[node.operands[k]]; };
    const auto w = [&](std::size_t k) { return words_[node.operands[k]]; };
    const auto f = [&](std::size_t k) { return flags_[node.operands[k]] != 0; };
    Real& number = numbers_[i];
    Word& word = words_[i];
    unsigned char& flag = flags_[i];
    switch (node.op) {
      case Op::input:
        number = query[i];
        break;
      case Op::constant:
        number = static_cast<Real>(node.number);
        break;
      case Op::negate:
        number = -x(0);
        break;
      case Op::magnitude:
        number = std::fabs(x(0));
        break;
      case Op::truncate:
        number = std::trunc(x(0));
        break;
      case Op::add:
        number = x(0) + x(1);
        break;
      case Op::subtract:
        number = x(0) - x(1);
        break;
      case Op::multiply:
        number = x(0) * x(1);
        break;
      case Op::divide:
        number = x(0) / x(1);
        break;
      case Op::least:
        number = x(0) < x(1) ? x(0) : x(1);
        break;
      case Op::greatest:
        number = x(0) > x(1) ? x(0) : x(1);
        break;
      case Op::with_sign:
        number = std::copysign(x(0), x(1));
        break;
      case Op::fused:
        number = std::fma(x(0), x(1), x(2));
        break;
      case Op::choose:
        number = f(0) ? x(1) : x(2);
        break;
      case Op::from_bits:
        number = std::bit_cast<Real>(w(0));
        break;
      case Op::from_integer:
        number = static_cast<Real>(static_cast<SignedWord>(w(0)));
        break;
      case Op::word_constant:
        word = static_cast<Word>(node.word);
        break;
      case Op::bits:
        word = std::bit_cast<Word>(x(0));
        break;
      case Op::to_integer: {  // what is too great gives the least integer, as on x86; no step uses it
        const Real limit = std::ldexp(Real{1}, static_cast<int>(8 * sizeof(Word)) - 1);
        word = std::fabs(x(0)) < limit ? static_cast<Word>(static_cast<SignedWord>(x(0)))
                                       : Word{1} << (8 * sizeof(Word) - 1);
        break;
      }
      case Op::all_ones:
        word = f(0) ? static_cast<Word>(~Word{0}) : Word{0};
        break;
      case Op::word_add:
        word = static_cast<Word>(w(0) + w(1));
        break;
      case Op::word_subtract:
        word = static_cast<Word>(w(0) - w(1));
        break;
      case Op::word_multiply:
        word = static_cast<Word>(w(0) * w(1));
        break;
      case Op::word_and:
        word = w(0) & w(1);
        break;
      case Op::word_or:
        word = w(0) | w(1);
        break;
      case Op::flag_constant:
        flag = node.word != 0;
        break;
      case Op::less:
        flag = x(0) < x(1);
        break;
      case Op::at_most:
        flag = x(0) <= x(1);
        break;
      case Op::equal:
        flag = x(0) == x(1);
        break;
      case Op::word_equal:
        flag = w(0) == w(1);
        break;
      case Op::word_less:
        flag = static_cast<SignedWord>(w(0)) < static_cast<SignedWord>(w(1));
        break;
      case Op::both:
        flag = f(0) && f(1);
        break;
      case Op::either:
        flag = f(0) || f(1);
        break;
      case Op::opposite:
        flag = !f(0);
        break;
    }
  }
}

// The answers of a recorded step to a query, as the step itself gives them.

struct StepAnswers {
  std::uint64_t bits = 0;                   // the flags among the results, in their order
  std::uint64_t known = 0, known_open = 0;  // the bits of Known, of the steps that tell them
  friend bool operator==(const StepAnswers&, const StepAnswers&) = default;
};

// The step has to outlive it.
template <class Real>
class RecordedAnswers {
 public:
  explicit RecordedAnswers(const RecordedStep& step) : evaluated_(step) {
    int bit = 0;
    for (const Result& result : step.results) {
      const Sort sort = info(step.graph.nodes()[result.node].op).sort;
      if (sort == Sort::flag) flags_.push_back({result.node, bit++});
      if (sort == Sort::word) (result.name == "known_open" ? known_open_ : known_) = result.node;
    }
  }
  StepAnswers operator()(const Query<Real>& q) {
    const auto v = coordinates(q);
    evaluated_.compute(std::span<const Real, 13>(v));
    StepAnswers answers;
    for (const auto& [node, bit] : flags_) answers.bits |= std::uint64_t{evaluated_.flag_at(node)} << bit;
    if (known_ != none) answers.known = evaluated_.word_at(known_);
    if (known_open_ != none) answers.known_open = evaluated_.word_at(known_open_);
    return answers;
  }

 private:
  static constexpr Index none = ~Index{0};
  struct Flag {
    Index node;
    int bit;
  };
  EvaluatedStep<Real> evaluated_;
  std::vector<Flag> flags_;
  Index known_ = none, known_open_ = none;
};

}  // namespace axiscert::proofs::certified
