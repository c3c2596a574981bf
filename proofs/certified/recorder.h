// The graph that is being recorded on this thread; lanes that are symbols have no other place to keep it.
#pragma once

#include "proofs/certified/graph.h"

namespace axiscert::proofs::certified {

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

// The flags of which a step asked whether they hold in all lanes, or in none, in the order of its questions.
inline thread_local std::vector<std::vector<Index>>* asked = nullptr;

}  // namespace axiscert::proofs::certified
