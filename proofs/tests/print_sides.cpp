// print_sides KERNEL PRECISION: reads the thirteen numbers of a query from each line of the standard input, as C
// hex-floats, in the order of input_names; prints on a line of the output, in the same form, the sixteen left and then
// the sixteen right sides that the kernel's scalar form computes. For the tests that evaluate the emitted programs
// independently.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"

namespace {

using namespace axiscert;

template <class Real>
void print_sides(const Kernel& kernel) {
  const auto explain = kernel.on<Real>(scalar_target).explain;
  if (!explain) throw Error("print_sides: " + kernel.id + " does not show its sides in this precision");
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    QueryColumns<Real> batch;
    std::array<Real, 13> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      std::string word;
      if (!(words >> word)) throw Error("print_sides: a line has to have 13 numbers: " + line);
      numbers[i] = static_cast<Real>(std::strtod(word.c_str(), nullptr));  // exact, because the tests write only
                                                                           // numbers of the precision
      batch.column[i] = &numbers[i];
    }
    batch.size = 1;
    batch.count = numbers.size();
    Answers<Real> answers;
    answers.resize(1, comparison_count);
    explain(batch, answers);
    for (const auto& sides : {answers.lhs, answers.rhs}) {
      for (const auto& side : sides) std::printf("%a ", static_cast<double>(side[0]));
    }
    std::puts("");
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw Error("usage: print_sides KERNEL PRECISION");
  const Kernel& kernel = find_kernel(argv[1]);
  if (argv[2] == name(Precision::binary32)) print_sides<float>(kernel);
  else if (argv[2] == name(Precision::binary64)) print_sides<double>(kernel);
  else throw Error("print_sides: PRECISION has to be binary32 or binary64, not " + std::string(argv[2]));
  return 0;
} catch (const axiscert::Error& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
